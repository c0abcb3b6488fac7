// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file convergence.h
/// The stop rule: docs/sampling.md, sections 1 and 3. Functions of statistics alone; they trace no rays and know no threads.
///
/// A pixel has converged once
///
///     K * (variance of its mean, less that removed by the reconstruction) <= variance target
///
/// with the confidence factor K. Pixels with wide circles of confusion decide together.
///
/// Source of stopping by variance and confidence: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for
/// distributed ray tracing", SIGGRAPH 1985.

#ifndef TILT_LENS_CONVERGENCE_H
#define TILT_LENS_CONVERGENCE_H

#include <cstdint>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Ratio of the upper confidence limit of the variance to its estimate, with probability `confidence`: chi-square, with the degrees of
/// freedom of the samples of a quadrant, the smallest part of the picture whose error is meant.
double ConfidenceFactor(std::uint32_t samples, double confidence);

/// Variance assumed for the mean of `samples` samples because isolated pixels have hit something that others may have missed. A feature
/// hit by one of firstSamples samples covers about 1 / firstSamples of the pixel; the missed share falls as samples grow.
/// @param loneVariance  of the Neighbourhood
double LoneVariance(double loneVariance, std::uint32_t firstSamples, std::uint32_t samples);

/// True if the pixel needs no further search for its emitters: it has none, the error expected after its misses is below the target, or
/// there are so many misses that the emitters are taken for hidden.
bool HasSearchedEmitters(const PixelStatistics& own, double target);

/// Decides which pixels are active, and records variance and excess of those that have been active, with `samples` samples.
/// @return  whether any active pixel is below the maximum number of samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples);

/// Makes active exactly those pixels that, according to other pixels' samples, have missed more than `variance`.
/// @return  fewest samples of an active pixel; 0: no pixel is active
std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits);

} // namespace tilt_lens

#endif
