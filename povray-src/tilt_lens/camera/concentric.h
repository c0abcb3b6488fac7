// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file concentric.h
/// Concentric map from the unit square to the disc, of numbers or registers.

#ifndef TILT_LENS_CONCENTRIC_H
#define TILT_LENS_CONCENTRIC_H

#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

/// Taylor series for |x| <= pi/4 with an error below 3e-14, faster than the C library's and equal on every machine.
/// @{
template<class Number>
TILT_LENS_INLINED Number SmallSin(const Number& x)
{
    const Number s = x * x;
    return x * (1.0 +
                s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * (-1.0 / 39916800 + s * (1.0 / 6227020800)))))));
}

template<class Number>
TILT_LENS_INLINED Number SmallCos(const Number& x)
{
    const Number s = x * x;
    return 1.0 + s * (-1.0 / 2 +
                      s * (1.0 / 24 +
                           s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800 + s * (1.0 / 479001600 + s * (-1.0 / 87178291200)))))));
}
/// @}

/// Concentric squares become concentric circles. The square's diagonals divide it into quarters.
template<class Number>
struct Concentric
{
    decltype(Number() > Number()) sideways;
    Number radius;  ///< signed as the quarter's main coordinate
    Number slope;   ///< 4/pi times the angle from the quarter's axis to the other axis
};

template<class Number>
TILT_LENS_INLINED Concentric<Number> ToConcentric(const Number& u, const Number& v)
{
    const Number x = 2.0 * u - 1.0, y = 2.0 * v - 1.0, one = Number() + 1.0;
    const auto sideways = (x < 0.0 ? -x : x) > (y < 0.0 ? -y : y);
    const Number main = sideways ? x : y, other = sideways ? y : x;
    return {sideways, main, other / (main != 0.0 ? main : one)};
}

template<class Number>
TILT_LENS_INLINED void OnDisc(const Number& u, const Number& v, Number& a, Number& b)
{
    const Concentric<Number> c = ToConcentric(u, v);
    constexpr double quarterPi = kPi / 4;
    const Number angle = quarterPi * c.slope;
    const Number along = c.radius * SmallCos(angle), across = c.radius * SmallSin(angle);
    a = c.sideways ? along : across;
    b = c.sideways ? across : along;
}

/// Inverse of OnDisc().
inline void FromDisc(double a, double b, double& u, double& v)
{
    constexpr double quarterPi = kPi / 4;
    const bool sideways = std::fabs(a) > std::fabs(b);
    const double main = sideways ? a : b, other = sideways ? b : a, radius = std::copysign(std::hypot(a, b), main);
    const double across = main != 0.0 ? radius * std::atan(other / main) / quarterPi : 0.0;
    u = 0.5 * (1.0 + (sideways ? radius : across));
    v = 0.5 * (1.0 + (sideways ? across : radius));
}

/// @param position  number of edges from the first corner
/// @param radius    0 at the centre, 1 on the edge
template<class Number>
TILT_LENS_INLINED void FindPosition(const Number& u, const Number& v, double edges, Number& position, Number& radius)
{
    const Concentric<Number> c = ToConcentric(u, v);
    Number turns = c.sideways ? c.slope / 8.0 : 0.25 - c.slope / 8.0;
    turns = c.radius < 0.0 ? turns + 0.5 : turns;
    turns = turns < 0.0 ? turns + 1.0 : turns;
    position = turns * edges;
    radius = c.radius < 0.0 ? -c.radius : c.radius;
}

} // namespace tilt_lens

#endif
