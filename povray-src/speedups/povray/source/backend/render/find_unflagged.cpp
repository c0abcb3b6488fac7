// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/frame.h"
#include "backend/bounding/scene_hierarchy.h"
#include "backend/render/trace.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"

// must be last
#include "base/povdebug.h"

namespace pov
{

/// Flags save two virtual calls per object.
bool Trace::FindUnflagged(Intersection& isect, const Ray& ray, unsigned int flags, double depth, const RayObjectCondition& precondition,
                          const RayObjectCondition& postcondition)
{
    if (sceneData->boundingMethod == 1)
        return sceneData->hierarchy->Intersect(ray, isect, flags, depth, threadData);
    return FindIntersection(isect, ray, precondition, postcondition);
}

bool Trace::FindIntersection(Intersection& isect, const Ray& ray, const NoSomethingFlagRayObjectCondition& precondition,
                             const TrueRayObjectCondition& postcondition)
{
    if (!sceneData->hierarchy)
        return FindIntersection(isect, ray, static_cast<const RayObjectCondition&>(precondition), postcondition);
    const unsigned int flags = (ray.IsImageRay() ? NO_IMAGE_FLAG : 0) | (ray.IsReflectionRay() ? NO_REFLECTION_FLAG : 0) |
                               (ray.IsRadiosityRay() ? NO_RADIOSITY_FLAG : 0) | (ray.IsPhotonRay() ? NO_SHADOW_FLAG : 0);
    return FindUnflagged(isect, ray, flags, -HUGE_VAL, precondition, postcondition);
}

} // namespace pov
