// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/denoiser_forecast.h"

#include <algorithm>
#include <numeric>

#include "tilt_lens/math/window.h"
#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/sampling/variance_ratio.h"

namespace tilt_lens
{

namespace
{

/// Index in a BlockPlane of a pixel of the block.
std::size_t PlaneIndex(const BlockEstimate& estimate, std::size_t pixel)
{
    return pixel / estimate.area.width * settings.blockSide + pixel % estimate.area.width;
}

Radiance ForecastVariance(const Candidate& candidate, const PixelEstimate& pixel, std::uint32_t samples)
{
    const Radiance mean = pixel.statistics.Mean();
    Radiance variance = candidate.variance;
    for (std::size_t c = 0; c < variance.size(); c++)
    {
        const double seen =
            pixel.varianceRatio * pixel.seenVariance[c] / samples / SquaredScale(mean[c]);
        variance[c] -= (1.0 - pixel.residualVarianceRatio) * std::min(seen, variance[c]);
    }
    return variance;
}

/// Residual variance ratios, by the block's samples and, after the first round, its neighbours'. Later the block alone counts: the greater
/// noise of the neighbours' first rounds would be taken for its own error.
BlockPlane ForecastRatios(BlockEstimate& estimate, const Neighbourhood& around, std::uint32_t samples, bool afterFirstRound)
{
    UpdateBlockStatistics(estimate, samples);
    std::array<const BlockStatistics*, 9> known{};
    for (std::size_t i = 0; i < known.size() && afterFirstRound; i++)
        if (const FirstRound* round = around.Rounds()[i])
            known[i] = round->statistics.get();
    known[4] = estimate.statistics.get();
    return Reconstruct(PaddedBlock(known), estimate.spread.get()).residualVarianceRatio;
}

/// Variance of one sample, summed over the channels: mean of each pixel's 3 by 3 window within the block.
std::vector<double> VarianceAround(const BlockEstimate& estimate)
{
    std::vector<double> variances;
    for (const PixelEstimate& pixel : estimate.pixels)
    {
        const Radiance& variance = pixel.statistics.Variation().variance;
        variances.push_back(std::accumulate(variance.begin(), variance.end(), 0.0));
    }
    return WindowMeans<settings.neighbourRadius>(variances, estimate.area.width);
}

} // namespace

std::shared_ptr<const BlockStatistics> StatisticsOf(const BlockEstimate& estimate)
{
    const Area& area = estimate.area;
    const bool uniform = estimate.IsUniform() && !estimate.spread;  // no noise to estimate
    const std::vector<double> none(uniform ? area.Size() : 0);
    const std::vector<double> ratio = uniform ? none : LocalVarianceRatios(estimate), variance = uniform ? none : VarianceAround(estimate);
    const auto made = std::make_shared<BlockStatistics>();
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        const PixelStatistics& pixel = estimate.pixels[i].statistics;
        const double whole = estimate.CircleVarianceOf(i).AtLeast(variance[i]);
        made->Set(i % area.width, i / area.width, pixel.Mean(), ratio[i] * whole / pixel.Samples() + estimate.pixels[i].undetectedNoise,
                  whole > 0.0 ? 1.0 - variance[i] / whole : 0.0, pixel.Samples());
    }
    made->RepeatEdges(area.width, area.height);
    return made;
}

void UpdateBlockStatistics(BlockEstimate& estimate, std::uint32_t samples)
{
    if (samples == estimate.statisticsSamples)
        return;
    estimate.statistics = StatisticsOf(estimate);
    estimate.statisticsSamples = samples;
}

void ApplyDenoiserForecast(std::vector<Candidate>& candidates, BlockEstimate& estimate, const Neighbourhood& around,
                           std::uint32_t samples)
{
    if (std::all_of(candidates.begin(), candidates.end(), [](const Candidate& one) { return one.HasConverged(); }))
        return;
    // The residual ratio rises as noise falls, so the last round's ratio is optimistic: skip the forecast if even this ratio would save too
    // few rays.
    const auto saved = std::count_if(candidates.begin(), candidates.end(), [&](const Candidate& one)
    {
        const Candidate denoised{one.pixel, ForecastVariance(one, estimate.pixels[one.pixel], samples), one.target};
        return !one.HasConverged() && denoised.HasConverged();
    });
    if (saved * samples < settings.forecastCost * settings.blockSide * settings.blockSide)
        return;
    const BlockPlane ratios = ForecastRatios(estimate, around, samples, samples == estimate.firstSamples);
    for (Candidate& one : candidates)
    {
        PixelEstimate& pixel = estimate.pixels[one.pixel];
        pixel.residualVarianceRatio = ratios[PlaneIndex(estimate, one.pixel)];
        one.variance = ForecastVariance(one, pixel, samples);
    }
}

} // namespace tilt_lens
