// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_NUMBERS_H
#define TILT_LENS_NUMBERS_H

#include <algorithm>
#include <cfloat>
#include <cstdio>
#include <string>

namespace tilt_lens
{

inline constexpr double kPi = 3.14159265358979323846;

/// Largest relative rounding error of a difference that ought to be 0.
inline constexpr double kRounding = 1e-14;

inline float FiniteFloat(double value)
{
    return float(std::min<double>(value, FLT_MAX));
}

inline std::string Number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", value + 0.0);  // never -0
    return text;
}

} // namespace tilt_lens

#endif
