// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file variance_ratio.h
/// Variance ratio: variance of a mean of stratified samples over that of as many independent samples (the design effect of survey
/// sampling): docs/sampling.md, section 3.
///
/// The squared difference of a pixel's two buffers estimates the variance of its mean, including the effect of stratification, but it is a
/// single number. Its ratio to the variance of independent samples is therefore pooled over pixels.

#ifndef TILT_LENS_VARIANCE_RATIO_H
#define TILT_LENS_VARIANCE_RATIO_H

#include <cstdint>
#include <vector>

#include "tilt_lens/sampling/block_estimate.h"

namespace tilt_lens
{

/// Sums or means over pixels, each summed over the channels.
struct VarianceRatioTerms
{
    double dualBuffer = 0.0;          ///< variance of the mean by the dual buffers
    double independent = 0.0;         ///< variance of the mean if its samples were independent
    double squaredIndependent = 0.0;  ///< squares of each pixel's `independent`

    void Add(const PixelStatistics& pixel);
    /// dualBuffer / independent, shrunk towards the prior `before` (settings.varianceRatioPrior).
    /// @param pixels  number of pixels if the terms are means; 1 if they are sums
    double Ratio(double before, double pixels) const;
};

void AddTo(VarianceRatioTerms& sum, const VarianceRatioTerms& terms);
void DivideBy(VarianceRatioTerms& terms, double divisor);

/// After a round, updates the variance ratios of the block's active pixels, one per quadrant.
/// @param samples  of an active pixel
void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples);

/// Variance ratio of each pixel from the window around it, for the reconstruction: overestimated noise would make filters blur texture. An
/// outlier keeps its own ratio.
std::vector<double> LocalVarianceRatios(const BlockEstimate& estimate);

/// Variance ratio of the mean of both buffers, from the ratio measured between them. If the variance falls as n^-a, a >= 1, the buffers of
/// a prefix of n samples differ by 2^a - 1 times the variance of their mean, and a ratio that began at 1 is n^(1 - a). Both equations have
/// one solution, found by iteration.
double RatioOfMean(double dualBufferRatio, double samples);

} // namespace tilt_lens

#endif
