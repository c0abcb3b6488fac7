// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variance_target.h
/// Variance target of each pixel's mean: docs/sampling.md, section 6.
///
/// The target is near `variance`, but greater for pixels with above-average noise. For a given number of rays a picture's mean square error
/// is least if each pixel's rays are proportional to the standard deviation of its samples, not to their variance: n samples of a deviation
/// s leave s^2/n, which is then proportional to n.
///
/// Source: J. Neyman, "On the two different aspects of the representative method", J. R. Stat. Soc. 97(4), 1934.

#ifndef TILT_LENS_VARIANCE_TARGET_H
#define TILT_LENS_VARIANCE_TARGET_H

#include <cstdint>

#include "tilt_lens/sampling/sampling_limits.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

class VarianceTarget
{
  public:
    /// @param samples  number of samples of the pixels
    VarianceTarget(const SamplingLimits& limits, std::uint32_t samples) :
        variance(limits.variance), proportional(samples * limits.variance / settings.typicalSampleVariance) {}

    /// @param relativeDeviation  standard deviation of one sample over the mean of the neighbourhood. The target exceeds `variance` only
    ///     above 1: if all pixels deviate alike, all keep about `variance`, and no ray is wasted.
    double operator()(double relativeDeviation) const;

  private:
    double variance;
    double proportional;  ///< target proportional to the samples, as a factor of `variance`
};

} // namespace tilt_lens

#endif
