// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file child_boxes.h
/// The bounding boxes of a node's children side by side, so that a ray is tested against four of them at a
/// time and without a visit to each child. The results of Enter() are those of Check_And_Enqueue() to the last
/// bit: the same operations in the same order and precision. Rays for which single precision could overflow,
/// or that run along an axis, are left to it.

#ifndef CHILD_BOXES_H
#define CHILD_BOXES_H

#include <cmath>
#include <cstddef>
#include <cstring>

#include "backend/frame.h"
#include "backend/bounding/bbox.h"

namespace pov
{

/// Four children's boxes; unused ones are filled with zeros and left out of `finite`.
struct FourBoxes
{
    float lowerLeft[3][4];
    float lengths[3][4];
    unsigned int finite, infinite;  ///< one bit a child; who is infinite is met by every ray
    unsigned int tested;            ///< number of finite children
};

/// The boxes lie in one piece of memory with the pointers to the children, behind these.
inline size_t BoxesBehind(int children) { return (children * sizeof(BBOX_TREE *) + 15) / 16 * 16; }

inline const FourBoxes* BoxesOf(const BBOX_TREE* node)
{
    return reinterpret_cast<const FourBoxes*>(reinterpret_cast<const char*>(node->Node) + BoxesBehind(node->Entries));
}

/// Adds the boxes to all nodes of a finished tree: of each mesh, and of the objects of a scene with tilt_lens. Each of
/// these must be given to this once: nothing says of a node whether it has them.
void GatherChildBoxes(BBOX_TREE* root);

/// A ray as the boxes see it.
class BoxRay
{
  public:
    explicit BoxRay(const Rayinfo& info) : info(info), regular(true)
    {
        for (int axis = X; axis <= Z; axis++)
            // no product of such numbers with a coordinate overflows, and none is 0/0
            regular = regular && info.nonzero[axis] && std::fabs(info.slab_den[axis]) < 1e26f;
    }

    const Rayinfo& info;
    bool regular;  ///< whether Enter() can be asked

    /// @param depth  is set to where the ray enters the boxes that it meets
    /// @return       bits of the finite boxes that it meets
    unsigned int Enter(const FourBoxes& boxes, DBL depth[4]) const
    {
        return (EnterTwo(boxes, 0, depth) | EnterTwo(boxes, 2, depth)) & boxes.finite;
    }

  private:
    typedef float TwoFloats __attribute__((vector_size(8)));
    typedef double Two __attribute__((vector_size(16)));
    typedef long long Mask __attribute__((vector_size(16)));

    /// Where the ray enters and leaves two boxes. Products are rounded to floats as Check_And_Enqueue()'s are, their
    /// sum is a double.
    unsigned int EnterTwo(const FourBoxes& boxes, int first, DBL* depth) const
    {
        Two enter = Two() - HUGE_VAL, leave = Two() + HUGE_VAL;
        for (int axis = X; axis <= Z; axis++)
        {
            TwoFloats lowerLeft, lengths;
            std::memcpy(&lowerLeft, boxes.lowerLeft[axis] + first, sizeof(TwoFloats));
            std::memcpy(&lengths, boxes.lengths[axis] + first, sizeof(TwoFloats));
            const Two one = __builtin_convertvector((lowerLeft - info.slab_num[axis]) * info.slab_den[axis], Two);
            const Two other = one + __builtin_convertvector(lengths * info.slab_den[axis], Two);
            const Two near = info.positive[axis] ? one : other, far = info.positive[axis] ? other : one;
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
        std::memcpy(depth + first, &enter, sizeof(Two));
        const Mask mask = (enter <= leave) & (leave >= EPSILON);
#ifdef __SSE2__
        return __builtin_ia32_movmskpd((Two)mask) << first;
#else
        return ((mask[0] < 0 ? 1u : 0u) | (mask[1] < 0 ? 2u : 0u)) << first;
#endif
    }
};

/// Check_And_Enqueue() for all children of a node, in their order.
void Check_And_Enqueue_Children(PriorityQueue& Queue, const BBOX_TREE *Node, const BoxRay& ray, TraceThreadData *Thread);

} // namespace pov

#endif
