// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_points.h
/// Four dimensions of Sobol's sequence (Joe and Kuo). Owen scrambling makes batches independent and unbiased.

#ifndef WITNESS_LENS_POINTS_H
#define WITNESS_LENS_POINTS_H

#include <cstdint>
#include <vector>

namespace witness
{

struct LensPoint
{
    double jitterX, jitterY;  ///< pixels, -0.5 to 0.5
    double a, b;              ///< disc of radius 1 or the polygon in it
};

/// @param blades       0: disc; else corners of the polygon
/// @param bladesAngle  degrees, counter-clockwise; 0: a corner points right
std::vector<LensPoint> LensPoints(std::uint32_t count, std::uint32_t seed, int blades, double bladesAngle);

} // namespace witness

#endif
