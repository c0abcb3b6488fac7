// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file simd.h
/// Vector registers of 16 and 32 bytes: their types, and numbers that lie side by side to and from them. Memory needs no alignment.

#ifndef TILT_LENS_SIMD_H
#define TILT_LENS_SIMD_H

#include <cstring>

namespace tilt_lens
{

/// Lanes compare to masks: `a < b ? a : b` chooses lane by lane.
typedef double Double2 __attribute__((vector_size(16)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float2 __attribute__((vector_size(8)));  ///< what converts to a Double2
typedef long long Mask2 __attribute__((vector_size(16)));
typedef int Mask4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef int Mask8 __attribute__((vector_size(32)));
typedef double Double4 __attribute__((vector_size(32)));
typedef double UnalignedDouble4 __attribute__((vector_size(32), aligned(8), may_alias));  ///< four numbers of an array
typedef long long LongMask4 __attribute__((vector_size(32)));

/// Of functions that are called where HasAvx2() only. What they inline is compiled for AVX2, too, without contracted operations.
#if defined(__x86_64__) || defined(__i386__)
#define TILT_LENS_FOR_AVX2 __attribute__((target("avx2,bmi")))
#else
#define TILT_LENS_FOR_AVX2
#endif

/// Of inline functions that are written once and compiled for each kind of processor, with the function that calls them.
#define TILT_LENS_ALWAYS_INLINE __attribute__((always_inline))

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
Vector Load(const Number* from)
{
    Vector vector;
    std::memcpy(&vector, from, sizeof(vector));
    return vector;
}

template<class Vector, class Number>
void Store(Number* to, Vector vector)
{
    std::memcpy(to, &vector, sizeof(vector));
}

/// Lane by lane; b where either is no number.
inline Float4 Min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 Max(Float4 a, Float4 b) { return a > b ? a : b; }

} // namespace tilt_lens

#endif
