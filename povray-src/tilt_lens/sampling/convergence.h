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

/// Decides for each active pixel with `samples` samples whether it stays active, and notes its variance and target.
/// @return  whether any pixel is active that may have more samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits,
                       std::uint32_t samples);

/// After a round: makes pixels active again that had converged, where those beside them have hit what they may have missed.
/// So what all missed at first, an edge along them say, is followed from pixel to pixel.
void Reactivate(BlockEstimate& estimate, const Neighbourhood& around);

} // namespace tilt_lens

#endif
