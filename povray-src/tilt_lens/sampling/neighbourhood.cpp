// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/neighbourhood.h"

#include <algorithm>
#include <array>
#include <memory>

namespace tilt_lens
{

namespace
{

/// Merges variations into all pixels of rectangles. As in a segment tree, columns and rows are the leaves of a tree of halves each, of
/// which a node stands for the leaves below it: a rectangle is merged into the few pairs of nodes that make it up.
class RectangleSums
{
  public:
    /// To the block's pixels that are at most `reach` columns and rows from (x, y), which may lie beside the block.
    void Add(std::int64_t x, std::int64_t y, double reach, const SampleVariation& variation)
    {
        const std::int64_t most = std::int64_t(std::min(reach, 2.0 * kSide));
        ForEachNode(y - most, y + most, [&](int row)
            { ForEachNode(x - most, x + most, [&](int column) { nodes[row][column].Merge(variation); }); });
    }

    /// After the last rectangle: merges what nodes hold into their leaves.
    void Finish()
    {
        for (int row = 1; row < kSide; row++)
            for (int column = 1; column < 2 * kSide; column++)
                MergeInto(nodes[2 * row][column], nodes[2 * row + 1][column], nodes[row][column]);
        for (int row = kSide; row < 2 * kSide; row++)
            for (int column = 1; column < kSide; column++)
                MergeInto(nodes[row][2 * column], nodes[row][2 * column + 1], nodes[row][column]);
    }

    /// After Finish().
    const SampleVariation& At(int column, int row) const { return nodes[kSide + row][kSide + column]; }

  private:
    static constexpr int kSide = int(settings.blockSide);
    static_assert((kSide & (kSide - 1)) == 0, "all halves are whole");

    /// The root is node 1, the halves of node i are nodes 2 i and 2 i + 1, and leaf i is node kSide + i.
    std::array<std::array<SampleVariation, 2 * kSide>, 2 * kSide> nodes{};

    static void MergeInto(SampleVariation& half, SampleVariation& otherHalf, const SampleVariation& variation)
    {
        if (!IsNonZero(variation.variance))
            return;
        half.Merge(variation);
        otherHalf.Merge(variation);
    }

    /// The nodes that make up the leaves from `first` to `last`, as far as there are such.
    template<class Visit>
    static void ForEachNode(std::int64_t first, std::int64_t last, const Visit& visit)
    {
        int begin = kSide + int(std::max<std::int64_t>(first, 0)), end = kSide + int(std::min<std::int64_t>(last, kSide - 1)) + 1;
        for (; begin < end; begin /= 2, end /= 2)
        {
            if (begin % 2 == 1)
                visit(begin++);
            if (end % 2 == 1)
                visit(--end);
        }
    }
};

} // namespace

Neighbourhood::Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits) :
    rounds(rounds), blurred(rounds[4]->area.Size())
{
    if (!(limits.variance > 0.0))
        return;  // nobody asks
    double deviations = 0.0;
    std::size_t pixels = 0;
    for (const FirstRound* round : rounds)
        if (round != nullptr)
        {
            for (const FirstRoundPixel& pixel : round->pixels)
                deviations += pixel.deviation;
            pixels += round->pixels.size();
            uniformAround = uniformAround && (round == rounds[4] || round->uniform);
        }
    meanDeviation = deviations / pixels;
    if (!rounds[4]->uniform || !uniformAround)
        FindBlurred();
}

SampleVariation Neighbourhood::Around(const BlockEstimate& estimate, std::size_t pixel) const
{
    const Area& area = estimate.area;
    const std::int64_t column = pixel % area.width, row = pixel / area.width;
    SampleVariation around;
    int count = 0;
    for (std::int64_t y = row - settings.neighbourRadius; y <= row + settings.neighbourRadius; y++)
        for (std::int64_t x = column - settings.neighbourRadius; x <= column + settings.neighbourRadius; x++)
        {
            const FirstRound* round = nullptr;
            if (x >= 0 && x < area.width && y >= 0 && y < area.height)
                around.Merge(estimate.pixels[y * area.width + x].statistics.Variation());
            else if ((round = FirstRoundAt(rounds, area.left + x, area.top + y)) != nullptr)
                around.Merge(round->At(area.left + x, area.top + y).variation);
            else
                continue;
            count++;
        }
    DivideBy(around.variance, count);
    return around;
}

void Neighbourhood::FindBlurred()
{
    const Area& area = rounds[4]->area;
    const auto sums = std::make_unique<RectangleSums>();
    double count = 0.0;
    for (std::int64_t y = std::int64_t(area.top) - 1; y <= area.Bottom(); y++)
        for (std::int64_t x = std::int64_t(area.left) - 1; x <= area.Right(); x++)
        {
            const FirstRound* round = FirstRoundAt(rounds, x, y);
            if (round == nullptr || !round->area.Has(x, y))
                continue;
            count += 1.0;
            const FirstRoundPixel& other = round->At(x, y);
            if (IsNonZero(other.variation.variance))
                sums->Add(x - area.left, y - area.top, settings.blurReach * other.blurRadius, other.variation);
        }
    sums->Finish();
    for (std::size_t i = 0; i < blurred.size(); i++)
    {
        blurred[i] = sums->At(i % area.width, i / area.width);
        DivideBy(blurred[i].variance, count);
    }
}

} // namespace tilt_lens
