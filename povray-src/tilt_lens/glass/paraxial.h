// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file paraxial.h
/// Paraxial rays.

#ifndef TILT_LENS_PARAXIAL_H
#define TILT_LENS_PARAXIAL_H

#include <cstddef>
#include <vector>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// From scene to film: height, and slope times index.
struct ParaxialRay
{
    double height = 0.0, reduced = 0.0;
};

/// Ray transfer matrix, with determinant 1.
struct ParaxialMap
{
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0;

    ParaxialRay operator()(const ParaxialRay& ray) const { return {a * ray.height + b * ray.reduced, c * ray.height + d * ray.reduced}; }
};

inline ParaxialMap operator*(const ParaxialMap& second, const ParaxialMap& first)
{
    return {second.a * first.a + second.b * first.c, second.a * first.b + second.b * first.d, second.c * first.a + second.d * first.c,
            second.c * first.b + second.d * first.d};
}

/// From before row `first` to before row `last`, or behind the last surface.
inline ParaxialMap MapBetween(const Prescription& prescription, std::size_t first, std::size_t last)
{
    ParaxialMap map;
    for (std::size_t i = first; i < last; i++)
    {
        const PrescriptionRow& row = prescription.rows[i];
        const double before = i > 0 ? prescription.rows[i - 1].index : 1.0;
        const double curvature = row.radius == 0.0 ? 0.0 : 1.0 / row.radius;
        map = ParaxialMap{1.0, 0.0, -(row.index - before) * curvature, 1.0} * map;
        if (i + 1 < prescription.rows.size())
            map = ParaxialMap{1.0, row.thickness / row.index, 0.0, 1.0} * map;
    }
    return map;
}

} // namespace tilt_lens

#endif
