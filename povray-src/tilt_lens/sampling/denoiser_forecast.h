// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file denoiser_forecast.h
/// What the sampler tells the reconstruction of a block, and what it may expect of it: docs/sampling.md, section 9.

#ifndef TILT_LENS_DENOISER_FORECAST_H
#define TILT_LENS_DENOISER_FORECAST_H

#include <memory>
#include <vector>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// An active pixel, and the variance that decides whether it converges: each channel relative to its SquaredScale.
struct Candidate
{
    std::size_t pixel;
    Radiance variance;
    double target;

    bool HasConverged() const { return LargestChannel(variance) <= target; }
};

/// The block's statistics for the reconstruction, from the samples so far.
std::shared_ptr<const BlockStatistics> StatisticsOf(const BlockEstimate& estimate);

/// Makes them the estimate's own.
/// @param samples  of an active pixel: of so many they are made only once
void UpdateBlockStatistics(BlockEstimate& estimate, std::uint32_t samples);

/// Takes from the candidates' variances what the reconstruction will take: of what their own samples show, not of what is
/// undetected.
void ApplyDenoiserForecast(std::vector<Candidate>& candidates, BlockEstimate& estimate, const Neighbourhood& around,
                           std::uint32_t samples);

} // namespace tilt_lens

#endif
