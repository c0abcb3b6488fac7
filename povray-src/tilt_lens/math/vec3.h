// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file vec3.h
/// Frame and unit stand at a vector's declaration. The solver uses a number type longer than double.

#ifndef TILT_LENS_VEC3_H
#define TILT_LENS_VEC3_H

#include <cmath>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

template<typename Number>
struct VecOf
{
    using Scalar = Number;

    Number x{}, y{}, z{};
};

/// Prevents deduction from a factor: the vector decides the type.
template<typename Number>
using ScalarOf = typename VecOf<Number>::Scalar;

using Vec3 = VecOf<double>;

template<typename N>
TILT_LENS_INLINED VecOf<N> operator+(const VecOf<N>& a, const VecOf<N>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template<typename N>
TILT_LENS_INLINED VecOf<N> operator-(const VecOf<N>& a, const VecOf<N>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template<typename N>
TILT_LENS_INLINED VecOf<N> operator-(const VecOf<N>& a)
{
    return {-a.x, -a.y, -a.z};
}
template<typename N>
TILT_LENS_INLINED VecOf<N> operator*(const VecOf<N>& a, const ScalarOf<N>& s)
{
    return {a.x * s, a.y * s, a.z * s};
}
template<typename N>
TILT_LENS_INLINED VecOf<N> operator*(const ScalarOf<N>& s, const VecOf<N>& a)
{
    return a * s;
}
template<typename N>
TILT_LENS_INLINED VecOf<N> operator/(const VecOf<N>& a, const ScalarOf<N>& s)
{
    return {a.x / s, a.y / s, a.z / s};
}

template<typename N>
TILT_LENS_INLINED N Dot(const VecOf<N>& a, const VecOf<N>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template<typename N>
inline VecOf<N> Cross(const VecOf<N>& a, const VecOf<N>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// @name Vectors in separate arrays of x, y and z.
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

/// Without overflow or underflow: scenes span 1e-9 to 1e12 units.
inline double Length(const Vec3& a)
{
    const double squared = Dot(a, a);
    return squared > 1e-200 && squared < 1e200 ? std::sqrt(squared) : std::hypot(a.x, a.y, a.z);
}

/// For number types with exponents far beyond double's.
template<typename N>
inline N Length(const VecOf<N>& a)
{
    return sqrt(Dot(a, a));
}

template<typename N>
inline VecOf<N> Normalized(const VecOf<N>& a)
{
    return a / Length(a);
}

inline bool IsFinite(const Vec3& a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

} // namespace tilt_lens

#endif
