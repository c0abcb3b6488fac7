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

/// Adds the boxes to all nodes of a finished tree. Every tree must be given to this once: nothing says of a node
/// whether it has them.
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
        return (EnterTwo<0>(boxes, depth) | EnterTwo<2>(boxes, depth)) & boxes.finite;
    }

    /// The same but for the rounding of the sum: faster, and for those who need not take stock's every decision.
    unsigned int EnterRounded(const FourBoxes& boxes, float depth[4]) const
    {
        Four enter = {-HUGE_VALF, -HUGE_VALF, -HUGE_VALF, -HUGE_VALF}, leave = -enter;
        for (int axis = X; axis <= Z; axis++)
        {
            Four lowerLeft, lengths;
            std::memcpy(&lowerLeft, boxes.lowerLeft[axis], sizeof(Four));
            std::memcpy(&lengths, boxes.lengths[axis], sizeof(Four));
            const Four one = (lowerLeft - info.slab_num[axis]) * info.slab_den[axis];
            const Four other = one + lengths * info.slab_den[axis];
            const Four first = info.positive[axis] ? one : other, last = info.positive[axis] ? other : one;
            enter = first > enter ? first : enter;
            leave = last < leave ? last : leave;
        }
        std::memcpy(depth, &enter, sizeof(Four));
        return SignBits((FourMask)((enter <= leave) & (leave >= float(EPSILON)))) & boxes.finite;
    }

  private:
    typedef float Four __attribute__((vector_size(16)));
    typedef int FourMask __attribute__((vector_size(16)));
    typedef float TwoFloats __attribute__((vector_size(8)));
    typedef double Two __attribute__((vector_size(16)));
    typedef long long Mask __attribute__((vector_size(16)));

    /// Products are rounded to floats, their sum is not: so does Check_And_Enqueue().
    template<int First>
    unsigned int EnterTwo(const FourBoxes& boxes, DBL* depth) const
    {
        Two enter = {-HUGE_VAL, -HUGE_VAL}, leave = {HUGE_VAL, HUGE_VAL};
        for (int axis = X; axis <= Z; axis++)
        {
            TwoFloats lowerLeft, lengths;
            std::memcpy(&lowerLeft, boxes.lowerLeft[axis] + First, sizeof(TwoFloats));
            std::memcpy(&lengths, boxes.lengths[axis] + First, sizeof(TwoFloats));
            const Two one = __builtin_convertvector((lowerLeft - info.slab_num[axis]) * info.slab_den[axis], Two);
            const Two other = one + __builtin_convertvector(lengths * info.slab_den[axis], Two);
            const Two first = info.positive[axis] ? one : other, last = info.positive[axis] ? other : one;
            enter = first > enter ? first : enter;
            leave = last < leave ? last : leave;
        }
        std::memcpy(depth + First, &enter, sizeof(Two));
        return SignBits((Mask)((enter <= leave) & (leave >= EPSILON))) << First;
    }

    static unsigned int SignBits(Mask mask)
    {
#ifdef __SSE2__
        return __builtin_ia32_movmskpd((Two)mask);
#else
        return (mask[0] < 0 ? 1u : 0u) | (mask[1] < 0 ? 2u : 0u);
#endif
    }

    static unsigned int SignBits(FourMask mask)
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

/// Check_And_Enqueue() for all children of a node, in their order.
void Check_And_Enqueue_Children(PriorityQueue& Queue, const BBOX_TREE *Node, const BoxRay& ray, TraceThreadData *Thread);

} // namespace pov

#endif
