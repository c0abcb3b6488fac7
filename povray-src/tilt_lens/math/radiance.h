// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_RADIANCE_H
#define TILT_LENS_RADIANCE_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

/// Red, green, blue, filter, transmit; linear, 1 is white.
using Radiance = std::array<double, 5>;

inline double Square(double x)
{
    return x * x;
}

/// Two channels at a time, which compilers cannot do, since arguments may overlap.
template<class Operation>
inline void Combine(Radiance& result, const Radiance& value, const Operation& operation)
{
    std::size_t c = 0;
    for (; c + 2 <= result.size(); c += 2)
        Store(&result[c], operation(Load<Double2>(&result[c]), Load<Double2>(&value[c])));
    for (; c < result.size(); c++)
        result[c] = operation(result[c], value[c]);
}

inline void AddTo(double& sum, double value)
{
    sum += value;
}
inline void ScaleBy(double& value, double factor)
{
    value *= factor;
}

inline void AddTo(Radiance& sum, const Radiance& value)
{
    Combine(sum, value, [](const auto& a, const auto& b) { return a + b; });
}

inline void ScaleBy(Radiance& value, double factor)
{
    for (double& channel : value)
        channel *= factor;
}

inline bool IsFinite(const Radiance& value)
{
    return std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
}

inline bool IsNonZero(const Radiance& value)
{
    bool nonZero = false;
    for (const double x : value)
        nonZero |= x != 0.0;
    return nonZero;
}

inline double MeanColour(const Radiance& value)
{
    return (value[0] + value[1] + value[2]) / 3.0;
}

/// @param value  without negative channels
inline double LargestChannel(const Radiance& value)
{
    double largest = 0.0;
    for (const double x : value)
        largest = std::max(largest, x);
    return largest;
}

/// Divisor that makes a variance relative: 1 up to white, the squared mean above, as eyes see errors.
inline double SquaredScale(double mean)
{
    return mean > 1.0 ? mean * mean : 1.0;
}

inline Radiance RelativeTo(const Radiance& mean, Radiance variance)
{
    for (std::size_t c = 0; c < variance.size(); c++)
        variance[c] /= SquaredScale(mean[c]);
    return variance;
}

} // namespace tilt_lens

#endif
