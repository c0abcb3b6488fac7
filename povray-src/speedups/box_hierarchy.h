// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file box_hierarchy.h
/// Bounding volume hierarchy of axis-aligned boxes, built by the binned surface area heuristic (I. Wald, "On fast Construction of SAH-based
/// Bounding Volume Hierarchies", 2007).

#ifndef SPEEDUPS_BOX_HIERARCHY_H
#define SPEEDUPS_BOX_HIERARCHY_H

#include <cstdint>
#include <utility>
#include <vector>

#include "speedups/box_ray.h"

namespace speedups
{

struct BoxItem
{
    float lower[3], upper[3];
    const void* what;
};

class BoxHierarchy
{
  public:
    static constexpr int kMostLevels = 40;

    /// @param items  finite boxes that bound their items in exact arithmetic
    explicit BoxHierarchy(std::vector<BoxItem> items);

    std::size_t Bytes() const { return nodes.size() * sizeof(Node) + whats.size() * sizeof(void*); }

    struct Count
    {
        unsigned int tested = 0;
        unsigned int entered = 0;
    };

    /// Calls test(item) for each item whose box the ray enters at or before `limit`, a node's nearer children first.
    /// @param origin, direction  in the boxes' frame and unit; the direction may have any length but 0
    /// @param limit              ray parameter, in lengths of the direction; tests may lower it
    template<class Vector, class Test>
    Count Walk(const double* origin, const double* direction, const double& limit, const Test& test) const;

  private:
    friend class HierarchyBuilder;

    struct Node
    {
        EightBoxes boxes;
        std::int32_t children[8];  ///< index of a node, or ~i for item i
    };

    struct Waiting
    {
        float begin;
        std::int32_t child;
    };

    static TILT_LENS_INLINED Waiting Take(const Node& node, const float* begin, unsigned int& met, Count& count)
    {
        const int i = __builtin_ctz(met);
        met &= met - 1;
        count.entered++;
        return {begin[i], node.children[i]};
    }

    /// Pushes the other children on the stack.
    static Waiting TakeNearest(const Node& node, const float* begin, unsigned int met, Waiting*& top, Count& count);

    std::vector<Node> nodes;
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
    // rounded up: no box is lost
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
        }
        while (next.begin > farthest);
    }
}

}  // namespace speedups

#endif
