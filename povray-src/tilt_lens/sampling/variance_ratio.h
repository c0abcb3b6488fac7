// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variance_ratio.h
/// How much smaller the variance of a mean of stratified samples is than that of as many independent ones (the inverse of
/// the design effect of survey sampling): docs/sampling.md, section 3.
///
/// The squared difference of a pixel's two buffers tells the variance of its mean with stratification and all, but it is
/// one number. Its ratio to the variance of independent samples is pooled over pixels.

#ifndef TILT_LENS_VARIANCE_RATIO_H
#define TILT_LENS_VARIANCE_RATIO_H

#include <cstdint>
#include <vector>

#include "tilt_lens/sampling/block_estimate.h"

namespace tilt_lens
{

/// Sums, or means, over pixels; of all channels.
struct VarianceRatioTerms
{
    double dualBuffer = 0.0;          ///< variance of the mean by the dual buffers
    double independent = 0.0;         ///< variance of the mean if its samples were independent
    double squaredIndependent = 0.0;  ///< the square of that of each pixel

    void Add(const PixelStatistics& pixel);
    /// The ratio of the first two, shrunk towards one that was known before (settings.varianceRatioPrior).
    /// @param pixels  that the terms are the mean of; 1 where they are sums
    double Ratio(double before, double pixels) const;
};

void AddTo(VarianceRatioTerms& sum, const VarianceRatioTerms& terms);
void DivideBy(VarianceRatioTerms& terms, double divisor);

/// After a round: the variance ratio of the block's active pixels, a quadrant each.
/// @param samples  of an active pixel
void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples);

/// The variance ratio of each pixel from those around it, for the reconstruction: filters that are told too much noise blur
/// texture. A pixel whose own ratio stands out keeps its own.
std::vector<double> LocalVarianceRatios(const BlockEstimate& estimate);

/// What the dual buffers say of the mean of both. With a variance of n^-a, a >= 1, the buffers of a prefix of n differ by
/// 2^a - 1 times the variance of their mean; and a ratio that began at 1 is n^(1 - a). The two together have one solution,
/// found by iteration.
double RatioOfMean(double dualBufferRatio, double samples);

} // namespace tilt_lens

#endif
