// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file near_shadow.cpp
/// POV-Ray ignores shadow casters nearer than 0.001 units, except the cached last occluder. With `tilt_lens`, all objects that the cache
/// could hold are tested.

#include <algorithm>

#include "backend/frame.h"
#include "backend/render/trace.h"
#include "backend/scene/objects.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

struct MayBeKept : public RayObjectCondition
{
    virtual bool operator()(const Ray&, const ObjectBase* object, double) const
    {
        const BBOX& box = object->BBox;
        return Test_Flag(object, OPAQUE_FLAG) && !Test_Flag(object, NO_SHADOW_FLAG) &&
               std::max({box.Lengths[X], box.Lengths[Y], box.Lengths[Z]}) > SMALL_TOLERANCE;
    }
};

} // namespace

bool Trace::IsInNearShadow(const Ray& ray, double lightDepth)
{
    Intersection nearest;
    nearest.Object = nearest.Csg = NULL;
    nearest.Depth = std::min(SMALL_TOLERANCE, lightDepth);
    return FindIntersection(nearest, ray, MayBeKept(), TrueRayObjectCondition());
}

} // namespace pov
