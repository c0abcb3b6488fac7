// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file box_hierarchy.h
/// A bounding volume hierarchy of axis-aligned boxes with eight children a node, for rays that look for what is nearest.
/// It is made by the surface area heuristic with bins (I. Wald, "On fast Construction of SAH-based Bounding Volume
/// Hierarchies", 2007), and lies flat in memory. What it holds and how that meets a ray is the caller's.

#ifndef TILT_LENS_BOX_HIERARCHY_H
#define TILT_LENS_BOX_HIERARCHY_H

#include <cstdint>
#include <utility>
#include <vector>

#include "tilt_lens/hierarchy/box_ray.h"

namespace tilt_lens
{

/// A box and what it bounds.
struct BoxItem
{
    float lower[3], upper[3];
    const void* what;
};

class BoxHierarchy
{
  public:
    /// No hierarchy has more levels of nodes than that, whatever the boxes.
    static constexpr int kMostLevels = 40;

    /// @param items  with finite boxes, which bound what they hold in exact arithmetic
    explicit BoxHierarchy(std::vector<BoxItem> items);

    std::size_t Bytes() const { return nodes.size() * sizeof(Node) + whats.size() * sizeof(void*); }

    struct Count
    {
        unsigned int tested = 0;   ///< boxes
        unsigned int entered = 0;  ///< of these, boxes that the ray met
    };

    /// Calls test(what) for all whose boxes the ray enters no later than at `limit`, of each eight children for the nearest
    /// first. The order is the same whatever the Vector.
    /// @tparam Vector  as of BoxRay: Float8 within functions for AVX2, else Float4
    /// @param origin, direction  of the ray, three numbers each, in the boxes' frame and unit; the direction has any length but 0
    /// @param limit  in lengths of the ray's direction; read again after each test, which may lower it
    template<class Vector, class Test>
    Count Walk(const double* origin, const double* direction, const double& limit, const Test& test) const;

  private:
    friend class HierarchyBuilder;

    struct Node
    {
        EightBoxes boxes;
        std::int32_t children[8];  ///< numbers of nodes; ~i stands for whats[i]
    };

    struct Waiting
    {
        float begin;  ///< where the ray enters
        std::int32_t child;
    };

    /// The first child that was met, which is taken from these.
    static TILT_LENS_INLINED Waiting Take(const Node& node, const float* begin, unsigned int& met, Count& count)
    {
        const int i = __builtin_ctz(met);
        met &= met - 1;
        count.entered++;
        return {begin[i], node.children[i]};
    }

    /// The nearest of the children that were met; the others wait on the stack, the nearer ones above the farther ones.
    static Waiting TakeNearest(const Node& node, const float* begin, unsigned int met, Waiting*& top, Count& count);

    std::vector<Node> nodes;  ///< the first one is the root; none if there is nothing
    std::vector<const void*> whats;
};

TILT_LENS_INLINED BoxHierarchy::Waiting BoxHierarchy::TakeNearest(const Node& node, const float* begin, unsigned int met, Waiting*& top,
                                                                  Count& count)
{
    const Waiting* const base = top;
    Waiting nearest = Take(node, begin, met, count);
    while (met != 0)
    {
        Waiting other = Take(node, begin, met, count);
        if (other.begin < nearest.begin)
            std::swap(other, nearest);
        Waiting* place = top++;
        for (; place > base && place[-1].begin < other.begin; place--)
            *place = place[-1];
        *place = other;
    }
    return nearest;
}

template<class Vector, class Test>
TILT_LENS_INLINED BoxHierarchy::Count BoxHierarchy::Walk(const double* origin, const double* direction, const double& limit,
                                                         const Test& test) const
{
    Count count;
    if (nodes.empty())
        return count;
    const BoxRay<Vector> ray(origin, direction);
    Waiting waiting[7 * kMostLevels + 8];
    Waiting* top = waiting;
    // rounded up
    const auto reach = [&limit] { return float(limit * (1.0 + 1.2e-7)); };
    float farthest = reach();
    Waiting next = {0.0f, 0};
    for (;;)
    {
        if (next.child < 0)
        {
            test(whats[~next.child]);
            farthest = reach();
        }
        else
        {
            const Node& node = nodes[next.child];
            alignas(32) float begin[8];
            unsigned int met = ray.Enter(node.boxes, farthest, begin);
            count.tested += 8;
            if (met != 0)
            {
                next = TakeNearest(node, begin, met, top, count);
                continue;
            }
        }
        do
        {
            if (top == waiting)
                return count;
            next = *--top;
        } while (next.begin > farthest);
    }
}

} // namespace tilt_lens

#endif
