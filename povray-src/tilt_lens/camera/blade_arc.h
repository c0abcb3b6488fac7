// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file blade_arc.h
/// Curved edge of a diaphragm blade, as chords.

#ifndef TILT_LENS_BLADE_ARC_H
#define TILT_LENS_BLADE_ARC_H

#include <cmath>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

inline double Cross(const AperturePoint& p, const AperturePoint& q)
{
    return p.a * q.b - p.b * q.a;
}

/// Chords between the corners at 0 and 2 pi/blades. Each spans a triangle of equal area with the origin.
inline std::vector<AperturePoint> Arc(int blades, double curvature, int chords)
{
    const double half = std::sin(kPi / blades), middle = std::cos(kPi / blades);
    const double spread = std::asin(curvature * half);
    const auto at = [&](double t) -> AperturePoint
    {
        if (spread < 1e-8)
            return {middle, half * t};
        const double radius = 1 / curvature;
        // cos(spread t) - cos(spread), without cancellation
        const double bulge = 2 * std::sin(spread * (1 + t) / 2) * std::sin(spread * (1 - t) / 2);
        return {middle + radius * bulge, radius * std::sin(spread * t)};
    };

    std::vector<double> place(chords + 1), sum(chords + 1), moved(chords + 1);
    for (int i = 0; i <= chords; ++i)
        place[i] = 2.0 * i / chords - 1;
    // each pass moves the points closer to equal steps of area
    for (int pass = 0; pass < 20; ++pass)
    {
        for (int i = 0; i < chords; ++i)
            sum[i + 1] = sum[i] + Cross(at(place[i]), at(place[i + 1]));
        moved = place;
        for (int i = 1, from = 0; i < chords; ++i)
        {
            const double wanted = sum[chords] * i / chords;
            while (sum[from + 1] < wanted)
                ++from;
            moved[i] = place[from] + (place[from + 1] - place[from]) * (wanted - sum[from]) / (sum[from + 1] - sum[from]);
        }
        place = moved;
    }

    std::vector<AperturePoint> points;
    for (const double t : place)
    {
        const AperturePoint p = at(t);
        points.push_back({p.a * middle - p.b * half, p.a * half + p.b * middle});
    }
    return points;
}

} // namespace tilt_lens

#endif
