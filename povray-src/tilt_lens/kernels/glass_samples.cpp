// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/pupil_view.h"
#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/lens_camera/glass_film.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

void FindPupils(const GlassFilm& film, const PupilNode* nodes, const FourGlassPoints& points, FourPupils& pupils)
{
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Doubles>)
    {
        const Doubles x = Load<Doubles>(points.x + i), y = Load<Doubles>(points.y + i);
        const VecOf<Doubles> place = film.Place(x, y);
        const PupilPointOf<Doubles> aim = ParaxialAim(film.cardinal, place), axis = RadialAxis(place);
        const PupilInterpolation<Doubles> mean(nodes, points.x + i, points.y + i);
        const Doubles open = mean(&PupilNode::open);
        StoreVectors(pupils.place, i, place);
        Store(pupils.l + i, aim.l + mean(&PupilNode::l));
        Store(pupils.m + i, aim.m + mean(&PupilNode::m));
        Store(pupils.radial + i, mean(&PupilNode::radial));
        Store(pupils.tangential + i, mean(&PupilNode::tangential));
        Store(pupils.axisL + i, axis.l);
        Store(pupils.axisM + i, axis.m);
        Store(pupils.brightness + i, film.Brightness(open, film.natural == 0.0 ? Doubles() : mean(&PupilNode::natural)));
        pupils.seen |= SignBits(open > 0.0) << i;
    }
}

unsigned int AimAtPupils(const FourPupils& pupils, const double* a, const double* b, FourGlassRays& rays)
{
    unsigned int found = 0;
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Doubles>)
    {
        const Doubles along = Load<Doubles>(pupils.radial + i) * Load<Doubles>(a + i);
        const Doubles across = Load<Doubles>(pupils.tangential + i) * Load<Doubles>(b + i);
        const Doubles axisL = Load<Doubles>(pupils.axisL + i), axisM = Load<Doubles>(pupils.axisM + i);
        const PupilPointOf<Doubles> direction{Load<Doubles>(pupils.l + i) + along * axisL - across * axisM,
                                              Load<Doubles>(pupils.m + i) + along * axisM + across * axisL};
        const Doubles square = SquaredAlong(direction);
        StoreVectors(rays.origin, i, LoadVectors<Doubles>(pupils.place, i));
        StoreVectors(rays.direction, i, VecOf<Doubles>{direction.l, direction.m, SquareRoot(square)});
        found |= SignBits(square > 0.0) << i;
    }
    return found;
}

void LeaveGlass(const GlassFilm& film, const FourGlassPoints& points, const FourGlassRays& rays, FourGlassSamples& samples)
{
    for (std::size_t i = 0; i < 4; i += kVectorWidth<Doubles>)
    {
        const GlassRayOf<Doubles> left{LoadVectors<Doubles>(rays.origin, i), LoadVectors<Doubles>(rays.direction, i)};
        const LensRayOf<Doubles> ray = film.ToWorld<Doubles>(Load<Doubles>(points.x + i), Load<Doubles>(points.y + i), left);
        StoreVectors(samples.origin, i, ray.origin);
        StoreVectors(samples.direction, i, ray.direction);
        Store(samples.w + i, ray.w);
    }
}

} // namespace tilt_lens::TILT_LENS_VARIANT
