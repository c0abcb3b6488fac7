// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file convergence.h
/// The stop rule: docs/sampling.md, sections 1 and 3.
/// Source: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for distributed ray tracing", SIGGRAPH 1985.

#ifndef TILT_LENS_CONVERGENCE_H
#define TILT_LENS_CONVERGENCE_H

#include <cstdint>

#include "tilt_lens/samples/sampling_limits.h"
#include "tilt_lens/stop_rule/block_estimate.h"

namespace tilt_lens
{

/// Upper confidence limit of a variance over its estimate, by the chi-square distribution with a quadrant's degrees of freedom.
double ConfidenceFactor(std::uint32_t samples, double confidence);

/// Variance of a mean, assumed for features that isolated pixels have hit and others may have missed.
/// @param loneVariance  of the Neighbourhood
double LoneVariance(double loneVariance, std::uint32_t firstSamples, std::uint32_t samples);

/// True if the pixel has no emitters, if its error expected after misses is below the target, or if they count as hidden.
/// @param most  emitter samples after which an emitter counts as hidden
bool HasSearchedEmitters(const PixelStatistics& own, double target, std::uint32_t most);

/// Mean over the pixels of the standard deviation of one sample, over that with which the first round keeps V, and at least 1: no pixel
/// takes less. Before any reconstruction.
double MeanDeviation(const BlockEstimate& first, const SamplingLimits& limits);

/// Decides which pixels are active; records variance and excess of those active with `samples` samples.
/// @return  true if an active pixel is below the maximum number of samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples);

/// Activates exactly those pixels that have missed more than `variance` by other pixels' samples.
/// @return  fewest samples of an active pixel; 0: none
std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits);

} // namespace tilt_lens

#endif
