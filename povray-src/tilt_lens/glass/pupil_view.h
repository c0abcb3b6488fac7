// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pupil_view.h
/// The directions in which a film point sees the scene through a lens of glass: its exit pupil, with what the rims cut off.
///
/// A direction is given by its cosines (l, m) along the lens's horizontal and vertical axis. An area of these is the projected
/// solid angle dl dm = cos(angle to the axis) dw, in which the light of an evenly bright scene arrives evenly; and a lens
/// without coma maps it to an area of its entrance pupil, which is what the samples of an ideal lens are even in.

#ifndef TILT_LENS_PUPIL_VIEW_H
#define TILT_LENS_PUPIL_VIEW_H

#include <cmath>
#include <optional>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

/// Direction cosines along the lens's two axes: of one direction, or of some side by side.
template<class Number>
struct PupilPointOf
{
    Number l, m;
};

using PupilPoint = PupilPointOf<double>;

/// An ellipse of directions around those that pass. Its axes lie towards the lens's axis and across that.
struct PupilEllipse
{
    PupilPoint centre;
    double radial, tangential;  ///< semi-axes
};

/// What a film point sees.
struct PupilView
{
    PupilEllipse bounds;
    double open = 0.0;   ///< area of the directions that pass
    double stop = 0.0;   ///< the same without rims
};

/// Towards the film point's place beside the axis: the unit vector that the ellipse's radial axis has.
template<class Number>
TILT_LENS_INLINED PupilPointOf<Number> RadialAxis(const VecOf<Number>& film)
{
    const Number distance = SquareRoot(film.x * film.x + film.y * film.y), zero{}, one = zero + 1.0;
    return {distance > 0.0 ? film.x / distance : one, distance > 0.0 ? film.y / distance : zero};
}

/// Towards the middle of the paraxial exit pupil.
template<class Number>
TILT_LENS_INLINED PupilPointOf<Number> ParaxialAim(const CardinalPoints& points, const VecOf<Number>& film)
{
    if (!std::isfinite(points.exitPupil))
        return {Number(), Number()};
    const VecOf<Number> way{-film.x, -film.y, points.exitPupil - film.z};
    const Number distance = SquareRoot(Dot(way, way)), length = way.z < 0.0 ? -distance : distance;  // away from a pupil behind the film
    return {way.x / length, way.y / length};
}

/// Of a direction with these cosines: the squared one along the lens's axis; none has them where this is not above 0.
template<class Number>
TILT_LENS_INLINED Number SquaredAlong(const PupilPointOf<Number>& direction)
{
    return 1.0 - direction.l * direction.l - direction.m * direction.m;
}

/// A ray from a film point; nothing for cosines that no direction has.
inline std::optional<GlassRay> RayTowards(const Vec3& film, const PupilPoint& direction)
{
    const double square = SquaredAlong(direction);
    if (!(square > 0.0))
        return {};
    return GlassRay{film, {direction.l, direction.m, std::sqrt(square)}};
}

/// Whether the ray passes lens and aperture.
/// @param[in,out] ray  the ray that leaves the lens, if it passes
inline Passage TraceThrough(const GlassLens& lens, const Aperture& aperture, GlassRay& ray, bool rims = true)
{
    StopPoint stop;
    const Passage passage = lens.Trace(ray, stop, rims);
    if (passage == Passage::Passed && !aperture.IsDisc() && !(aperture.Density({stop.a, stop.b}) > 0.0))
        return Passage::Stopped;
    return passage;
}

/// The same for four rays side by side.
/// @return  a bit for each that passes, the lowest for the first
inline unsigned int TraceThrough(const GlassLens& lens, const Aperture& aperture, FourGlassRays& rays, bool rims = true)
{
    FourStopPoints stop;
    unsigned int passed = lens.Trace(rays, stop, rims);
    for (int i = 0; i < 4 && !aperture.IsDisc(); i++)
        if ((passed >> i & 1u) != 0 && !(aperture.Density({stop.a[i], stop.b[i]}) > 0.0))
            passed &= ~(1u << i);
    return passed;
}

/// Measures what a film point (mm, lens frame) sees, by some hundred rays.
/// @param near  a direction that neighbours of the point see something in, tried first
/// @return nothing where no ray passes
std::optional<PupilView> ViewOf(const GlassLens& lens, const Aperture& aperture, const Vec3& film, const std::optional<PupilPoint>& near);

} // namespace tilt_lens

#endif
