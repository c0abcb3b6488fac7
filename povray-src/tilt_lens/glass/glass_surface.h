// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_surface.h
/// Intersection and refraction at one surface, equal for one ray and for rays side by side (simd.h). Frame and source: glass_lens.h.

#ifndef TILT_LENS_GLASS_SURFACE_H
#define TILT_LENS_GLASS_SURFACE_H

#include <vector>

#include "tilt_lens/math/simd.h"
#include "tilt_lens/math/vec3.h"

namespace tilt_lens
{

template<class Number>
struct GlassRayOf
{
    VecOf<Number> origin, direction;
};

using GlassRay = GlassRayOf<double>;

template<class Number>
TILT_LENS_INLINED Number SquaredHeight(const GlassRayOf<Number>& ray)
{
    return ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y;
}

struct GlassSurface
{
    double z;
    double curvature;  ///< 1/mm, positive if the centre lies towards the scene
    double ratio;  ///< index towards the film over that towards the scene
    double squaredRim;
    bool stop, sphere;  ///< sphere or plane; else conic or aspherical
    double conic;
    std::vector<double> aspheric;  ///< coefficients of the sag towards the scene
};

template<class Number>
struct Crossing
{
    MaskOf<Number> met;
    MaskOf<Number> withinRim;
    MaskOf<Number> refracted;  ///< else totally reflected
};

template<bool towardsScene, class Number>
TILT_LENS_INLINED Number Signed(const Number& value)
{
    return towardsScene ? value : -value;
}

/// @param indices    as GlassSurface::ratio
/// @param cosine     unit normal and direction
/// @param direction  in: before the surface; out: behind it
/// @return           false for total reflection
template<bool towardsScene, class Number>
TILT_LENS_INLINED MaskOf<Number> Refract(const Number& indices, const Number& cosine, const VecOf<Number>& normal, VecOf<Number>& direction)
{
    const Number ratio = towardsScene ? indices : 1.0 / indices;
    const Number left = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    const Number along = Signed<towardsScene>(SquareRoot(left)) - ratio * cosine;
    direction = {ratio * direction.x + along * normal.x, ratio * direction.y + along * normal.y, ratio * direction.z + along * normal.z};
    return left >= 0.0;
}

/// For p relative to the vertex, c |p|^2 = 2 p.z, so c t^2 - 2 half t + constant = 0 along the ray. The root near the vertex counts; a
/// sphere ends where it turns back.
/// @param indices  of each ray, as GlassSurface::ratio
template<bool towardsScene, class Number>
TILT_LENS_INLINED Crossing<Number> CrossSphere(const GlassSurface& surface, const Number& indices, GlassRayOf<Number>& ray)
{
    const double c = surface.curvature;
    const VecOf<Number>& d = ray.direction;
    const VecOf<Number> p{ray.origin.x, ray.origin.y, ray.origin.z - surface.z};
    const Number constant = c * Dot(p, p) - 2.0 * p.z, half = d.z - c * Dot(p, d), square = half * half - c * constant;
    const Number cosine = Signed<towardsScene>(SquareRoot(square)), step = constant / (half + cosine), depth = p.z + step * d.z;
    ray.origin = {p.x + step * d.x, p.y + step * d.y, surface.z + depth};
    const VecOf<Number> normal{-c * ray.origin.x, -c * ray.origin.y, 1.0 - c * depth};
    const MaskOf<Number> met = (square >= 0.0) & (normal.z > 0.0), withinRim = SquaredHeight(ray) <= surface.squaredRim;
    return {met, withinRim, Refract<towardsScene>(indices, cosine, normal, ray.direction)};
}

/// Moves the ray to the stop's plane; true within the opening.
template<class Number>
TILT_LENS_INLINED MaskOf<Number> CrossStop(const GlassSurface& surface, GlassRayOf<Number>& ray)
{
    const Number way = (surface.z - ray.origin.z) / ray.direction.z;
    const VecOf<Number>&o = ray.origin, &d = ray.direction;
    ray.origin = {o.x + way * d.x, o.y + way * d.y, o.z + way * d.z};
    return SquaredHeight(ray) <= surface.squaredRim;
}

template<bool towardsScene>
Crossing<double> CrossAsphere(const GlassSurface& surface, GlassRay& ray);

} // namespace tilt_lens

#endif
