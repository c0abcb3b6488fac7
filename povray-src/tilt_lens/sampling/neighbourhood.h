// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file neighbourhood.h
/// Statistics from the first rounds of a block and its neighbours: docs/sampling.md, sections 4 and 6.

#ifndef TILT_LENS_NEIGHBOURHOOD_H
#define TILT_LENS_NEIGHBOURHOOD_H

#include <memory>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Computed once, before a block's second round. Immutable.
class Neighbourhood
{
  public:
    /// @param rounds  the block's own in the middle; they must outlive this object
    Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits);

    /// Mean of the pixels' FirstRoundPixel::deviation.
    double MeanDeviation() const { return meanDeviation; }
    /// Mean of FirstRound::loneVariance.
    double LoneVariance() const { return loneVariance; }
    /// True if the samples of each pixel of the neighbours are all equal.
    bool IsUniformAround() const { return uniformAround; }
    /// Variation of the samples in a pixel's 3 by 3 window (all samples so far inside the block, first rounds outside): mean variance and
    /// greatest deviation.
    SampleVariation Around(const BlockEstimate& estimate, std::size_t pixel) const;
    /// The first rounds; null outside the picture.
    const FirstRounds& Rounds() const { return rounds; }
    /// Samples spread by the first rounds; null: none.
    std::shared_ptr<const PaddedSpread> Spread() const;

  private:
    const FirstRounds rounds;
    double meanDeviation = 0.0, loneVariance = 0.0;
    bool uniformAround = true;
};

} // namespace tilt_lens

#endif
