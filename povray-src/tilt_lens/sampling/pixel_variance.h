// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pixel_variance.h
/// Variance of a pixel's mean: docs/sampling.md, section 3.
///
///     variance ratio * (variance of one sample) / n
///
/// The variance of one sample comes from the pixel's own samples, those of its neighbours, and those that have circles of confusion
/// around the pixel. The variance ratio says how much better n samples of a stratified sequence are than n independent ones. It is
/// measured by the difference of the two sample buffers, a single number for each pixel, and therefore pooled over pixels.

#ifndef TILT_LENS_PIXEL_VARIANCE_H
#define TILT_LENS_PIXEL_VARIANCE_H

#include <cstdint>
#include <vector>

#include "tilt_lens/sampling/block_estimate.h"

namespace tilt_lens
{

/// Variance of a pixel's sample by other pixels' samples. Each sample spreads its radiance and its square over its circle of confusion,
/// so a pixel whose own samples missed a blurred lamp learns about it.
class CircleVariance
{
  public:
    /// @param spread  samples spread by the block and its neighbours; null: none
    /// @param at  index of the pixel in a plane of `spread`
    /// @param samples  taken by the pixel itself
    CircleVariance(const PaddedSpread* spread, std::size_t at, double samples);
    CircleVariance(const BlockEstimate& estimate, std::size_t pixel);

    /// Variance of one sample, per channel, for the stop rule: the received variance replaces the pixel's own in proportion to the
    /// probability that the pixel missed something. Pixels in one circle thus decide alike, whether or not they hit the lamp.
    /// @param own  variance of one sample by the pixel's own samples
    Radiance Blend(const Radiance& own) const;

    /// The same for the reconstruction, summed over the channels, and never below `own`.
    double AtLeast(double own) const { return own < total ? own + weight * (total - own) : own; }

  private:
    double weight = 0.0;  ///< weight of the received variance against the pixel's own, [0, 1]
    double total = 0.0;  ///< variance of one received sample, summed over the channels
    Radiance share{};  ///< share of each channel in `total`
};

/// Variance of a pixel's mean, per channel, relative to its SquaredScale.
/// @param variance  of one sample, by the pixel's own samples or those around
Radiance VarianceOfMean(const BlockEstimate& estimate, std::size_t pixel, const Radiance& variance);

/// Variance of each pixel's mean, for the stop rule: the worst channel. A pixel's variance of one sample is at least the mean of its 3
/// by 3 window, since from few samples its own is unreliable, and zero where a feature was missed.
std::vector<double> VariancesToDecide(const BlockEstimate& estimate);

/// After a round, updates the variance ratios of the block's active pixels, one per quadrant.
/// @param samples  of an active pixel
void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples);

/// Variance ratio of each pixel for the reconstruction: of its quadrant; an outlier's own, where nearly all pixels fill the strata
/// evenly and this one does not.
std::vector<double> RatiosOrOutliers(const BlockEstimate& estimate);

/// Variance ratio of the mean of both buffers, from the ratio measured between them. If the variance falls as n^-a, a >= 1, the buffers
/// of a prefix of n = g n_A samples differ by (g^a - 1) / (g - 1) times the variance of their mean, and a ratio that began at 1 is
/// n^(1 - a). Both equations have one solution, found by iteration.
/// @param growth  g, all samples over those of the first buffer, above 1
double RatioOfMean(double dualBufferRatio, double samples, double growth);

/// Sums over pixels and channels.
struct VarianceRatioTerms
{
    double dualBuffer = 0.0;  ///< variance of the mean by the dual buffers
    double independent = 0.0;  ///< variance of the mean if its samples were independent
    double squaredIndependent = 0.0;  ///< squares of each pixel's `independent`

    void Add(const PixelStatistics& pixel);
    /// dualBuffer / independent, shrunk towards the prior `before` (settings.varianceRatioPrior).
    double Ratio(double before) const;
};

} // namespace tilt_lens

#endif
