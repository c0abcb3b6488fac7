// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/hierarchy/box_ray.h"

namespace tilt_lens
{

namespace
{

unsigned int SignBits(const Mask8& mask)
{
#ifdef __SSE2__
    const Float4* const halves = reinterpret_cast<const Float4*>(&mask);
    return __builtin_ia32_movmskps(halves[0]) | __builtin_ia32_movmskps(halves[1]) << 4;
#else
    unsigned int bits = 0;
    for (int i = 0; i < 8; i++)
        bits |= (mask[i] < 0 ? 1u : 0u) << i;
    return bits;
#endif
}

/// Written once, compiled for each kind of processor: no operation is contracted, so that all have the same results.
inline __attribute__((always_inline)) unsigned int EnterAll(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    const char* const from = reinterpret_cast<const char*>(&boxes);
    Float8 enter = Float8(), leave = Float8() + limit;
    for (int axis = 0; axis < 3; axis++)
    {
        const Float8 in = *reinterpret_cast<const Float8*>(from + ray.enterPlanes[axis]);
        const Float8 out = *reinterpret_cast<const Float8*>(from + ray.leavePlanes[axis]);
        const Float8 near = (in - ray.enterFrom[axis]) * ray.enterInverse[axis];
        const Float8 far = (out - ray.leaveFrom[axis]) * ray.leaveInverse[axis];
        enter = near > enter ? near : enter;
        leave = far < leave ? far : leave;
    }
    *reinterpret_cast<Float8*>(begin) = enter;
    return SignBits(enter <= leave);
}

} // namespace

unsigned int EnterPlain(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    return EnterAll(boxes, ray, limit, begin);
}

#if defined(__x86_64__) || defined(__i386__)

__attribute__((target("avx2"))) unsigned int EnterByAvx2(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    return EnterAll(boxes, ray, limit, begin);
}

bool HasAvx2() { return __builtin_cpu_supports("avx2"); }

#else

unsigned int EnterByAvx2(const EightBoxes& boxes, const BoxRay& ray, float limit, float* begin)
{
    return EnterAll(boxes, ray, limit, begin);
}

bool HasAvx2() { return false; }

#endif

EnterBoxes* const Enter = HasAvx2() ? EnterByAvx2 : EnterPlain;

} // namespace tilt_lens
