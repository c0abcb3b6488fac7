// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file circle_variance.h
/// The variance that the samples of other pixels tell of a pixel: docs/sampling.md, section 4. Samples send their radiance and its
/// square to the pixels of their circles of confusion, so that a pixel whose own samples missed a blurred lamp learns of it.

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
    /// No other pixel's samples are known.
    CircleVariance() = default;
    /// @param spread  of the block and its neighbours; null: nothing was sent
    /// @param at  place of the pixel in a plane of `spread`
    /// @param samples  that the pixel has taken
    CircleVariance(const PaddedSpread* spread, std::size_t at, double samples);

    /// The variance of one sample, each channel, on which the stop rule decides: that of the circle as far as the pixel may have
    /// missed something. So pixels of one circle decide alike, whether or not they have met the lamp.
    /// @param own  variance of one sample by the pixel's own
    Radiance Blend(const Radiance& own) const;

    /// The same for the reconstruction, summed over the channels, and at least `own`.
    double AtLeast(double own) const { return own < total ? own + weight * (total - own) : own; }

  private:
    double weight = 0.0;  ///< of the circle's variance against the pixel's own, [0, 1]
    double total = 0.0;   ///< variance of one sample of the circle, summed over the channels
    Radiance share{};     ///< of each channel in it
};

} // namespace tilt_lens

#endif
