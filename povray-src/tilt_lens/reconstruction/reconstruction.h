// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// The picture from its pixels' means: docs/sampling.md, section 8. Candidates, most of them linear filters F of the means
/// (filters.h), are averaged at each pixel with weights of 1 / risk^2, where Stein's estimate of the risk is
///
///     risk = mean over the 7 by 7 pixels q around of (|F q - q|^2 - (1 - 2 F_0) var q) / var q
///
/// with F_0 a filter's own tap of the pixel, and squares and variances summed over the channels. What a filter changes is
/// noise that it takes off and error that it makes; what is more than the noise explains is error. It counts in units of a
/// pixel's noise, since beside a lamp a dark pixel would take harm from what is good for the lamp. Errors that stand out of the noise count in full for the 3 by 3 pixels around, for others at
/// most settings.riskLimit times the noise, so that an edge does not keep all that is around it noisy.
///
/// Two candidates are the spread estimate S of each pixel (padded_spread.h), alone and with the mean over 9 by 9 pixels of
/// what it misses, S + mean9x9(q - S). What S gets wrong, behind an edge or in a mirror, shows in its risk as in any other's.
///
/// Weights come from nothing but colours and their variances: no depth, no normals. So a mirror image, a refraction, a medium
/// or a far blurred light is treated as what it looks like. Pixels among such as have no noise stay what they are. The step is
/// biased: what it smooths may differ by less than the noise. It is one of the things that `denoise off` leaves out.
///
/// Sources: C. M. Stein, "Estimation of the mean of a multivariate normal distribution", Ann. Statist. 9(6), 1981, for the
/// risk; F. Rousselle, C. Knaus, M. Zwicker, "Adaptive sampling and reconstruction using greedy error minimization", ACM
/// Trans. Graph. 30(6), 2011, and T.-M. Li, Y.-T. Wu, Y.-Y. Chuang, "SURE-based optimization for adaptive sampling and
/// reconstruction", ACM Trans. Graph. 31(6), 2012, for choosing among filters by it. Here: no one filter is chosen, since the
/// choice would be as noisy as the risk; and what is left of the variance is not told by the risk, which may be none by
/// chance, but by filtering the difference of the two sample buffers, which is noise and nothing else, and by the bias that goes
/// with as much noise.

#ifndef TILT_LENS_RECONSTRUCTION_H
#define TILT_LENS_RECONSTRUCTION_H

#include <array>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/padded_spread.h"

namespace tilt_lens
{

/// Rows of a block, from the first to before the end.
struct Rows
{
    int begin = 0, end = int(settings.blockSide);

    bool IsEmpty() const { return begin >= end; }
    bool Has(int row) const { return row >= begin && row < end; }
};

/// A block's pixels reconstructed.
struct ReconstructedBlock
{
    std::array<BlockPlane, 5> mean;
    BlockPlane residualVarianceRatio;  ///< share of a pixel's variance that the filters leave, (0, 1]

    /// Not finite beside a pixel that is brighter than a float can hold.
    Radiance MeanOf(std::size_t pixel) const;
};

/// @param spread  of the same blocks; null: nothing
/// @param rows  that are wanted; the others stay as they are
ReconstructedBlock Reconstruct(const PaddedBlock& around, const PaddedSpread* spread = nullptr, const Rows& rows = Rows());

/// The spread estimates alone: of pixels with one sample, whose noise nothing tells, so that no risk is known.
ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const PaddedSpread& spread);

} // namespace tilt_lens

#endif
