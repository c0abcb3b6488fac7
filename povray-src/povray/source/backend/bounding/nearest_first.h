// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file nearest_first.h
/// Walks through a bounding hierarchy with a stack where stock has a queue: of a node's children the nearest is
/// followed at once, and boxes that begin behind what was found are never looked at. The nearest intersection is the
/// same; of two at exactly the same depth it may be the other one, which is why only pictures with `tilt_lens` go
/// this way: all others stay bit for bit what they are without this project.

#ifndef NEAREST_FIRST_H
#define NEAREST_FIRST_H

#include <cmath>
#include <cstring>

#include "backend/frame.h"
#include "backend/bounding/bbox.h"
#include "backend/bounding/child_boxes.h"
#include "backend/support/statistics.h"

namespace pov
{

/// Intersect_BBox_Tree(), for the hierarchy of a scene's objects.
/// @param best   intersections nearer than its depth are looked for; set to the nearest
/// @return       whether there is one
bool IntersectNearestFirst(PriorityQueue& queue, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           TraceThreadData* thread);

/// The same among objects and intersections that fulfil the conditions.
bool IntersectNearestFirst(PriorityQueue& queue, const BBOX_TREE* root, const Ray& ray, Intersection* best,
                           const RayObjectCondition& precondition, const RayObjectCondition& postcondition,
                           TraceThreadData* thread);

/// A ray as boxes see it, for four of them at a time.
class SlabRay
{
  public:
    typedef float Four __attribute__((vector_size(16)));

    explicit SlabRay(const Ray& ray)
    {
        for (int axis = X; axis <= Z; axis++)
        {
            start[axis] = Fours(ray.Origin[axis]);
            inverse[axis] = Fours(1.0 / ray.Direction[axis]);
        }
    }

    /// Whether Enter() can be asked: of no product of such numbers with a coordinate it gets an overflow or 0/0.
    bool IsRegular() const
    {
        return std::fabs(inverse[X][0]) < 1e26f && std::fabs(inverse[Y][0]) < 1e26f && std::fabs(inverse[Z][0]) < 1e26f;
    }

    /// @param limit  boxes that begin behind it do not count
    /// @param enter  is set to where the ray enters the boxes
    /// @return       bits of the finite boxes that it meets
    unsigned int Enter(const FourBoxes& boxes, float limit, Four& enter) const
    {
        Four leave;
        Cross(boxes, X, enter, leave);
        for (int axis = Y; axis <= Z; axis++)
        {
            Four near, far;
            Cross(boxes, axis, near, far);
            enter = Greater(enter, near);
            leave = Less(leave, far);
        }
        return SignBits((enter <= Less(leave, Fours(limit))) & (leave >= float(EPSILON))) & boxes.finite;
    }

  private:
    typedef int Mask __attribute__((vector_size(16)));
    Four start[3], inverse[3];

    static Four Fours(float x) { return Four{x, x, x, x}; }
    static Four Less(Four a, Four b) { return a < b ? a : b; }
    static Four Greater(Four a, Four b) { return a > b ? a : b; }

    void Cross(const FourBoxes& boxes, int axis, Four& near, Four& far) const
    {
        Four lowerLeft, lengths;
        std::memcpy(&lowerLeft, boxes.lowerLeft[axis], sizeof(Four));
        std::memcpy(&lengths, boxes.lengths[axis], sizeof(Four));
        const Four one = (lowerLeft - start[axis]) * inverse[axis], other = one + lengths * inverse[axis];
        near = Less(one, other);
        far = Greater(one, other);
    }

    static unsigned int SignBits(Mask mask)
    {
#ifdef __SSE2__
        return __builtin_ia32_movmskps((Four)mask);
#else
        unsigned int bits = 0;
        for (int i = 0; i < 4; i++)
            bits |= (mask[i] < 0 ? 1u : 0u) << i;
        return bits;
#endif
    }
};

/// Calls `test` for every leaf whose box the ray enters no later than at `limit`, which that may lower. Of each four
/// children the nearest comes first.
/// @param ray   must be regular
/// @param test  called with the leaf
template<class Test>
void WalkNearestFirst(const BBOX_TREE* root, const SlabRay& ray, const DBL& limit, RenderStatistics& statistics,
                      const Test& test)
{
    struct Waiting
    {
        float begin;  ///< where the ray enters
        const BBOX_TREE* node;
    };
    constexpr int room = 64;
    Waiting waiting[room];
    Waiting* top = waiting;
    *top++ = {-float(MAX_DISTANCE), root};
    float nearest = limit;
    unsigned int tested = 0, entered = 0;
    while (top != waiting)
    {
        const Waiting next = *--top;
        if (next.begin > nearest)
            continue;
        if (next.node->Entries == 0)
        {
            test(next.node);
            nearest = limit;
            continue;
        }
        const FourBoxes* four = BoxesOf(next.node);
        for (int first = 0; first < next.node->Entries; first += 4, four++)
        {
            SlabRay::Four begin;
            const unsigned int met = ray.Enter(*four, nearest, begin);
            tested += four->tested;
            Waiting* const base = top;
            for (unsigned int rest = met | four->infinite; rest != 0; rest &= rest - 1)
            {
                const int i = __builtin_ctz(rest);
                const bool finite = (met >> i) & 1;
                entered += finite;
                const Waiting child = {finite ? begin[i] : -float(MAX_DISTANCE), next.node->Node[first + i]};
                if (top == waiting + room)
                {
                    WalkNearestFirst(child.node, ray, limit, statistics, test);
                    nearest = limit;
                    continue;
                }
                Waiting* place = top++;
                for (; place > base && place[-1].begin < child.begin; place--)
                    *place = place[-1];
                *place = child;
            }
        }
    }
    statistics[nChecked] += tested;
    statistics[nEnqueued] += entered;
}

} // namespace pov

#endif
