// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_surface.h"

#include <cmath>

namespace tilt_lens
{

namespace
{

/// Newton's method; the tolerance is relative to the ray's height or 1 mm.
constexpr int kMostSteps = 30;
constexpr double kNearEnough = 1e-13;

/// The normal, of any length, points to the scene. False without intersection, or beyond the point where the surface turns back.
bool IntersectConic(const GlassSurface& surface, GlassRay& ray, Vec3& normal)
{
    const double c = surface.curvature;
    const Vec3& d = ray.direction;
    const double way = (surface.z - ray.origin.z) / d.z;
    const double x = ray.origin.x + way * d.x, y = ray.origin.y + way * d.y;
    // c (x^2 + y^2 + (1 + conic) z^2) = 2 z along the ray: square t^2 - 2 half t + constant = 0; the root near the vertex
    const double constant = c * (x * x + y * y), half = d.z - c * (x * d.x + y * d.y);
    const double square = c * (1.0 + surface.conic * d.z * d.z);
    const double root = half * half - square * constant;
    if (!(root >= 0.0))
        return false;
    const double step = constant / (half + std::copysign(std::sqrt(root), d.z));
    const double depth = step * d.z;
    ray.origin = {x + step * d.x, y + step * d.y, surface.z + depth};
    normal = {-c * ray.origin.x, -c * ray.origin.y, 1.0 - c * (1.0 + surface.conic) * depth};
    return normal.z > 0.0;
}

bool IntersectAspheric(const GlassSurface& surface, GlassRay& ray, Vec3& normal)
{
    const double c = surface.curvature;
    for (int i = 0; i < kMostSteps; i++)
    {
        const double x = ray.origin.x, y = ray.origin.y, square = x * x + y * y;
        const double inner = 1.0 - (1.0 + surface.conic) * c * c * square;
        if (!(inner > 0.0))
            return false;
        const double root = std::sqrt(inner);
        double sag = c * square / (1.0 + root), slope = c / root;  // derivative of the sag by the height, over the height
        double power = square;
        for (std::size_t j = 0; j < surface.aspheric.size(); j++)
        {
            slope += (2.0 * j + 4.0) * surface.aspheric[j] * power;
            power *= square;
            sag += surface.aspheric[j] * power;
        }
        normal = {-slope * x, -slope * y, 1.0};
        const double step = (surface.z + sag - ray.origin.z) / Dot(normal, ray.direction);
        ray.origin = ray.origin + step * ray.direction;
        if (std::fabs(step) <= kNearEnough * (1.0 + std::sqrt(square)))
            return true;
    }
    return false;
}

} // namespace

template<bool towardsScene>
Crossing<double> CrossAsphere(const GlassSurface& surface, GlassRay& ray)
{
    Vec3 normal;
    if (!IntersectConic(surface, ray, normal) || (!surface.aspheric.empty() && !IntersectAspheric(surface, ray, normal)))
        return {false, false, false};
    normal = normal / std::sqrt(Dot(normal, normal));
    const double cosine = Dot(ray.direction, normal);
    const bool met = Signed<towardsScene>(cosine) > 0.0, withinRim = SquaredHeight(ray) <= surface.squaredRim;
    return {met, withinRim, Refract<towardsScene>(surface.ratio, cosine, normal, ray.direction)};
}

template Crossing<double> CrossAsphere<true>(const GlassSurface& surface, GlassRay& ray);
template Crossing<double> CrossAsphere<false>(const GlassSurface& surface, GlassRay& ray);

} // namespace tilt_lens
