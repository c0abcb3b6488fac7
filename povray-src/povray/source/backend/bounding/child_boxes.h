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

    /// The same but for the rounding of the sum: faster, and for those who need not take stock's every decision.
    unsigned int EnterRounded(const FourBoxes& boxes, float depth[4]) const
    {
        Four enter, leave;
        Cross<Four>(boxes, 0, enter, leave);
        std::memcpy(depth, &enter, sizeof(Four));
        return SignBits((FourMask)((enter <= leave) & (leave >= float(EPSILON)))) & boxes.finite;
    }

  private:
    typedef float Four __attribute__((vector_size(16)));
    typedef int FourMask __attribute__((vector_size(16)));
    typedef float TwoFloats __attribute__((vector_size(8)));
    typedef double Two __attribute__((vector_size(16)));
    typedef long long Mask __attribute__((vector_size(16)));

    /// Where the ray enters and leaves boxes, from the one numbered `first` on. Products are rounded to floats, their
    /// sum to what Sums holds; Check_And_Enqueue()'s is a double.
    template<class Floats, class Sums>
    void Cross(const FourBoxes& boxes, int first, Sums& enter, Sums& leave) const
    {
        enter = Sums() - HUGE_VALF;
        leave = Sums() + HUGE_VALF;
        for (int axis = X; axis <= Z; axis++)
        {
            Floats lowerLeft, lengths;
            std::memcpy(&lowerLeft, boxes.lowerLeft[axis] + first, sizeof(Floats));
            std::memcpy(&lengths, boxes.lengths[axis] + first, sizeof(Floats));
            const Sums one = __builtin_convertvector((lowerLeft - info.slab_num[axis]) * info.slab_den[axis], Sums);
            const Sums other = one + __builtin_convertvector(lengths * info.slab_den[axis], Sums);
            const Sums near = info.positive[axis] ? one : other, far = info.positive[axis] ? other : one;
            enter = near > enter ? near : enter;
            leave = far < leave ? far : leave;
        }
    }

    unsigned int EnterTwo(const FourBoxes& boxes, int first, DBL* depth) const
    {
        Two enter, leave;
        Cross<TwoFloats>(boxes, first, enter, leave);
        std::memcpy(depth + first, &enter, sizeof(Two));
        return SignBits((Mask)((enter <= leave) & (leave >= EPSILON))) << first;
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
