// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/neighbourhood.h"

#include <algorithm>

namespace tilt_lens
{

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
    SampleVariation everywhere;  // of what is blurred over the whole block
    int count = 0;
    for (std::int64_t y = std::int64_t(area.top) - 1; y <= area.Bottom(); y++)
        for (std::int64_t x = std::int64_t(area.left) - 1; x <= area.Right(); x++)
        {
            const FirstRound* round = FirstRoundAt(rounds, x, y);
            if (round == nullptr || !round->area.Has(x, y))
                continue;
            count++;
            const FirstRoundPixel& other = round->At(x, y);
            const double reach = settings.blurReach * other.blurRadius;
            if (reach >= settings.blockSide)
                everywhere.Merge(other.variation);
            else
                AddBlurred(x, y, reach, other.variation);
        }
    for (SampleVariation& variation : blurred)
    {
        variation.Merge(everywhere);
        DivideBy(variation.variance, count);
    }
}

/// To the block's pixels that are at most `reach` columns and rows from (x, y).
void Neighbourhood::AddBlurred(std::int64_t x, std::int64_t y, double reach, const SampleVariation& variation)
{
    if (!IsNonZero(variation.variance))
        return;
    const Area& area = rounds[4]->area;
    const std::int64_t most = std::int64_t(reach);
    for (std::int64_t v = std::max<std::int64_t>(area.top, y - most); v <= y + most && v < area.Bottom(); v++)
        for (std::int64_t u = std::max<std::int64_t>(area.left, x - most); u <= x + most && u < area.Right(); u++)
            blurred[area.IndexOf(u, v)].Merge(variation);
}

} // namespace tilt_lens
