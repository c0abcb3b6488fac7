// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/block_estimate.h"

#include "tilt_lens/math/window.h"

namespace tilt_lens
{

BlockEstimate::BlockEstimate(const Area& area, const PictureEdges& edges, const Settings& settings) :
    area(area), edges(edges), pixels(area.Size()), settings(settings)
{
    for (PixelEstimate& pixel : pixels)
        pixel.residualVarianceBound = 1.0 / settings.greatestRisk;
}

bool BlockEstimate::HasNoise() const
{
    return spread ||
           std::any_of(pixels.begin(), pixels.end(), [](const PixelEstimate& pixel) { return IsNonZero(pixel.statistics.Variance()); });
}

FirstRound::FirstRound(const BlockEstimate& estimate) : pixels(estimate.pixels.size())
{
    const Area& area = estimate.area;
    std::vector<double> variances;
    for (const PixelEstimate& pixel : estimate.pixels)
        variances.push_back(LargestChannel(RelativeTo(pixel.statistics.Mean(), pixel.statistics.Variance())));
    constexpr int radius = Settings::neighbourRadius, around = Settings::neighbourhoodPixels;
    const std::vector<double> means = WindowMeans<radius>(variances, area.width);
    const double inside = std::max(1.0, (area.width - 2.0 * radius) * (area.height - 2.0 * radius));
    for (std::uint32_t y = radius; y + radius < area.height; y++)
        for (std::uint32_t x = radius; x + radius < area.width; x++)
        {
            const std::size_t i = y * area.width + x;
            if (estimate.pixels[i].statistics.EmitterSamples() == 0)  // else the feature is known, and is searched for
                loneVariance += std::max(0.0, 2.0 * variances[i] - around * means[i]) / inside;
        }
}

Neighbourhood::Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits) : rounds(rounds)
{
    if (!(limits.variance > 0.0))
        return;  // not used then
    std::size_t pixels = 0;
    double deviation = 0.0;
    for (const FirstRound* round : rounds)
        if (round != nullptr)
        {
            loneVariance += round->loneVariance * round->pixels;
            deviation += round->deviation * round->pixels;
            pixels += round->pixels;
        }
    loneVariance /= pixels;
    deviationRatio = deviation / pixels / rounds[4]->deviation;
}

} // namespace tilt_lens
