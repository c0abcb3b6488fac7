// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/ray.h"

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

void MakeRays(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    if (!lens.distorts && kernels->makeRays(lens, rays, begin & ~std::size_t(3), (end + 3) & ~std::size_t(3)))
        return;
    for (std::size_t i = begin; i < end; i++)
    {
        const LensRay ray = MakeRay(lens, rays.x[i], rays.y[i], rays.a[i], rays.b[i]);
        rays.length[i] = Length(ray.direction);
        const Vec3 unit = ray.direction / rays.length[i];
        const double origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, direction[3] = {unit.x, unit.y, unit.z};
        for (int axis = 0; axis < 3; axis++)
        {
            rays.origin[axis][i] = origin[axis];
            rays.direction[axis][i] = direction[axis];
        }
        rays.w[i] = ray.w;
    }
}

} // namespace tilt_lens
