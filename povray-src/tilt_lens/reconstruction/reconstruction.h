// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// Reconstructs the picture from its pixels' means: docs/sampling.md, section 5.
///
/// The folder reconstruction/ answers: which picture do the samples make? It spreads samples over their circles of confusion, filters
/// noise from the pixels' means, and estimates the rest of the noise. The sampler's stop rule uses the estimates.
///
/// Candidates, most of them linear filters F of the means (filters.h), are averaged at each pixel with weights of 1 / risk^2, with
/// Stein's estimate
///
///     risk = mean over the 7 by 7 pixels q around of (|F q - q|^2 - (1 - 2 F_0) var q) / var q.
///
/// F_0 is the filter's tap of the pixel itself; squares and variances are summed over the channels. A filter's change is removed noise
/// plus error; the part that noise cannot explain is error. Risk is relative to each pixel's noise, lest a dark pixel beside a lamp
/// suffer from filters that suit the lamp. Errors well above the noise count in full for the 3 by 3 pixels around, for others at most
/// settings.riskLimit times the noise, so that an edge does not leave its surroundings noisy.
///
/// Two candidates are each pixel's spread estimate S (padded_spread.h), and S corrected by a smoothed difference, S + mean9x9(q - S).
/// Errors of S, as behind an edge or in a mirror, raise its risk.
///
/// Weights depend only on colours and their variances, not on depth or normals, so reflections, refractions, media and blurred lights
/// need no rules. Pixels without noise around stay unchanged. The reconstruction is biased: it may smooth differences smaller than the
/// noise. `denoise off` disables it.
///
/// Sources: C. M. Stein, "Estimation of the mean of a multivariate normal distribution", Ann. Statist. 9(6), 1981, for the risk; F.
/// Rousselle, C. Knaus, M. Zwicker, "Adaptive sampling and reconstruction using greedy error minimization", ACM Trans. Graph. 30(6),
/// 2011, and T.-M. Li, Y.-T. Wu, Y.-Y. Chuang, "SURE-based optimization for adaptive sampling and reconstruction", ACM Trans. Graph.
/// 31(6), 2012, for choosing filters by it. Unlike there, no single filter is chosen, since the choice would be as noisy as the risk; and
/// the remaining variance is bounded by the weighted mean of the candidates' variances, because the risk may vanish by chance.

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

    /// Not finite beside a pixel too bright for a float.
    Radiance MeanOf(std::size_t pixel) const;
};

/// @param spread  of the same blocks; null: none
/// @param rows  to reconstruct; others stay unchanged
ReconstructedBlock Reconstruct(const PaddedBlock& around, const PaddedSpread* spread = nullptr, const Rows& rows = Rows());

/// For pixels with one sample: without a noise estimate no risk is known.
ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const PaddedSpread& spread);

}  // namespace tilt_lens

#endif
