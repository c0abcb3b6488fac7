// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/neighbourhood.h"

#include <algorithm>

namespace tilt_lens
{

Neighbourhood::Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits) :
    rounds(rounds)
{
    if (!(limits.variance > 0.0))
        return;  // not used then
    double deviations = 0.0;
    std::size_t pixels = 0;
    for (const FirstRound* round : rounds)
        if (round != nullptr)
        {
            for (const FirstRoundPixel& pixel : round->pixels)
                deviations += pixel.deviation;
            pixels += round->pixels.size();
            loneVariance += round->loneVariance * round->pixels.size();
            uniformAround = uniformAround && (round == rounds[4] || round->uniform);
        }
    meanDeviation = deviations / pixels;
    loneVariance /= pixels;
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

std::shared_ptr<const PaddedSpread> Neighbourhood::Spread() const
{
    PaddedSpread::Sent sent;
    std::transform(rounds.begin(), rounds.end(), sent.begin(), [](const FirstRound* round)
        { return round != nullptr ? round->spread.get() : nullptr; });
    return PaddedSpread::Of(sent, rounds[4]->samples);
}

} // namespace tilt_lens
