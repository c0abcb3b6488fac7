// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file neighbourhood.h
/// What the first rounds of a block and of its neighbours tell of its pixels: docs/sampling.md, sections 4 and 6.

#ifndef TILT_LENS_NEIGHBOURHOOD_H
#define TILT_LENS_NEIGHBOURHOOD_H

#include <memory>

#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Found once, before a block's second round. Immutable.
class Neighbourhood
{
  public:
    /// @param rounds  the block's own in the middle; they must outlive this
    Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits);

    /// Mean of the pixels' FirstRoundPixel::deviation.
    double MeanDeviation() const { return meanDeviation; }
    /// Mean of FirstRound::loneVariance.
    double LoneVariance() const { return loneVariance; }
    /// Whether no sample of the neighbours differs from the others of its pixel.
    bool IsUniformAround() const { return uniformAround; }
    /// How the samples of the 3 by 3 pixels around one vary: by all so far in the block, by the first ones beside it. Mean variance,
    /// greatest deviation.
    SampleVariation Around(const BlockEstimate& estimate, std::size_t pixel) const;
    /// The first rounds' BlockStatistics; null where they are not known.
    const FirstRounds& Rounds() const { return rounds; }
    /// Samples that the first rounds have sent to other pixels; null: none.
    std::shared_ptr<const PaddedSpread> Spread() const;

  private:
    const FirstRounds rounds;
    double meanDeviation = 0.0, loneVariance = 0.0;
    bool uniformAround = true;
};

} // namespace tilt_lens

#endif
