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
/// A lens with distortion takes D of another film point (film_point.h), one with field curvature has w = k.D + c a^2/b for a D that
/// lies a across the lens's axis and b along it; all else is as above.
///
/// A lens that reaches to the film has one lens point for each film point there that touches it: no ray
/// leads from a point to itself, and the chief ray stands in.

#ifndef TILT_LENS_RAY_H
#define TILT_LENS_RAY_H

#include <cmath>
#include <optional>

#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// The ray through the lens centre, as IdealChiefRay(), of a lens that may have distortion.
inline Vec3 ChiefRay(const Lens& lens, const FilmPoint& film)
{
    const FilmPoint ideal = lens.distorts ? IdealFilmPoint(lens, film) : film;
    return IdealChiefRay(lens, ideal);
}

/// What field curvature adds to w for a chief ray.
inline double FieldVergence(const Lens& lens, const Vec3& chief)
{
    const double along = Dot(chief, lens.normal);
    const Vec3 across = chief - along * lens.normal;
    return lens.fieldCurvature * Dot(across, across) / along;
}

/// w of a chief ray: 1/w is where it meets the surface of sharp focus, in units of its length.
inline double FocusVergence(const Lens& lens, const Vec3& chief)
{
    const double w = Dot(lens.focus, chief);
    return lens.fieldCurvature == 0.0 ? w : w + FieldVergence(lens, chief);
}

/// A ray, or rays side by side.
template<class Number>
struct LensRayOf
{
    VecOf<Number> origin;     ///< relative to the lens centre, world axes, scene units
    VecOf<Number> direction;  ///< not normalised: parameter 1/w is the plane of sharp focus
    Number w;                 ///< as above
};

using LensRay = LensRayOf<double>;

/// @param ideal     film point of the ideal lens
/// @param vergence  added to w for each unit of the chief ray along the lens's axis
inline LensRay RayFromIdeal(const Lens& lens, const FilmPoint& ideal, double a, double b, double vergence)
{
    const Vec3 chief = IdealChiefRay(lens, ideal);
    // linear over the frame: where k and D are nearly at right angles, k.D itself would cancel
    double w = lens.focusMiddle + ideal.x * lens.focusRight + ideal.y * lens.focusUp;
    if (lens.fieldCurvature != 0.0)
        w += FieldVergence(lens, chief);
    if (vergence != 0.0)
        w += vergence * Dot(chief, lens.normal);
    const Vec3 point = a * lens.lensX + b * lens.lensY;
    const Vec3 direction = chief - w * point;
    const bool none = direction.x == 0.0 && direction.y == 0.0 && direction.z == 0.0;
    return {point, none ? chief : direction, w};
}

/// @param x, y  film point as in FilmPoint
/// @param a, b  lens point in aperture coordinates, in the unit disc: right, up
inline LensRay MakeRay(const Lens& lens, double x, double y, double a, double b)
{
    return RayFromIdeal(lens, lens.distorts ? IdealFilmPoint(lens, {x, y}) : FilmPoint{x, y}, a, b, 0.0);
}

/// The same for light of one colour.
/// @param hue  its place in the spectrum, from -1 (blue end) over 0 (the middle, which MakeRay() has) to 1 (red end)
inline LensRay MakeColourRay(const Lens& lens, double x, double y, double a, double b, double hue)
{
    const FilmPoint ideal = IdealFilmPoint(lens, {x, y}, 1.0 + hue * lens.lateralColour);
    return RayFromIdeal(lens, ideal, a, b, -hue * lens.axialColour);
}

/// Whether the lens has colour fringes, so that rays of several colours must be traced.
inline bool HasColours(const Lens& lens) { return lens.lateralColour != 0.0 || lens.axialColour != 0.0 || lens.glassOfColours; }

/// The chief ray D, of any length, of the ray that leads through the lens point l and through P; nothing where that is none, or
/// one that comes to P from beyond the focus of its film point. On the ray P = l + s (D - w l), so that Y = s D solves
/// Y = P - l + w(Y) l, where w(Y) = k.Y + c a^2/b. Along the lens's axis Y is P, so that this is quadratic in w(Y).
inline std::optional<Vec3> ChiefThrough(const Lens& lens, const Vec3& P, const Vec3& l)
{
    const double divisor = 1.0 - Dot(lens.focus, l);
    const Vec3 way = P - l;
    if (lens.fieldCurvature == 0.0)
        return divisor > 0.0 ? std::optional<Vec3>(divisor * way + Dot(lens.focus, way) * l) : std::nullopt;
    const double along = Dot(way, lens.normal);
    const Vec3 across = way - along * lens.normal;
    const double perAlong = lens.fieldCurvature / along;
    // square w^2 - linear w + constant = 0; the root that is that of the ideal lens where the first term vanishes
    const double square = perAlong * Dot(l, l), linear = divisor - 2.0 * perAlong * Dot(across, l);
    const double constant = Dot(lens.focus, way) + perAlong * Dot(across, across);
    const double root = linear * linear - 4.0 * square * constant;
    if (!(linear > 0.0 && root >= 0.0))
        return {};
    return way + (2.0 * constant / (linear + std::sqrt(root))) * l;
}

/// Vergence difference 1/T - w of a surface point at parameter T of a chief ray: the film image of
/// the lens outline is this times the lens (in units of `right` and `up` after division by their
/// lengths). Zero in focus, positive before the plane of sharp focus, finite for T infinite.
inline double BlurVergence(const Lens& lens, const Vec3& chief, double T)
{
    return 1.0 / T - FocusVergence(lens, chief);
}

} // namespace tilt_lens

#endif
