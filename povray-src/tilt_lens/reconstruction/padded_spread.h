// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file padded_spread.h
/// What the pixels of a block and those around it have received from the samples of others: docs/sampling.md, section 8.

#ifndef TILT_LENS_PADDED_SPREAD_H
#define TILT_LENS_PADDED_SPREAD_H

#include <array>
#include <cstdint>
#include <memory>

#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/spread.h"

namespace tilt_lens
{

/// The spread estimates of a block's pixels and of those around it, before their own samples are added.
class PaddedSpread
{
  public:
    using Plane = PaddedBlock::Plane;

    using Sent = std::array<const SpreadSums*, 9>;

    /// @param sent  by the pixels of the block, which is in the middle, and of its eight neighbours, row by row; null: nothing
    /// @param weight  of a pixel's samples, as many as those of the block's first round. Those of neighbours count as if they had the same: a
    ///     surface is not seen more where more rays have met it.
    /// @return null where nothing was sent at all
    static std::shared_ptr<const PaddedSpread> Of(const Sent& sent, std::uint32_t weight);

    std::array<Plane, 3> mean;  ///< of what other pixels' samples have sent; 0: nothing
    Plane variance;  ///< of one of these samples, summed over the channels
    Plane share;     ///< that these samples have sent, times their weights
    Plane samples;   ///< the same without their weights
    Plane ownShare;  ///< that a sample of the pixel keeps for it, on average, [0, 1]

    /// Number of other pixels' samples that have reached a pixel, about.
    float SamplesAt(std::size_t at) const { return share[at] > 0.0f && ownShare[at] > 0.0f ? samples[at] / ownShare[at] : 0.0f; }

  private:
    using Received = std::array<Plane, SpreadSums::kSums>;

    PaddedSpread(const Sent& sent, std::uint32_t weight);
    void Finish(const Received& received, std::size_t at);
};

} // namespace tilt_lens

#endif
