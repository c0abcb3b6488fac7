// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// Reconstructs the picture from its pixels' means: docs/sampling.md, section 5, with sources.
///
/// The folder reconstruction/ spreads samples over their circles of confusion, filters noise, and estimates the rest for the stop rule.
/// Candidates (filters.h, padded_spread.h) are averaged with weights of about 1 / risk^2, with Stein's unbiased risk estimate.

#ifndef TILT_LENS_RECONSTRUCTION_H
#define TILT_LENS_RECONSTRUCTION_H

#include <array>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/math/rows.h"
#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/padded_spread.h"

namespace tilt_lens
{

inline constexpr Rows kAllRows{0, int(Settings::blockSide)};

struct ReconstructedBlock
{
    std::array<BlockPlane, 5> mean;
    BlockPlane residualVarianceBound;  ///< at most this fraction of variance remains, (0, 1]
    BlockPlane residualVarianceRatio;  ///< estimate of the same
    float risk;                        ///< Stein's estimate of the mean square error, bias included, over the variance: [-1, 1]

    /// Not finite beside a pixel too bright for a float.
    Radiance MeanOf(std::size_t pixel) const;
};

/// @param rows  to reconstruct; others stay unchanged
ReconstructedBlock Reconstruct(const PaddedBlock& around, const Settings& settings, const PaddedSpread* spread = nullptr,
                               const Rows& rows = kAllRows);

/// For pixels with one sample, whose noise is unknown.
ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const Settings& settings, const PaddedSpread& spread);

} // namespace tilt_lens

#endif
