// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pixel_variance.h
/// Variance of a pixel's mean: docs/sampling.md, section 3.
///
///     variance ratio * (variance of one sample) / n
///
/// The variance ratio compares a stratified sequence with independent samples. The two sample buffers give one number per pixel, so it is
/// pooled over pixels.

#ifndef TILT_LENS_PIXEL_VARIANCE_H
#define TILT_LENS_PIXEL_VARIANCE_H

#include <cstdint>
#include <vector>

#include "tilt_lens/math/rows.h"
#include "tilt_lens/stop_rule/block_estimate.h"

namespace tilt_lens
{

/// Variance of one sample by all that a pixel receives, its own and those of circles of confusion around: a pixel that missed a blurred
/// lamp learns about it.
class CircleVariance
{
  public:
    /// @param spread   null: none
    /// @param at       index of the pixel in a plane of `spread`
    /// @param samples  taken by the pixel itself
    CircleVariance(const PaddedSpread* spread, std::size_t at, double samples);
    CircleVariance(const BlockEstimate& estimate, std::size_t pixel);

    /// Per channel, for the stop rule: received variance replaces the pixel's own in proportion to the probability that the pixel missed
    /// something. Pixels of one circle thus decide alike.
    /// @param own  by the pixel's own samples
    Radiance Blend(const Radiance& own) const;

    /// The same for the reconstruction, summed over the channels, and never below `own`.
    double AtLeast(double own) const { return own < total ? own + weight * (total - own) : own; }

  private:
    double weight = 0.0;  ///< weight of the received variance, [0, 1]
    double total = 0.0;  ///< variance of one received sample, summed over the channels
    Radiance share{};  ///< each channel's share in `total`
};

/// Per channel, relative to SquaredScale.
/// @param variance  of one sample, by the pixel's own samples or those around
Radiance VarianceOfMean(const BlockEstimate& estimate, std::size_t pixel, const Radiance& variance);

/// The stop rule decides by it: the mean of the colours, over which errors are measured, but at least a share of the worst colour, in
/// which they are seen (docs/sampling.md, section 3). Transparency counts alone.
/// @param variance  without negative channels
double DecisiveVariance(const Radiance& variance);

/// DecisiveVariance() of each pixel's mean, for the stop rule. One sample's variance is at least the 3 by 3 window's mean, since few samples
/// are unreliable.
/// @param rows  rows with results; all others are zero
std::vector<double> VariancesToDecide(const BlockEstimate& estimate, const Rows& rows);

/// Updates active pixels, with one ratio per quadrant.
/// @param samples  of an active pixel
void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples);

/// Ratio of each pixel's quadrant, for the reconstruction; an outlier's own, where nearly all other pixels fill the strata evenly.
std::vector<double> RatiosOrOutliers(const BlockEstimate& estimate);

/// Variance ratio r of the mean, from the ratio r' measured between its buffers. If the variance falls as n^-a, r' = r (g^a - 1) / (g - 1)
/// and r = n^(1 - a); iteration solves both.
/// @param growth  g > 1, all samples over those of the first buffer
double RatioOfMean(double dualBufferRatio, double samples, double growth);

/// Sums over pixels and channels.
struct VarianceRatioTerms
{
    double dualBuffer = 0.0;  ///< variance of the mean by dual buffers
    double independent = 0.0;  ///< variance of the mean of independent samples
    double squaredIndependent = 0.0;  ///< squares of each pixel's `independent`

    void Add(const PixelStatistics& pixel);
    /// dualBuffer / independent, shrunk towards the round before.
    /// @param prior  weight of `before`, in equally noisy pixels
    double Ratio(double before, double prior) const;
};

}  // namespace tilt_lens

#endif
