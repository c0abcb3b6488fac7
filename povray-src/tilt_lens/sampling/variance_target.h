// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variance_target.h
/// The variance that each pixel's mean may keep: docs/sampling.md, section 6.
///
/// It is near `variance`, but more where noise stands out. Rays lower the mean square
/// error of a picture most if a pixel gets them in proportion to the standard deviation of its samples, not to their
/// variance: n samples of a deviation s leave s^2/n, which is then in proportion to n.
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
    /// @param samples  of the pixels that it is asked for
    VarianceTarget(const SamplingLimits& limits, std::uint32_t samples) :
        variance(limits.variance), proportional(samples * limits.variance / settings.typicalSampleVariance) {}

    /// @param relativeDeviation  of one sample, over the mean of the neighbourhood: above 1 the target may exceed `variance`.
    ///     Where all pixels deviate alike, all keep about `variance`, so that no ray is wasted.
    double operator()(double relativeDeviation) const;

  private:
    double variance;
    double proportional;  ///< what the samples are in proportion to, as a factor of `variance`
};

} // namespace tilt_lens

#endif
