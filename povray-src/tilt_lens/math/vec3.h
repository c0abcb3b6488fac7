// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file vec3.h
/// Three numbers and the few operations a camera needs. The library has its own so that it builds
/// and is tested without any POV-Ray header; the frame and the unit of a vector stand where it is
/// declared. Rays use doubles; the solver, which runs once a camera, uses a longer type.

#ifndef TILT_LENS_VEC3_H
#define TILT_LENS_VEC3_H

#include <cmath>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

template <typename Number>
struct VecOf
{
    using Scalar = Number;

    Number x{}, y{}, z{};
};

/// A factor: it takes any number that converts, since the vector alone decides the type.
template <typename Number>
using ScalarOf = typename VecOf<Number>::Scalar;

using Vec3 = VecOf<double>;

template <typename N>
TILT_LENS_INLINED VecOf<N> operator+(const VecOf<N>& a, const VecOf<N>& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
template <typename N>
TILT_LENS_INLINED VecOf<N> operator-(const VecOf<N>& a, const VecOf<N>& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
template <typename N>
TILT_LENS_INLINED VecOf<N> operator-(const VecOf<N>& a) { return {-a.x, -a.y, -a.z}; }
template <typename N>
TILT_LENS_INLINED VecOf<N> operator*(const VecOf<N>& a, const ScalarOf<N>& s) { return {a.x * s, a.y * s, a.z * s}; }
template <typename N>
TILT_LENS_INLINED VecOf<N> operator*(const ScalarOf<N>& s, const VecOf<N>& a) { return a * s; }
template <typename N>
TILT_LENS_INLINED VecOf<N> operator/(const VecOf<N>& a, const ScalarOf<N>& s) { return {a.x / s, a.y / s, a.z / s}; }

template <typename N>
TILT_LENS_INLINED N Dot(const VecOf<N>& a, const VecOf<N>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

template <typename N>
inline VecOf<N> Cross(const VecOf<N>& a, const VecOf<N>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// @name Vectors side by side, from and to the place of the first in arrays of their x, y and z.
/// @{
template<class Vector, std::size_t size>
TILT_LENS_INLINED VecOf<Vector> LoadVectors(const double (&from)[3][size], std::size_t first)
{
    return {Load<Vector>(from[0] + first), Load<Vector>(from[1] + first), Load<Vector>(from[2] + first)};
}

template<class Vector, std::size_t size>
TILT_LENS_INLINED void StoreVectors(double (&to)[3][size], std::size_t first, const VecOf<Vector>& vectors)
{
    Store(to[0] + first, vectors.x);
    Store(to[1] + first, vectors.y);
    Store(to[2] + first, vectors.z);
}
/// @}

/// Length without overflow or underflow: scenes span 1e-9 to 1e12 units.
inline double Length(const Vec3& a)
{
    const double squared = Dot(a, a);
    return squared > 1e-200 && squared < 1e200 ? std::sqrt(squared) : std::hypot(a.x, a.y, a.z);
}

/// The same for a type whose exponents reach far beyond those of the doubles that it holds.
template <typename N>
inline N Length(const VecOf<N>& a) { return sqrt(Dot(a, a)); }

template <typename N>
inline VecOf<N> Normalized(const VecOf<N>& a) { return a / Length(a); }

inline bool IsFinite(const Vec3& a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace tilt_lens

#endif
