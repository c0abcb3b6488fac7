// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pupil_view.h
/// View from a film point through a lens of glass: its exit pupil, cut by the rims.
///
/// Directions are cosines (l, m) along the lens's horizontal and vertical axis; areas dl dm are projected solid angles (docs/optics.md,
/// "Through glass").

#ifndef TILT_LENS_PUPIL_VIEW_H
#define TILT_LENS_PUPIL_VIEW_H

#include <cmath>
#include <optional>

#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

/// Direction cosines.
template<class Number>
struct PupilPointOf
{
    Number l, m;
};

using PupilPoint = PupilPointOf<double>;

/// Ellipse around the passing directions; the radial axis points to the lens's axis.
struct PupilEllipse
{
    PupilPoint centre;
    double radial, tangential;
};

struct PupilView
{
    PupilEllipse bounds;
    double open = 0.0;   ///< area of passing directions
    double stop = 0.0;   ///< area without rims
};

/// From the axis to the film point; unit vector.
template<class Number>
TILT_LENS_INLINED PupilPointOf<Number> RadialAxis(const VecOf<Number>& film)
{
    const Number distance = SquareRoot(film.x * film.x + film.y * film.y), zero{}, one = zero + 1.0;
    return {distance > 0.0 ? film.x / distance : one, distance > 0.0 ? film.y / distance : zero};
}

/// To the centre of the paraxial exit pupil.
template<class Number>
TILT_LENS_INLINED PupilPointOf<Number> ParaxialAim(const CardinalPoints& points, const VecOf<Number>& film)
{
    if (!IsFinite(points.exitPupil))
        return {Number(), Number()};
    const VecOf<Number> way{-film.x, -film.y, points.exitPupil - film.z};
    const Number distance = SquareRoot(Dot(way, way)), length = way.z < 0.0 ? -distance : distance;  // away from a pupil behind the film
    return {way.x / length, way.y / length};
}

/// Squared cosine to the lens's axis; not positive: no direction.
template<class Number>
TILT_LENS_INLINED Number SquaredAlong(const PupilPointOf<Number>& direction)
{
    return 1.0 - direction.l * direction.l - direction.m * direction.m;
}

inline std::optional<GlassRay> RayTowards(const Vec3& film, const PupilPoint& direction)
{
    const double square = SquaredAlong(direction);
    if (!(square > 0.0))
        return {};
    return GlassRay{film, {direction.l, direction.m, std::sqrt(square)}};
}

/// @param film  mm, lens frame
/// @param near  tried first: passes at a neighbouring film point
/// @return      none if no ray passes
std::optional<PupilView> ViewOf(const GlassLens& lens, const Vec3& film, const std::optional<PupilPoint>& near);

} // namespace tilt_lens

#endif
