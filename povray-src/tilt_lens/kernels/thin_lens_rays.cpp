// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/kernels/variant.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

/// Squared lengths in between neither overflow nor underflow.
constexpr double kLeastSquared = 1e-200, kGreatestSquared = 1e200;

} // namespace

bool MakeRays(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    MaskOf<Doubles> usual = Doubles() == Doubles();
    for (std::size_t i = begin; i < end; i += kVectorWidth<Doubles>)
    {
        const auto at = [i](const double* numbers) TILT_LENS_INLINED_LAMBDA { return Load<Doubles>(numbers + i); };
        const LensRayOf<Doubles> ray = RayFromIdeal(lens, at(rays.x), at(rays.y), at(rays.a), at(rays.b));
        const Doubles squared = Dot(ray.direction, ray.direction), length = SquareRoot(squared);
        usual &= (squared > kLeastSquared) & (squared < kGreatestSquared);
        const VecOf<Doubles> unit = ray.direction / length;
        const Doubles origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, direction[3] = {unit.x, unit.y, unit.z};
        for (int axis = 0; axis < 3; axis++)
        {
            Store(rays.origin[axis] + i, origin[axis]);
            Store(rays.direction[axis] + i, direction[axis]);
        }
        Store(rays.length + i, length);
        Store(rays.w + i, ray.w);
    }
    return All(usual);
}

} // namespace tilt_lens::TILT_LENS_VARIANT
