// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/bounding/nearest_first.h"

#include "backend/bounding/child_boxes.h"
#include "backend/scene/objects.h"
#include "backend/scene/threaddata.h"

// this must be the last file included
#include "base/povdebug.h"

namespace pov
{

namespace
{

typedef PriorityQueue::Qelem Waiting;

/// Room for a number of elements more.
void Reserve(PriorityQueue& stack, unsigned int more)
{
    if (stack.QSize + more <= stack.Max_QSize)
        return;
    stack.Max_QSize = 2 * (stack.QSize + more);
    stack.Queue = reinterpret_cast<Waiting*>(
        POV_REALLOC(stack.Queue, stack.Max_QSize * sizeof(Waiting), "priority queue"));
}

/// Puts the children that begin before `limit` onto the stack, of each four the nearest on top.
void PushChildren(PriorityQueue& stack, const BBOX_TREE* node, const BoxRay& ray, DBL limit, TraceThreadData* thread)
{
    Reserve(stack, node->Entries);
    const FourBoxes* four = BoxesOf(node);
    for (int first = 0; first < node->Entries; first += 4, four++)
    {
        float depth[4];
        const unsigned int met = ray.EnterRounded(*four, depth);
        thread->Stats()[nChecked] += four->tested;
        Waiting* const base = stack.Queue + stack.QSize;
        Waiting* top = base;
        for (unsigned int rest = met | four->infinite; rest != 0; rest &= rest - 1)
        {
            const int i = __builtin_ctz(rest);
            const bool finite = (met >> i) & 1;
            const DBL begin = finite ? DBL(depth[i]) : -MAX_DISTANCE;
            if (begin > limit)
                continue;
            thread->Stats()[nEnqueued] += finite;
            Waiting* place = top++;
            for (; place > base && place[-1].depth < begin; place--)
                *place = place[-1];
            place->depth = begin;
            place->node = node->Node[first + i];
        }
        stack.QSize += top - base;
    }
}

/// @param test  whether an object is met, and where
template<class Test>
bool Walk(PriorityQueue& stack, const BBOX_TREE* root, const BoxRay& ray, Intersection* best, TraceThreadData* thread,
          const Test& test)
{
    bool found = false;
    Intersection met;
    met.Object = NULL;
    stack.QSize = 0;
    Reserve(stack, 1);
    stack.Queue[stack.QSize++] = {-MAX_DISTANCE, root};
    while (stack.QSize > 0)
    {
        const Waiting next = stack.Queue[--stack.QSize];
        if (next.depth > best->Depth)
            continue;
        if (next.node->Entries > 0)
            PushChildren(stack, next.node, ray, best->Depth, thread);
        else if (test(&met, reinterpret_cast<ObjectPtr>(next.node->Node)) && met.Depth < best->Depth)
        {
            *best = met;
            found = true;
        }
    }
    return found;
}

/// What an object's own box wants to know of the ray; equal to what Find_Intersection() works out itself.
ObjectBase::BBoxDirection VariantOf(const Rayinfo& info)
{
    return ObjectBase::BBoxDirection((int(info.slab_den[X] < 0.0) << 2) | (int(info.slab_den[Y] < 0.0) << 1) |
                                     int(info.slab_den[Z] < 0.0));
}

} // namespace

bool IntersectNearestFirst(PriorityQueue& stack, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           TraceThreadData* thread)
{
    const Rayinfo info(ray);
    const BoxRay boxRay(info);
    if (!boxRay.regular)
        return Intersect_BBox_Tree(stack, root, ray, best, thread);
    const ObjectBase::BBoxDirection variant = VariantOf(info);
    return Walk(stack, root, boxRay, best, thread, [&](Intersection* met, ObjectPtr object)
    {
        return Find_Intersection(met, object, ray, variant, info.slab_num, info.slab_den, thread);
    });
}

bool IntersectNearestFirst(PriorityQueue& stack, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                           TraceThreadData* thread)
{
    const Rayinfo info(ray);
    const BoxRay boxRay(info);
    if (!boxRay.regular)
        return Intersect_BBox_Tree(stack, root, ray, best, precondition, postcondition, thread);
    const ObjectBase::BBoxDirection variant = VariantOf(info);
    return Walk(stack, root, boxRay, best, thread, [&](Intersection* met, ObjectPtr object)
    {
        return precondition(ray, object, 0.0) &&
               Find_Intersection(met, object, ray, variant, info.slab_num, info.slab_den, postcondition, thread);
    });
}

} // namespace pov
