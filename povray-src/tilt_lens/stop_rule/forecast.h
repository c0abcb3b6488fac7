// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file forecast.h
/// Forecast of the noise that the reconstruction will remove: docs/sampling.md, section 6.

#ifndef TILT_LENS_FORECAST_H
#define TILT_LENS_FORECAST_H

#include <memory>
#include <vector>

#include "tilt_lens/stop_rule/block_estimate.h"

namespace tilt_lens
{

std::shared_ptr<const BlockStatistics> StatisticsOf(const BlockEstimate& estimate);

/// @param samples  of an active pixel; statistics are computed once for each number
void UpdateBlockStatistics(BlockEstimate& estimate, std::uint32_t samples);

/// Predicts the candidates' residual variance ratios, if that may save more time than it takes.
/// @param candidates  indices of pixels with up-to-date `variance` and `target`
/// @return  true if the ratios are of this round
bool UpdateForecast(BlockEstimate& estimate, const std::vector<std::size_t>& candidates, const Neighbourhood& around,
                    const SamplingLimits& limits, std::uint32_t samples);

} // namespace tilt_lens

#endif
