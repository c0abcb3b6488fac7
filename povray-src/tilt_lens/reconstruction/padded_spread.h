// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file padded_spread.h
/// Samples that serve a block's pixels and its border, their own and those of other pixels: docs/sampling.md, section 5.

#ifndef TILT_LENS_PADDED_SPREAD_H
#define TILT_LENS_PADDED_SPREAD_H

#include <array>
#include <cstdint>
#include <memory>

#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/spread.h"

namespace tilt_lens
{

class PaddedSpread
{
  public:
    using Plane = PaddedBlock::Plane;

    using Sent = std::array<const SpreadSums*, 9>;

    /// @param sent  by the block, in the middle, and its neighbours; null: none
    /// @return      null if nothing was spread
    static std::shared_ptr<const PaddedSpread> Of(const Sent& sent, const PictureEdges& edges);

    std::array<Plane, 3> mean;  ///< of received samples, a pixel's own included; 0: none
    Plane variance;  ///< of one received sample, summed over the channels
    Plane share;  ///< sum of received shares times weights; about that of a pixel's sample weights
    Plane samples;  ///< number of received samples if all had equal shares
    Plane ownShare;  ///< mean share that a sample keeps for its pixel
    Plane ownWeight;  ///< sum of its own received samples; 0 in blocks that sent nothing

  private:
    using Received = std::array<Plane, SpreadSums::kSums>;

    PaddedSpread(const Sent& sent, const PictureEdges& edges);
    void Finish(const Received& received, std::size_t at);
};

} // namespace tilt_lens

#endif
