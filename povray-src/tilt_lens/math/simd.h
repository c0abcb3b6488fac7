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

#include <cstring>

namespace tilt_lens
{

/// Lanes compare to masks: `a < b ? a : b` chooses lane by lane.
typedef double Double2 __attribute__((vector_size(16)));
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float4 __attribute__((vector_size(16)));
typedef float Float2 __attribute__((vector_size(8)));  ///< what converts to a Double2
typedef long long Mask2 __attribute__((vector_size(16)));
typedef int Mask4 __attribute__((vector_size(16)));
typedef float Float8 __attribute__((vector_size(32)));
typedef int Mask8 __attribute__((vector_size(32)));

#define TILT_LENS_INLINED inline __attribute__((always_inline))

/// @param from  as many numbers as a Vector holds, which may be a single number
template<class Vector, class Number>
TILT_LENS_INLINED Vector Load(const Number* from)
{
    Vector vector;
    std::memcpy(&vector, from, sizeof(vector));
    return vector;
}

template<class Vector, class Number>
TILT_LENS_INLINED void Store(Number* to, const Vector& vector)
{
    std::memcpy(to, &vector, sizeof(vector));
}

/// Lane by lane; b where either is no number.
inline Float4 Min(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 Max(Float4 a, Float4 b) { return a > b ? a : b; }

#if defined(__x86_64__) || defined(__i386__)
#define TILT_LENS_FOR_AVX2 __attribute__((target("avx2")))
inline bool HasAvx2() { return __builtin_cpu_supports("avx2"); }
#else
#define TILT_LENS_FOR_AVX2
inline bool HasAvx2() { return false; }
#endif

} // namespace tilt_lens

#endif
