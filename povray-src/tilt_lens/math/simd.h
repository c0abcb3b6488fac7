// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file simd.h
/// Vector registers of 16 and 32 bytes. Memory needs no alignment.
///
/// Both variants of a function (kernels.h) give the same results to the last bit: multiplications and additions are never contracted. They
/// pass 32-byte registers differently, so a function that takes or returns one must be inlined.

#ifndef TILT_LENS_SIMD_H
#define TILT_LENS_SIMD_H

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace tilt_lens
{

/// Comparisons yield masks: `a < b ? a : b` chooses lane by lane.
typedef double Double2 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float2 __attribute__((vector_size(8)));  ///< converts to Double2
typedef decltype(Double2() < Double2()) Mask2;
typedef int Mask4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef int Mask8 __attribute__((vector_size(32)));
typedef decltype(Double4() < Double4()) LongMask4;

template<class Vector>
constexpr std::size_t kVectorWidth = sizeof(Vector) / sizeof(std::declval<Vector&>()[0]);

/// Call only if HasAvx2(). Functions inlined into it are compiled for AVX2 too.
#if defined(__x86_64__) || defined(__i386__)
#define TILT_LENS_FOR_AVX2 __attribute__((target("avx2,bmi")))
#else
#define TILT_LENS_FOR_AVX2
#endif

#define TILT_LENS_INLINED inline __attribute__((always_inline))
#define TILT_LENS_INLINED_LAMBDA __attribute__((always_inline))

/// Inlined in files compiled for AVX2 as a whole; elsewhere the compiler could not.
#ifdef __AVX2__
#define TILT_LENS_INLINED_FOR_AVX2 TILT_LENS_INLINED
#else
#define TILT_LENS_INLINED_FOR_AVX2 TILT_LENS_FOR_AVX2 inline
#endif

inline bool HasAvx2()
{
#if defined(__x86_64__) || defined(__i386__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi");
#else
    return false;
#endif
}

// std::memcpy is a call where a distribution's compiler checks it at run time (_FORTIFY_SOURCE).
template<class Vector, class Number>
TILT_LENS_INLINED Vector Load(const Number* from)
{
    if constexpr (std::is_same_v<Vector, Number>)
        return *from;
    Vector vector;
    __builtin_memcpy(&vector, from, sizeof(vector));
    return vector;
}

template<class Vector, class Number>
TILT_LENS_INLINED void Store(Number* to, const Vector& vector)
{
    if constexpr (std::is_same_v<Vector, Number>)
        *to = vector;
    else
        __builtin_memcpy(to, &vector, sizeof(vector));
}

/// bool for numbers, a mask for registers.
template<class Number>
using MaskOf = decltype(std::declval<Number>() < std::declval<Number>());

/// @name Lane by lane; b if either is NaN.
/// @{
template<class Vector>
TILT_LENS_INLINED Vector Min(const Vector& a, const Vector& b)
{
    return a < b ? a : b;
}

template<class Vector>
TILT_LENS_INLINED Vector Max(const Vector& a, const Vector& b)
{
    return a > b ? a : b;
}
/// @}

template<class Number>
TILT_LENS_INLINED Number Clamp(const Number& value, const Number& least, const Number& most)
{
    return value < least ? least : most < value ? most : value;
}

/// @name Always inlined (kernels/variant.h).
/// @{
TILT_LENS_INLINED float SquareRoot(float value)
{
    return __builtin_sqrtf(value);
}
TILT_LENS_INLINED double SquareRoot(double value)
{
    return __builtin_sqrt(value);
}
TILT_LENS_INLINED bool IsFinite(float value)
{
    return __builtin_isfinite(value);
}
TILT_LENS_INLINED bool IsFinite(double value)
{
    return __builtin_isfinite(value);
}
/// @}

template<class Vector>
TILT_LENS_INLINED Vector SquareRoot(Vector value)
{
    for (std::size_t lane = 0; lane < kVectorWidth<Vector>; lane++)
        value[lane] = SquareRoot(value[lane]);
    return value;
}

template<class Mask>
TILT_LENS_INLINED unsigned int SignBitsOneByOne(const Mask& mask)
{
    unsigned int bits = 0;
    for (std::size_t i = 0; i < kVectorWidth<Mask>; i++)
        bits |= (mask[i] < 0 ? 1u : 0u) << i;
    return bits;
}

/// @name One bit per lane.
/// @{
TILT_LENS_INLINED unsigned int SignBits(const Mask4& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskps(reinterpret_cast<const Float4&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}

TILT_LENS_INLINED_FOR_AVX2 unsigned int SignBits(const Mask8& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskps256(reinterpret_cast<const Float8&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}

TILT_LENS_INLINED unsigned int SignBits(const Mask2& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskpd(reinterpret_cast<const Double2&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}

TILT_LENS_INLINED_FOR_AVX2 unsigned int SignBits(const LongMask4& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskpd256(reinterpret_cast<const Double4&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}
/// @}

template<class Mask>
TILT_LENS_INLINED bool All(const Mask& mask)
{
    if constexpr (sizeof(Mask) == sizeof(Mask8))
        return SignBits((Mask8)mask) == 0xff;
    else
        return SignBits((Mask4)mask) == 0xf;
}

} // namespace tilt_lens

#endif
