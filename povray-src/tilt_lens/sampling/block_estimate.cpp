// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/block_estimate.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

bool BlockEstimate::IsUniform() const
{
    return std::none_of(pixels.begin(), pixels.end(), [](const PixelEstimate& pixel)
        { return IsNonZero(pixel.statistics.Variation().variance); });
}

FirstRound::FirstRound(const BlockEstimate& estimate) : area(estimate.area), samples(estimate.firstSamples), uniform(estimate.IsUniform())
{
    pixels.reserve(area.Size());
    for (const PixelEstimate& pixel : estimate.pixels)
    {
        const PixelStatistics& own = pixel.statistics;
        const Radiance relative = RelativeTo(own.Mean(), own.Variation().variance);
        pixels.push_back({own.Variation(), std::sqrt(LargestChannel(relative))});
    }
    std::size_t inside = 0;
    for (std::uint32_t row = 1; row + 1 < area.height; row++)
        for (std::uint32_t column = 1; column + 1 < area.width; column++, inside++)
            loneVariance += LoneVarianceOf(column, row);
    loneVariance /= std::max<std::size_t>(inside, 1);
}

/// All eight neighbours of the pixel must lie in the block.
double FirstRound::LoneVarianceOf(std::uint32_t column, std::uint32_t row) const
{
    double around = 0.0;
    for (std::uint32_t y = row - 1; y <= row + 1; y++)
        for (std::uint32_t x = column - 1; x <= column + 1; x++)
            around += Square(pixels[y * area.width + x].deviation);
    const double own = Square(pixels[row * area.width + column].deviation);
    return std::max(0.0, 2.0 * own - around);
}

const FirstRound* FirstRoundAt(const FirstRounds& rounds, std::int64_t x, std::int64_t y)
{
    const Area& area = rounds[4]->area;
    const int column = x < area.left ? 0 : x < area.Right() ? 1 : 2;
    const int row = y < area.top ? 0 : y < area.Bottom() ? 1 : 2;
    return rounds[3 * row + column];
}

} // namespace tilt_lens
