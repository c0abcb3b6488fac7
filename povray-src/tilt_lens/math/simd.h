// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file simd.h
/// Vector registers of 16 and 32 bytes: their types, and numbers that lie side by side to and from them. Memory needs no alignment.
///
/// What is worth it is written once, as a function that is always inlined, and compiled twice: for every processor, and for those
/// with AVX2, whose registers hold twice as much. No operation is contracted, so that both have the same results. A function
/// that takes or returns a register of 32 bytes must be inlined, since the two pass it differently.

#ifndef TILT_LENS_SIMD_H
#define TILT_LENS_SIMD_H

#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace tilt_lens
{

/// Lanes compare to masks: `a < b ? a : b` chooses lane by lane.
typedef double Double2 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float2 __attribute__((vector_size(8)));  ///< what converts to a Double2
typedef decltype(Double2() < Double2()) Mask2;
typedef int Mask4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef int Mask8 __attribute__((vector_size(32)));
typedef decltype(Double4() < Double4()) LongMask4;

/// How many numbers lie side by side in it.
template<class Vector>
constexpr std::size_t kVectorWidth = sizeof(Vector) / sizeof(std::declval<Vector&>()[0]);

/// Of functions that are called where HasAvx2() only. What they inline is compiled for AVX2, too, without contracted operations.
#if defined(__x86_64__) || defined(__i386__)
#define TILT_LENS_FOR_AVX2 __attribute__((target("avx2,bmi")))
#else
#define TILT_LENS_FOR_AVX2
#endif

/// Of functions that are written once and compiled for each kind of processor, with the function that calls them.
#define TILT_LENS_INLINED inline __attribute__((always_inline))
#define TILT_LENS_INLINED_LAMBDA __attribute__((always_inline))

/// Two instructions: what the processor can do was stored when the program began.
inline bool HasAvx2()
{
#if defined(__x86_64__) || defined(__i386__)
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi");
#else
    return false;
#endif
}

/// @param from  as many numbers as a Vector holds, which may be a single number
template<class Vector, class Number>
TILT_LENS_INLINED Vector Load(const Number* from)
{
    if constexpr (std::is_same_v<Vector, Number>)
        return *from;
    Vector vector;
    std::memcpy(&vector, from, sizeof(vector));
    return vector;
}

template<class Vector, class Number>
TILT_LENS_INLINED void Store(Number* to, const Vector& vector)
{
    if constexpr (std::is_same_v<Vector, Number>)
        *to = vector;
    else
        std::memcpy(to, &vector, sizeof(vector));
}

/// What a comparison of numbers or of vectors gives: bool, or a mask with all bits set in the lanes where it holds.
template<class Number>
using MaskOf = decltype(std::declval<Number>() < std::declval<Number>());

/// @name Lane by lane, or of two numbers; b where either is no number.
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

template<class Vector>
TILT_LENS_INLINED Vector SquareRoot(Vector value)
{
    for (std::size_t lane = 0; lane < kVectorWidth<Vector>; lane++)
        value[lane] = std::sqrt(value[lane]);
    return value;
}

inline double SquareRoot(double value) { return std::sqrt(value); }

/// One bit for each lane: what processors without an instruction for it do.
template<class Mask>
TILT_LENS_INLINED unsigned int SignBitsOneByOne(const Mask& mask)
{
    unsigned int bits = 0;
    for (std::size_t i = 0; i < kVectorWidth<Mask>; i++)
        bits |= (mask[i] < 0 ? 1u : 0u) << i;
    return bits;
}

/// @name One bit for each lane.
/// @{
TILT_LENS_INLINED unsigned int SignBits(const Mask4& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskps(reinterpret_cast<const Float4&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}

TILT_LENS_FOR_AVX2 inline unsigned int SignBits(const Mask8& mask)
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

TILT_LENS_FOR_AVX2 inline unsigned int SignBits(const LongMask4& mask)
{
#ifdef __SSE2__
    return __builtin_ia32_movmskpd256(reinterpret_cast<const Double4&>(mask));
#else
    return SignBitsOneByOne(mask);
#endif
}
/// @}

/// Whether a comparison of 16 or 32 bytes holds in all lanes.
template<class Mask>
TILT_LENS_INLINED bool All(const Mask& mask)
{
    if constexpr (sizeof(Mask) == sizeof(Mask8))
        return SignBits((Mask8)mask) == 0xff;  // the same bits
    else
        return SignBits((Mask4)mask) == 0xf;
}

} // namespace tilt_lens

#endif
