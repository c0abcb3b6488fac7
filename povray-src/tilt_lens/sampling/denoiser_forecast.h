// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file denoiser_forecast.h
/// Statistics for the reconstruction of a block, and the forecast of the noise that it will remove: docs/sampling.md, section 9.

#ifndef TILT_LENS_DENOISER_FORECAST_H
#define TILT_LENS_DENOISER_FORECAST_H

#include <memory>
#include <vector>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// An active pixel and the variance that decides whether it has converged; each channel relative to its SquaredScale.
struct Candidate
{
    std::size_t pixel;
    Radiance variance;
    double target;

    bool HasConverged() const { return LargestChannel(variance) <= target; }
};

/// Statistics for the reconstruction, from the samples so far.
std::shared_ptr<const BlockStatistics> StatisticsOf(const BlockEstimate& estimate);

/// Stores these statistics in `estimate`.
/// @param samples  of an active pixel; the statistics are computed once for each number
void UpdateBlockStatistics(BlockEstimate& estimate, std::uint32_t samples);

/// Subtracts the variance that the reconstruction will remove from the candidates' variances: a part of the measured variance, never of the
/// undetected error.
void ApplyDenoiserForecast(std::vector<Candidate>& candidates, BlockEstimate& estimate, const Neighbourhood& around,
                           std::uint32_t samples);

} // namespace tilt_lens

#endif
