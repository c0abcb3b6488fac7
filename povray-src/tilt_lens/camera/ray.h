// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file ray.h
/// Ray generation (docs/optics.md), without divisions, so that a pixel may focus at infinity or behind the lens:
///
///     D = direction + x right + y up      chief ray of the film point;
///     w = k.D                             inverse of the parameter at which D meets the plane of sharp focus;
///     l = a lensX + b lensY               point of the tilted lens;
///     ray: from l, along D - w l.
///
/// Distortion replaces D by another film point's chief ray (film_point.h). With field curvature, w = k.D + c a^2/b for a D that lies a
/// across the lens's axis and b along it. Where a lens touches a film point, the chief ray replaces the ray.

#ifndef TILT_LENS_RAY_H
#define TILT_LENS_RAY_H

#include <cmath>
#include <cstddef>
#include <optional>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// Not normalised; see IdealChiefRay().
inline Vec3 ChiefRay(const Lens& lens, const FilmPoint& film)
{
    const FilmPoint ideal = lens.distorts ? IdealFilmPoint(lens, film) : film;
    return IdealChiefRay(lens, ideal);
}

template<class Number>
TILT_LENS_INLINED Number FieldVergence(const Lens& lens, const VecOf<Number>& chief)
{
    const VecOf<Number> normal = Broadcast<Number>(lens.normal);
    const Number along = Dot(chief, normal);
    const VecOf<Number> across = chief - along * normal;
    return lens.fieldCurvature * Dot(across, across) / along;
}

/// Inverse w of the parameter at which a chief ray meets the surface of sharp focus.
inline double FocusVergence(const Lens& lens, const Vec3& chief)
{
    const double w = Dot(lens.focus, chief);
    return lens.fieldCurvature == 0.0 ? w : w + FieldVergence(lens, chief);
}

template<class Number>
struct LensRayOf
{
    VecOf<Number> origin;     ///< relative to the lens centre, world axes, scene units
    VecOf<Number> direction;  ///< not normalised: the surface of sharp focus is at 1/w
    Number w;
};

using LensRay = LensRayOf<double>;

/// Rays of the ideal lens, one or several side by side.
/// @param vergence  added to w per length of the chief ray along the lens's axis
template<class Number>
TILT_LENS_INLINED LensRayOf<Number> RayFromIdeal(const Lens& lens, const Number& x, const Number& y, const Number& a, const Number& b,
                                                 double vergence = 0.0)
{
    const VecOf<Number> chief = IdealChiefRay(lens, x, y);
    // k.D would cancel where k and D are nearly perpendicular
    Number w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
    if (lens.fieldCurvature != 0.0)
        w += FieldVergence(lens, chief);
    if (vergence != 0.0)
        w += vergence * Dot(chief, Broadcast<Number>(lens.normal));
    const VecOf<Number> point = a * Broadcast<Number>(lens.lensX) + b * Broadcast<Number>(lens.lensY), direction = chief - w * point;
    const auto none = (direction.x == 0.0) & (direction.y == 0.0) & (direction.z == 0.0);
    return {point, {none ? chief.x : direction.x, none ? chief.y : direction.y, none ? chief.z : direction.z}, w};
}

inline LensRay MakeRay(const Lens& lens, double x, double y, double a, double b)
{
    const FilmPoint ideal = lens.distorts ? IdealFilmPoint(lens, {x, y}) : FilmPoint{x, y};
    return RayFromIdeal(lens, ideal.x, ideal.y, a, b);
}

/// The sizes are multiples of 4.
struct RayArrays
{
    const double *x, *y, *a, *b;
    double* origin[3];
    double* direction[3];         ///< unit vectors
    double* length;               ///< before normalisation
    double* w;
};

/// Same results as MakeRay() for samples `begin` to before `end`. May also fill the rest of the fours that it touches.
void MakeRays(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end);

/// @param hue  place in the spectrum, -1 (blue end) to 1 (red end); MakeRay() has 0
inline LensRay MakeColourRay(const Lens& lens, double x, double y, double a, double b, double hue)
{
    const FilmPoint ideal = IdealFilmPoint(lens, {x, y}, 1.0 + hue * lens.lateralColour);
    return RayFromIdeal(lens, ideal.x, ideal.y, a, b, -hue * lens.axialColour);
}

/// The chief ray D, of any length, of the ray through the lens point l and the point P. None if the ray reaches P from beyond
/// its film point's focus. Y = s D solves Y = P - l + w(Y) l, and Y equals P along the lens's axis, so the equation is quadratic in w(Y).
inline std::optional<Vec3> ChiefThrough(const Lens& lens, const Vec3& P, const Vec3& l)
{
    const double divisor = 1.0 - Dot(lens.focus, l);
    const Vec3 way = P - l;
    if (lens.fieldCurvature == 0.0)
        return divisor > 0.0 ? std::optional<Vec3>(divisor * way + Dot(lens.focus, way) * l) : std::nullopt;
    const double along = Dot(way, lens.normal);
    const Vec3 across = way - along * lens.normal;
    const double perAlong = lens.fieldCurvature / along;
    // square w^2 - linear w + constant = 0; as c vanishes, this root becomes the ideal lens's
    const double square = perAlong * Dot(l, l), linear = divisor - 2.0 * perAlong * Dot(across, l);
    const double constant = Dot(lens.focus, way) + perAlong * Dot(across, across);
    const double root = linear * linear - 4.0 * square * constant;
    if (!(linear > 0.0 && root >= 0.0))
        return {};
    return way + (2.0 * constant / (linear + std::sqrt(root))) * l;
}

/// 1/T - w of a chief ray's point at T: zero in focus, positive before the plane of sharp focus, finite for infinite T. The circle of
/// confusion is the lens outline times this, in units of `right` and `up` divided by their lengths.
inline double BlurVergence(const Lens& lens, const Vec3& chief, double T)
{
    return 1.0 / T - FocusVergence(lens, chief);
}

} // namespace tilt_lens

#endif
