// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/hierarchy/box_ray.h"

namespace tilt_lens
{

namespace
{

/// As many of the boxes as a Vector has lanes, from `first`.
template<class Vector>
TILT_LENS_INLINED unsigned int EnterSome(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin, int first)
{
    const char* const from = reinterpret_cast<const char*>(&boxes) + first * sizeof(float);
    Vector enter = Vector(), leave = Vector() + limit;
    for (int axis = 0; axis < 3; axis++)
    {
        const Vector in = *reinterpret_cast<const Vector*>(from + ray.enterPlanes[axis]);
        const Vector out = *reinterpret_cast<const Vector*>(from + ray.leavePlanes[axis]);
        const Vector near = (in - ray.enterFrom[axis]) * ray.enterInverse[axis];
        const Vector far = (out - ray.leaveFrom[axis]) * ray.leaveInverse[axis];
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
    }
    *reinterpret_cast<Vector*>(begin + first) = enter;
    return SignBits(enter <= leave);
}

} // namespace

unsigned int EnterPlain(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    return EnterSome<Float4>(boxes, ray, limit, begin, 0) | EnterSome<Float4>(boxes, ray, limit, begin, 4) << 4;
}

TILT_LENS_FOR_AVX2 unsigned int EnterByAvx2(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    return EnterSome<Float8>(boxes, ray, limit, begin, 0);
}

EnterBoxes* const Enter = HasAvx2() ? EnterByAvx2 : EnterPlain;

} // namespace tilt_lens
