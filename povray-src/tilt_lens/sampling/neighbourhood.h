// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file neighbourhood.h
/// What the first rounds of a block and of its neighbours tell of its pixels: docs/sampling.md, sections 4 and 6.

#ifndef TILT_LENS_NEIGHBOURHOOD_H
#define TILT_LENS_NEIGHBOURHOOD_H

#include <vector>

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
    /// Whether no sample of the neighbours differs from the others of its pixel.
    bool IsUniformAround() const { return uniformAround; }
    /// How the first samples vary of what is blurred so far that it may cover a pixel of the block too, wherever in the
    /// block or just beside it they are: mean variance, greatest deviation.
    const SampleVariation& Blurred(std::size_t pixel) const { return blurred[pixel]; }
    /// The same of the 3 by 3 pixels around one: by all samples so far in the block, by the first ones beside it.
    SampleVariation Around(const BlockEstimate& estimate, std::size_t pixel) const;
    /// The first rounds' BlockStatistics; null where they are not known.
    const FirstRounds& Rounds() const { return rounds; }

  private:
    const FirstRounds rounds;
    double meanDeviation = 0.0;
    bool uniformAround = true;
    std::vector<SampleVariation> blurred;

    void FindBlurred();
};

} // namespace tilt_lens

#endif
