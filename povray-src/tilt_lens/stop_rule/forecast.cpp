// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/forecast.h"

#include <algorithm>
#include <numeric>

#include "tilt_lens/math/window.h"
#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/stop_rule/pixel_variance.h"

namespace tilt_lens
{

namespace
{

/// Index in a BlockPlane.
std::size_t PlaneIndex(const BlockEstimate& estimate, std::size_t pixel)
{
    return pixel / estimate.area.width * Settings::blockSide + pixel % estimate.area.width;
}

/// Includes the neighbours after the first round only: later their greater noise would be taken for the block's error.
BlockPlane ForecastBounds(BlockEstimate& estimate, const Neighbourhood& around, const Rows& rows, std::uint32_t samples,
                          bool afterFirstRound)
{
    UpdateBlockStatistics(estimate, samples);
    std::array<const BlockStatistics*, 9> known{};
    if (afterFirstRound)
        known = EachOf<BlockStatistics>(around.rounds, &FirstRound::statistics);
    known[4] = estimate.statistics.get();
    return Reconstruct(PaddedBlock(known, estimate.edges), estimate.settings, estimate.spread.get(), rows).residualVarianceBound;
}

/// Variance of one sample, summed over the channels: mean of the 3 by 3 window within the block.
std::vector<double> VarianceAround(const BlockEstimate& estimate)
{
    std::vector<double> variances;
    for (const PixelEstimate& pixel : estimate.pixels)
    {
        const Radiance variance = pixel.statistics.Variance();
        variances.push_back(std::accumulate(variance.begin(), variance.end(), 0.0));
    }
    return WindowMeans<Settings::neighbourRadius>(variances, estimate.area.width);
}

} // namespace

std::shared_ptr<const BlockStatistics> StatisticsOf(const BlockEstimate& estimate)
{
    const Area& area = estimate.area;
    const bool uniform = !estimate.HasNoise();
    const std::vector<double> none(uniform ? area.Size() : 0);
    const std::vector<double> ratio = uniform ? none : RatiosOrOutliers(estimate), variance = uniform ? none : VarianceAround(estimate);
    const auto made = std::make_shared<BlockStatistics>();
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        const PixelStatistics& pixel = estimate.pixels[i].statistics;
        const double whole = CircleVariance(estimate, i).AtLeast(variance[i]);
        made->Set(i % area.width, i / area.width, pixel.Mean(), ratio[i] * whole / pixel.Samples(),
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

bool UpdateForecast(BlockEstimate& estimate, const std::vector<std::size_t>& candidates, const Neighbourhood& around,
                    const SamplingLimits& limits, std::uint32_t samples)
{
    // The last round's bound is optimistic, since bounds rise as noise falls: no forecast if even it saves no pixel.
    const bool saves = std::any_of(candidates.begin(), candidates.end(), [&estimate](std::size_t i)
    {
        const PixelEstimate& pixel = estimate.pixels[i];
        return pixel.variance > pixel.target * (1.0 - estimate.settings.deviationShare) &&
               pixel.residualVarianceBound * pixel.variance <= pixel.target * estimate.GreatestExcess(i);
    });
    if (!saves)
        return false;
    const Rows rows = Rows::Of(candidates, estimate.area.width);
    const BlockPlane bounds = ForecastBounds(estimate, around, rows, samples, samples == limits.FirstRound());
    for (const std::size_t i : candidates)
        estimate.pixels[i].residualVarianceBound = bounds[PlaneIndex(estimate, i)];
    return true;
}

}  // namespace tilt_lens
