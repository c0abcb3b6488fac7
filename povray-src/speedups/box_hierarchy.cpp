// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "speedups/box_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace speedups
{

namespace
{

constexpr float kFloatMost = std::numeric_limits<float>::max();

typedef std::vector<BoxItem>::iterator ItemIterator;

struct Bounds
{
    Float4 lower = Float4() + kFloatMost, upper = Float4() - kFloatMost;

    void Include(const BoxItem& item)
    {
        Include(Float4{item.lower[0], item.lower[1], item.lower[2], 0.0f}, Float4{item.upper[0], item.upper[1], item.upper[2], 0.0f});
    }

    void Include(const Bounds& other) { Include(other.lower, other.upper); }

    void Include(const Float4& otherLower, const Float4& otherUpper)
    {
        lower = Min(lower, otherLower);
        upper = Max(upper, otherUpper);
    }

    double Area() const
    {
        const double x = double(upper[0]) - lower[0], y = double(upper[1]) - lower[1], z = double(upper[2]) - lower[2];
        return x * (y + z) + y * z;
    }
};

double Middle(const BoxItem& item, int axis)
{
    return double(item.lower[axis]) + item.upper[axis];
}

struct Range
{
    ItemIterator begin, end;
    Bounds bounds;

    Range(ItemIterator itsBegin, ItemIterator itsEnd) : begin(itsBegin), end(itsEnd)
    {
        for (ItemIterator item = begin; item != end; ++item)
            bounds.Include(*item);
    }

    std::ptrdiff_t Size() const { return end - begin; }
};

class Bins
{
  public:
    static constexpr int kNumber = 16;

    Bins(const Range& range, int itsAxis) : axis(itsAxis)
    {
        double least = HUGE_VAL, most = -HUGE_VAL;
        for (ItemIterator item = range.begin; item != range.end; ++item)
        {
            least = std::min(least, Middle(*item, axis));
            most = std::max(most, Middle(*item, axis));
        }
        start = least;
        scale = most > least ? kNumber / (most - least) : HUGE_VAL;
        if (!(scale < HUGE_VAL))
            return;
        for (ItemIterator item = range.begin; item != range.end; ++item)
        {
            Bin& bin = bins[Of(*item)];
            bin.bounds.Include(*item);
            bin.items++;
        }
        FindSplit();
    }

    int Of(const BoxItem& item) const { return std::min(kNumber - 1, int((Middle(item, axis) - start) * scale)); }

    double Cost() const { return cost; }  ///< sum of area times items; infinite: no split
    int Split() const { return split; }

  private:
    struct Bin
    {
        Bounds bounds;
        std::ptrdiff_t items = 0;

        double Cost() const { return items == 0 ? 0.0 : bounds.Area() * items; }
        void Add(const Bin& other)
        {
            bounds.Include(other.bounds);
            items += other.items;
        }
    };

    int axis;
    double start, scale;
    Bin bins[kNumber];
    double cost = HUGE_VAL;
    int split = 0;

    void FindSplit()
    {
        Bin sum;
        double right[kNumber];
        for (int i = kNumber - 1; i > 0; i--)
        {
            sum.Add(bins[i]);
            right[i] = sum.Cost();
        }
        sum = Bin();
        for (int i = 1; i < kNumber; i++)
        {
            sum.Add(bins[i - 1]);
            if (sum.Cost() + right[i] < cost)
            {
                cost = sum.Cost() + right[i];
                split = i;
            }
        }
    }
};

/// Deeper nodes split evenly: 14 more levels hold 8^14 = 2^42 items.
constexpr int kEvenFrom = BoxHierarchy::kMostLevels - 14;

ItemIterator SplitInHalves(const Range& range)
{
    int axis = 0;
    for (int other = 1; other < 3; other++)
        if (range.bounds.upper[other] - range.bounds.lower[other] > range.bounds.upper[axis] - range.bounds.lower[axis])
            axis = other;
    const ItemIterator middle = range.begin + range.Size() / 2;
    std::nth_element(range.begin, middle, range.end,
                     [axis](const BoxItem& a, const BoxItem& b) { return Middle(a, axis) < Middle(b, axis); });
    return middle;
}

/// Splits at least two items; returns the second part's beginning. No part is empty.
ItemIterator Split(const Range& range, bool even)
{
    if (even)
        return SplitInHalves(range);
    const Bins bins[3] = {Bins(range, 0), Bins(range, 1), Bins(range, 2)};
    const Bins* best = bins;
    for (const Bins& other : bins)
        if (other.Cost() < best->Cost())
            best = &other;
    if (!(best->Cost() < HUGE_VAL))
        return SplitInHalves(range);
    return std::partition(range.begin, range.end, [best](const BoxItem& item) { return best->Of(item) < best->Split(); });
}

} // namespace

class HierarchyBuilder
{
  public:
    HierarchyBuilder(BoxHierarchy& itsHierarchy, std::vector<BoxItem>& itsItems) : hierarchy(itsHierarchy), items(itsItems) {}

    void Build()
    {
        if (!items.empty())
            BuildNode(Range(items.begin(), items.end()), 0);
        hierarchy.whats.reserve(items.size());
        for (const BoxItem& item : items)
            hierarchy.whats.push_back(item.what);
    }

  private:
    BoxHierarchy& hierarchy;
    std::vector<BoxItem>& items;

    std::vector<Range> Parts(const Range& range, int level) const
    {
        const bool even = level >= kEvenFrom;
        std::vector<Range> parts(1, range);
        while (parts.size() < 8)
        {
            const auto weight = [even](const Range& part)
            {
                return part.Size() < 2 ? -1.0 : even ? double(part.Size()) : part.bounds.Area();
            };
            Range& largest = *std::max_element(parts.begin(), parts.end(),
                                               [&](const Range& a, const Range& b) { return weight(a) < weight(b); });
            if (largest.Size() < 2)
                break;
            const Range whole = largest;
            const ItemIterator middle = Split(whole, even);
            largest = Range(whole.begin, middle);
            parts.emplace_back(middle, whole.end);
        }
        return parts;
    }

    std::int32_t BuildNode(const Range& range, int level)
    {
        const std::vector<Range> parts = Parts(range, level);
        const std::int32_t number = hierarchy.nodes.size();
        hierarchy.nodes.emplace_back();
        for (std::size_t i = 0; i < 8; i++)
        {
            const Bounds bounds = i < parts.size() ? parts[i].bounds : Bounds();
            for (int axis = 0; axis < 3; axis++)
            {
                hierarchy.nodes[number].boxes.planes[axis][i] = bounds.lower[axis];
                hierarchy.nodes[number].boxes.planes[axis + 3][i] = bounds.upper[axis];
            }
            if (i >= parts.size())
                continue;
            const std::int32_t child = parts[i].Size() == 1 ? ~std::int32_t(parts[i].begin - items.begin())
                                                            : BuildNode(parts[i], level + 1);
            hierarchy.nodes[number].children[i] = child;
        }
        return number;
    }
};

BoxHierarchy::BoxHierarchy(std::vector<BoxItem> items)
{
    HierarchyBuilder(*this, items).Build();
}

} // namespace speedups
