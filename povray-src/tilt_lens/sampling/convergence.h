// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file convergence.h
/// The stop rule: docs/sampling.md, section 1. Functions of statistics alone; they trace no rays and know no threads.
///
/// A pixel has converged once
///
///     K (variance ratio) (s^2 / n + undetected error) <= variance target
///
/// with the confidence factor K, the shrunk variance of one sample s^2 and the number of samples n. The worst channel counts, after
/// subtracting the variance that the reconstruction is predicted to remove.
///
/// Source of stopping by variance and confidence: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for distributed
/// ray tracing", SIGGRAPH 1985.

#ifndef TILT_LENS_CONVERGENCE_H
#define TILT_LENS_CONVERGENCE_H

#include <cstdint>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Weight of the mean variance of the 3 by 3 window against the pixel's own, which is unreliable from few samples: 1/2 after
/// settings.shrinkageSamples, then falling with the square of the samples, so that flat pixels beside noise stop earlier.
double Shrinkage(std::uint32_t samples);

/// Ratio of the upper confidence limit of the variance to its estimate, with probability `confidence`: chi-square, with the degrees of
/// freedom that samples and pooling provide.
double ConfidenceFactor(std::uint32_t samples, double shrinkage, double confidence);

/// Variance assumed for the mean of `samples` samples because isolated pixels have hit something that others may have missed. A feature hit
/// by one of firstSamples samples covers about 1 / firstSamples of the pixel; the missed share falls as samples grow.
double LoneVariance(const Neighbourhood& around, std::uint32_t firstSamples, std::uint32_t samples);

/// Decides which pixels are active, and records variance and excess of those that have been active, with `samples` samples.
/// @return  whether any active pixel is below the maximum number of samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits,
                       std::uint32_t samples);

/// After a round, reactivates converged pixels whose neighbours have hit more than they have: an edge that all missed at first is then
/// followed from pixel to pixel.
void Reactivate(BlockEstimate& estimate, const Neighbourhood& around);

/// Makes active exactly those pixels that, according to other pixels' samples, have missed more than `variance`.
/// @return  fewest samples of an active pixel; 0: no pixel is active
std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits);

} // namespace tilt_lens

#endif
