// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file near_shadow.cpp
/// Shadows near what casts them. POV-Ray leaves out all that is nearer than 0.001 units to a point in shadow, unless it is the
/// object that stood in the light's way last: a thread keeps that one and asks it for shadows at any distance. Pictures with
/// `tilt_lens` keep nothing from one ray for the next (forget_rays.cpp), and ask all objects that could have been kept.

#include <algorithm>

#include "backend/frame.h"
#include "backend/render/trace.h"
#include "backend/scene/objects.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Opaque objects that are large enough to have stood in a light's way at more than the tolerance.
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

/// @param lightDepth  how far along the ray the light is
bool Trace::IsInNearShadow(const Ray& ray, double lightDepth)
{
    Intersection nearest;
    nearest.Object = nearest.Csg = NULL;
    nearest.Depth = std::min(SMALL_TOLERANCE, lightDepth);
    return FindIntersection(nearest, ray, MayBeKept(), TrueRayObjectCondition());
}

} // namespace pov
