// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file convergence.h
/// Whether a pixel needs more samples: docs/sampling.md, section 1. Functions of statistics alone; they trace nothing and
/// know of no threads.
///
/// A pixel has converged once
///
///     K (variance ratio) (s^2 / n + undetected error) <= variance target
///
/// with K the confidence factor, s^2 the shrunk variance of one sample, n the samples, for the worst channel, and after the
/// forecast of what the reconstruction will take off.
///
/// Source of a stop by variance and confidence: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling
/// for distributed ray tracing", SIGGRAPH 1985.

#ifndef TILT_LENS_CONVERGENCE_H
#define TILT_LENS_CONVERGENCE_H

#include <cstdint>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Weight of the mean variance of the 3 by 3 pixels around against a pixel's own, which few samples tell badly: a half after
/// settings.shrinkageSamples, falling with the square of the samples, so that what is even beside noise is not sampled as
/// long.
double Shrinkage(std::uint32_t samples);

/// How far the true variance may lie above the estimate with probability `confidence`: the upper limit of the chi-square
/// confidence interval, with the degrees of freedom that the samples and the pooling leave.
double ConfidenceFactor(std::uint32_t samples, double shrinkage, double confidence);

/// Variance of a mean of `samples` samples for what single pixels around have met, and what others may have missed: of n samples one meets
/// on average what is a multiple of 1 / n of all, and the share of what is missed falls as their number rises.
double LoneVariance(const Neighbourhood& around, std::uint32_t firstSamples, std::uint32_t samples);

/// Decides for each pixel whether it is active, and notes variance and excess of those that have been active, with `samples` samples.
/// @return  whether any pixel is active that may have more samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits,
                       std::uint32_t samples);

/// After a round: makes pixels active again that had converged, where pixels beside them have hit more than they have: an edge that all
/// missed at first is then followed from pixel to pixel.
void Reactivate(BlockEstimate& estimate, const Neighbourhood& around);

/// Makes those pixels active, and no others, of which other pixels' samples tell that they have missed more than `variance`.
/// @return  samples of the active pixels with the fewest; 0: no pixel is active
std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits);

} // namespace tilt_lens

#endif
