// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file ray.h
/// The way of a ray: film point and lens point in, ray out. One formula without a division, so nothing
/// happens where a pixel focuses at infinity or behind the lens:
///
///     D = direction + x right + y up      chief ray of the film point
///     w = k.D                             1/w is where it meets the plane of sharp focus, in units of D
///     l = a lensX + b lensY               point of the tilted lens
///     ray: from l, along D - w l
///
/// For w > 0 the ray meets the chief ray in front of the lens at D/w, for w < 0 it comes from that
/// point behind it, for w = 0 it is parallel to the chief ray.
///
/// A lens that reaches to the film has one lens point for each film point there that touches it: no ray
/// leads from a point to itself, and the chief ray stands in.

#ifndef TILT_LENS_RAY_H
#define TILT_LENS_RAY_H

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// A point of the film as the picture shows it, upright: 0 is the middle, +-0.5 the edges of the frame.
struct FilmPoint
{
    double x, y;  ///< to the right, upward
};

/// @param column, row    in pixels from the upper left corner of the picture; the middle of a pixel is at its number + 0.5
/// @param width, height  of the whole picture, in pixels
inline FilmPoint FilmPointAt(double column, double row, double width, double height)
{
    return {column / width - 0.5, 0.5 - row / height};
}

/// The ray through the lens centre, not normalised: it ends where `direction`, `right` and `up` of the lens do.
inline Vec3 ChiefRay(const Lens& lens, const FilmPoint& film)
{
    return lens.direction + film.x * lens.right + film.y * lens.up;
}

struct LensRay
{
    Vec3 origin;     ///< relative to the lens centre, world axes, scene units
    Vec3 direction;  ///< not normalised: parameter 1/w is the plane of sharp focus
    double w;        ///< as above
};

/// @param x, y  film point as in FilmPoint
/// @param a, b  lens point in aperture coordinates, in the unit disc: right, up
inline LensRay MakeRay(const Lens& lens, double x, double y, double a, double b)
{
    const Vec3 chief = ChiefRay(lens, {x, y});
    // linear over the frame: where k and D are nearly at right angles, k.D itself would cancel
    const double w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
    const Vec3 point = a * lens.lensX + b * lens.lensY;
    const Vec3 direction = chief - w * point;
    const bool none = direction.x == 0.0 && direction.y == 0.0 && direction.z == 0.0;
    return {point, none ? chief : direction, w};
}

/// Vergence difference 1/T - w of a surface point at parameter T of a chief ray: the film image of
/// the lens outline is this times the lens (in units of `right` and `up` after division by their
/// lengths). Zero in focus, positive before the plane of sharp focus, finite for T infinite.
inline double BlurVergence(const Lens& lens, const Vec3& chief, double T)
{
    return 1.0 / T - Dot(lens.focus, chief);
}

} // namespace tilt_lens

#endif
