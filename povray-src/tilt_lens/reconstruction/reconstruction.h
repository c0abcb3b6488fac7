// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// Reconstructs the picture from its pixels' means: docs/sampling.md, section 5, with sources.
///
/// The folder reconstruction/ makes the picture from samples. It spreads samples over their circles of confusion, filters noise from the
/// pixels' means, and estimates the remaining noise, which the stop rule uses.
///
/// Candidates, most of them linear filters F of the means (filters.h), are averaged at each pixel with weights that fall as 1 / risk^2,
/// with Stein's estimate
///
///     risk = mean over the 7 by 7 pixels q around of (|F q - q|^2 - (1 - 2 F_0) var q) / var q.
///
/// F_0 is the filter's tap of the pixel itself; squares and variances are summed over the channels. Two more candidates are the spread
/// estimate S (padded_spread.h), and S + mean9x9(q - S). The remaining variance is at most the weighted mean of the candidates' variances.

#ifndef TILT_LENS_RECONSTRUCTION_H
#define TILT_LENS_RECONSTRUCTION_H

#include <array>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/padded_spread.h"

namespace tilt_lens
{

/// begin <= row < end
struct Rows
{
    int begin = 0, end = int(settings.blockSide);

    bool IsEmpty() const { return begin >= end; }
    bool Has(int row) const { return row >= begin && row < end; }
};

struct ReconstructedBlock
{
    std::array<BlockPlane, 5> mean;
    BlockPlane residualVarianceRatio;  ///< fraction of variance that the filters leave, (0, 1]

    /// Infinite or NaN beside a pixel too bright for a float.
    Radiance MeanOf(std::size_t pixel) const;
};

/// @param spread  of the same blocks; null: none
/// @param rows    to reconstruct; others stay unchanged
ReconstructedBlock Reconstruct(const PaddedBlock& around, const PaddedSpread* spread = nullptr, const Rows& rows = Rows());

/// For pixels with one sample, whose noise is unknown.
ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const PaddedSpread& spread);

} // namespace tilt_lens

#endif
