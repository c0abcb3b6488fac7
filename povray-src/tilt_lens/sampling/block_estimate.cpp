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

FirstRound::FirstRound(const BlockEstimate& estimate, std::uint32_t samples) :
    area(estimate.area), uniform(estimate.IsUniform()), hitFraction(0.0), greatestHitFraction(0.0)
{
    std::uint64_t allHits = 0;
    Quadrants hits{}, taken{};
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        const PixelStatistics& pixel = estimate.pixels[i].statistics;
        const std::size_t quadrant = estimate.QuadrantOf(i);
        const Radiance relative = RelativeTo(pixel.Mean(), pixel.Variation().variance);
        pixels.push_back({pixel.Variation(), std::sqrt(LargestChannel(relative)), pixel.BlurRadius()});
        hits[quadrant] += pixel.Hits();
        taken[quadrant] += samples;
        allHits += pixel.Hits();
    }
    hitFraction = double(allHits) / samples / pixels.size();
    for (std::size_t quadrant = 0; quadrant < taken.size(); quadrant++)
        greatestHitFraction = std::max(greatestHitFraction, hits[quadrant] / std::max(1.0, taken[quadrant]));
}

const FirstRound* FirstRoundAt(const FirstRounds& rounds, std::int64_t x, std::int64_t y)
{
    const Area& area = rounds[4]->area;
    const int column = x < area.left ? 0 : x < area.Right() ? 1 : 2;
    const int row = y < area.top ? 0 : y < area.Bottom() ? 1 : 2;
    return rounds[3 * row + column];
}

} // namespace tilt_lens
