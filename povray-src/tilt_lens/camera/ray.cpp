// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/ray.h"

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Within these bounds a squared length neither overflows nor underflows (else Length() scales).
constexpr double kLeastSquared = 1e-200, kGreatestSquared = 1e200;

/// Rays of a lens without distortion.
/// @return  false if a length is beyond the bounds; then the rays are invalid
template<class Vector>
TILT_LENS_INLINED bool MakeSideBySide(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    MaskOf<Vector> usual = Vector() == Vector();
    for (std::size_t i = begin; i < end; i += kVectorWidth<Vector>)
    {
        const auto at = [i](const double* numbers) TILT_LENS_INLINED_LAMBDA { return Load<Vector>(numbers + i); };
        const LensRayOf<Vector> ray = RayFromIdeal(lens, at(rays.x), at(rays.y), at(rays.a), at(rays.b));
        const Vector squared = Dot(ray.direction, ray.direction), length = SquareRoot(squared);
        usual &= (squared > kLeastSquared) & (squared < kGreatestSquared);
        const VecOf<Vector> unit = ray.direction / length;
        const Vector origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z}, direction[3] = {unit.x, unit.y, unit.z};
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

bool MakePlainly(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    return MakeSideBySide<Double2>(lens, rays, begin, end);
}

TILT_LENS_FOR_AVX2 bool MakeByAvx2(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    return MakeSideBySide<Double4>(lens, rays, begin, end);
}

const auto makeSideBySide = HasAvx2() ? MakeByAvx2 : MakePlainly;

} // namespace

void MakeRays(const Lens& lens, const RayArrays& rays, std::size_t begin, std::size_t end)
{
    if (!lens.distorts && makeSideBySide(lens, rays, begin & ~std::size_t(3), (end + 3) & ~std::size_t(3)))
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
