// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/kernels/variant.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

/// Lenses side by side, one for each ray.
struct LensOfEachRay
{
    const GlassSurface* first[kVectorWidth<Doubles>];  ///< surfaces
    bool same = true;  ///< all rays go through one lens

    explicit TILT_LENS_INLINED LensOfEachRay(const GlassSurface* const* lenses)
    {
        for (std::size_t i = 0; i < kVectorWidth<Doubles>; i++)
        {
            first[i] = lenses[i];
            same = same && first[i] == first[0];
        }
    }

    /// GlassSurface::ratio of each ray's surface.
    TILT_LENS_INLINED Doubles IndicesAt(std::size_t number) const
    {
        Doubles indices = Doubles() + first[0][number].ratio;
        for (std::size_t i = 1; i < kVectorWidth<Doubles> && !same; i++)
            indices[i] = first[i][number].ratio;
        return indices;
    }
};

TILT_LENS_INLINED MaskOf<Doubles> CrossOneByOne(const LensOfEachRay& lenses, std::size_t number, bool rims, GlassRayOf<Doubles>& rays)
{
    Doubles passes{};
    for (std::size_t i = 0; i < kVectorWidth<Doubles>; i++)
    {
        GlassRay ray{{rays.origin.x[i], rays.origin.y[i], rays.origin.z[i]},
                     {rays.direction.x[i], rays.direction.y[i], rays.direction.z[i]}};
        const Crossing<double> crossing = CrossAsphere<true>(lenses.first[i][number], ray);
        passes[i] = crossing.met && (crossing.withinRim || !rims) && crossing.refracted;
        rays.origin.x[i] = ray.origin.x, rays.origin.y[i] = ray.origin.y, rays.origin.z[i] = ray.origin.z;
        rays.direction.x[i] = ray.direction.x, rays.direction.y[i] = ray.direction.y, rays.direction.z[i] = ray.direction.z;
    }
    return passes > 0.0;
}

} // namespace

unsigned int TraceGlass(const GlassSurface* const (&surfaces)[4], std::size_t count, double stopScale, bool rims, FourGlassRays& rays,
                        FourStopPoints& stop)
{
    unsigned int passed = 0;
    for (std::size_t first = 0; first < 4; first += kVectorWidth<Doubles>)
    {
        const LensOfEachRay lenses(surfaces + first);
        GlassRayOf<Doubles> ray{LoadVectors<Doubles>(rays.origin, first), LoadVectors<Doubles>(rays.direction, first)};
        MaskOf<Doubles> passes = Doubles() == Doubles();
        const MaskOf<Doubles> beyondRims = rims ? Doubles() != Doubles() : passes;
        for (std::size_t number = 0; number < count; number++)
        {
            const GlassSurface& surface = lenses.first[0][number];
            if (surface.stop)
            {
                passes &= CrossStop(surface, ray);
                Store(stop.a + first, stopScale * ray.origin.x);
                Store(stop.b + first, stopScale * ray.origin.y);
            }
            else if (surface.sphere)
            {
                const Crossing<Doubles> crossing = CrossSphere<true>(surface, lenses.IndicesAt(number), ray);
                passes &= crossing.met & (crossing.withinRim | beyondRims) & crossing.refracted;
            }
            else
                passes &= CrossOneByOne(lenses, number, rims, ray);
        }
        StoreVectors(rays.origin, first, ray.origin);
        StoreVectors(rays.direction, first, ray.direction);
        passed |= SignBits(passes & (ray.direction.z > 0.0)) << first;
    }
    return passed;
}

} // namespace tilt_lens::TILT_LENS_VARIANT
