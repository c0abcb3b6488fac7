// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef WITNESS_VECTOR_H
#define WITNESS_VECTOR_H

#include <cmath>

namespace witness
{

struct Vector
{
    double x = 0.0, y = 0.0, z = 0.0;
};

inline Vector operator+(const Vector& a, const Vector& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vector operator-(const Vector& a, const Vector& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vector operator*(double s, const Vector& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
inline double Dot(const Vector& a, const Vector& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vector Cross(const Vector& a, const Vector& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(const Vector& a)
{
    return std::sqrt(Dot(a, a));
}
inline Vector Unit(const Vector& a)
{
    return (1.0 / Length(a)) * a;
}

} // namespace witness

#endif
