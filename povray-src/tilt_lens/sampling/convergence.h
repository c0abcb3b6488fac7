// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file convergence.h
/// The stop rule: docs/sampling.md, sections 1 and 3.
///
/// A pixel has converged once
///
///     K * (variance of its mean, less that removed by the reconstruction) <= variance target
///
/// with the confidence factor K.
///
/// Source: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for distributed ray tracing", SIGGRAPH 1985.

#ifndef TILT_LENS_CONVERGENCE_H
#define TILT_LENS_CONVERGENCE_H

#include <cstdint>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Upper confidence limit of a variance over its estimate: chi-square with the degrees of freedom of a quadrant, the smallest part of the
/// picture whose error is meant.
double ConfidenceFactor(std::uint32_t samples, double confidence);

/// Assumed variance of a mean, since isolated pixels have hit features that others may have missed. Such a feature covers about 1 /
/// firstSamples of a pixel.
/// @param loneVariance  of the Neighbourhood
double LoneVariance(double loneVariance, std::uint32_t firstSamples, std::uint32_t samples);

/// True if the pixel has no emitters, if the error expected after its misses is below the target, or if its emitters count as hidden.
bool HasSearchedEmitters(const PixelStatistics& own, double target);

/// Decides which pixels are active, and records variance and excess of those active with `samples` samples.
/// @return  true if an active pixel is below the maximum number of samples
bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples);

/// Activates exactly those pixels that have missed more than `variance`, according to other pixels' samples.
/// @return  fewest samples of an active pixel; 0: no pixel is active
std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits);

} // namespace tilt_lens

#endif
