// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file circle_variance.h
/// Variance of a pixel estimated from the samples of other pixels: docs/sampling.md, section 4. Each sample spreads its radiance and its
/// square over its circle of confusion, so a pixel whose own samples missed a blurred lamp learns about it.

#ifndef TILT_LENS_CIRCLE_VARIANCE_H
#define TILT_LENS_CIRCLE_VARIANCE_H

#include <cstddef>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/reconstruction/padded_spread.h"

namespace tilt_lens
{

class CircleVariance
{
  public:
    /// No samples received.
    CircleVariance() = default;
    /// @param spread  samples spread by the block and its neighbours; null: none
    /// @param at  index of the pixel in a plane of `spread`
    /// @param samples  taken by the pixel itself
    CircleVariance(const PaddedSpread* spread, std::size_t at, double samples);

    /// Variance of one sample, per channel, for the stop rule: the received variance replaces the pixel's own in proportion to the
    /// probability that the pixel missed something. Pixels in one circle thus decide alike, whether or not they hit the lamp.
    /// @param own  variance of one sample by the pixel's own samples
    Radiance Blend(const Radiance& own) const;

    /// The same for the reconstruction, summed over the channels, and never below `own`.
    double AtLeast(double own) const { return own < total ? own + weight * (total - own) : own; }

  private:
    double weight = 0.0;  ///< weight of the received variance against the pixel's own, [0, 1]
    double total = 0.0;   ///< variance of one received sample, summed over the channels
    Radiance share{};     ///< share of each channel in `total`
};

} // namespace tilt_lens

#endif
