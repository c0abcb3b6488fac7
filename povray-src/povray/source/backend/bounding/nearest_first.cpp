// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/bounding/nearest_first.h"

#include "backend/scene/objects.h"
#include "backend/scene/threaddata.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Looks for the nearest intersection with an object whose box was met; as Find_Intersection() does, but leaves alone
/// what is not nearer than the best.
template<class Condition>
bool FindNearer(ObjectPtr object, const Ray& ray, Intersection* best, TraceThreadData* thread, const Condition& condition)
{
    if (!object->Bound.empty() && !Ray_In_Bound(ray, object->Bound, thread))
        return false;
    IStack hits(thread->stackPool);
    bool found = false;
    if (object->All_Intersections(ray, hits, thread))
        for (; !hits->empty(); hits->pop())
        {
            const Intersection& hit = hits->top();
            if (hit.Depth < best->Depth && (ray.IsSubsurfaceRay() || hit.Depth >= MIN_ISECT_DEPTH) && condition(hit.Depth))
            {
                *best = hit;
                found = true;
            }
        }
    return found;
}

ObjectPtr ObjectOf(const BBOX_TREE* leaf) { return reinterpret_cast<ObjectPtr>(leaf->Node); }

} // namespace

bool IntersectNearestFirst(PriorityQueue& queue, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           TraceThreadData* thread)
{
    const SlabRay slabRay(ray);
    if (!slabRay.IsRegular())
        return Intersect_BBox_Tree(queue, root, ray, best, thread);
    bool found = false;
    WalkNearestFirst(root, slabRay, best->Depth, thread->Stats(), [&](const BBOX_TREE* leaf)
    {
        found |= FindNearer(ObjectOf(leaf), ray, best, thread, [](DBL) { return true; });
    });
    return found;
}

bool IntersectNearestFirst(PriorityQueue& queue, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                           TraceThreadData* thread)
{
    const SlabRay slabRay(ray);
    if (!slabRay.IsRegular())
        return Intersect_BBox_Tree(queue, root, ray, best, precondition, postcondition, thread);
    bool found = false;
    WalkNearestFirst(root, slabRay, best->Depth, thread->Stats(), [&](const BBOX_TREE* leaf)
    {
        const ObjectPtr object = ObjectOf(leaf);
        if (precondition(ray, object, 0.0))
            found |= FindNearer(object, ray, best, thread, [&](DBL depth) { return postcondition(ray, object, depth); });
    });
    return found;
}

} // namespace pov
