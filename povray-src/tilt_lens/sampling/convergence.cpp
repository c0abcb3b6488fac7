// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "tilt_lens/sampling/denoiser_forecast.h"
#include "tilt_lens/sampling/undetected_error.h"
#include "tilt_lens/sampling/variance_target.h"

namespace tilt_lens
{

namespace
{

/// Of a pixel's mean.
struct MeanVariance
{
    Radiance whole{}, undetected{};  ///< variance, and its part that is undetected error; each channel relative to its SquaredScale
    double undetectedNoise = 0.0;    ///< this part, summed over the channels and not relative
};

/// @param circle  by the samples of other pixels
MeanVariance EstimatedVariance(PixelEstimate& pixel, const SampleVariation& around, const CircleVariance& circle, double shrinkage)
{
    const PixelStatistics& own = pixel.statistics;
    Radiance undetected = UndetectedError(own, around), whole;
    for (std::size_t c = 0; c < whole.size(); c++)
        whole[c] = (1.0 - shrinkage) * own.Variation().variance[c] + shrinkage * around.variance[c];
    whole = circle.Blend(whole);
    for (std::size_t c = 0; c < whole.size(); c++)
    {
        undetected[c] *= pixel.varianceRatio;
        whole[c] = pixel.varianceRatio * whole[c] / own.Samples() + undetected[c];
    }
    pixel.seenVariance = circle.Blend(own.Variation().variance);
    return {RelativeTo(own.Mean(), whole), RelativeTo(own.Mean(), undetected),
            std::accumulate(undetected.begin(), undetected.end(), 0.0)};
}

/// Whether any of the 3 by 3 pixels around one, as far as they are in the block, is active.
bool IsBesideActive(const BlockEstimate& estimate, std::size_t pixel)
{
    const Area& area = estimate.area;
    const std::uint32_t left = pixel % area.width, top = pixel / area.width;
    for (std::uint32_t y = top - (top > 0); y <= top + 1 && y < area.height; y++)
        for (std::uint32_t x = left - (left > 0); x <= left + 1 && x < area.width; x++)
            if (estimate.pixels[y * area.width + x].active)
                return true;
    return false;
}

} // namespace

double Shrinkage(std::uint32_t samples)
{
    return Square(settings.shrinkageSamples) / (Square(settings.shrinkageSamples) + Square(samples));
}

double ConfidenceFactor(std::uint32_t samples, double shrinkage, double confidence)
{
    // weights of the pixel's own variance and of those around it
    constexpr double pixels = settings.neighbourhoodPixels;
    const double own = 1.0 - shrinkage + shrinkage / pixels, others = (pixels - 1.0) * Square(shrinkage / pixels);
    const double freedom = settings.pooledPixels * (samples - 1) / (Square(own) + others);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits,
                       std::uint32_t samples)
{
    if (samples < 2)
        return samples < limits.max;  // one sample says nothing of its error
    const double shrinkage = Shrinkage(samples), confidence = ConfidenceFactor(samples, shrinkage, limits.confidence);
    const VarianceTarget target(limits, samples);
    const bool uniform = estimate.IsUniform() && around.IsUniformAround();  // evenly lit: no closer look
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (!pixel.active || pixel.statistics.Samples() < samples)
            continue;
        MeanVariance variance;
        if (!uniform)
            variance = EstimatedVariance(pixel, around.Around(estimate, i), estimate.CircleVarianceOf(i), shrinkage);
        pixel.variance = LargestChannel(variance.whole);
        pixel.undetected = LargestChannel(variance.undetected);
        pixel.undetectedNoise = variance.undetectedNoise;
        const double deviation = std::sqrt(pixel.variance / pixel.varianceRatio * samples);
        candidates.push_back({i, variance.whole, target(deviation / around.MeanDeviation()) / confidence});
    }
    if (limits.Denoises())
        ApplyDenoiserForecast(candidates, estimate, around, samples);

    for (const Candidate& one : candidates)
    {
        PixelEstimate& pixel = estimate.pixels[one.pixel];
        pixel.active = !(limits.variance > 0.0 && one.HasConverged() && HasSearchedEmitters(pixel.statistics, one.target));
        pixel.target = one.target;
    }
    return std::any_of(estimate.pixels.begin(), estimate.pixels.end(), [&limits](const PixelEstimate& pixel)
        { return pixel.active && pixel.statistics.Samples() < limits.max; });
}

void Reactivate(BlockEstimate& estimate, const Neighbourhood& around)
{
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (pixel.active || !IsBesideActive(estimate, i))  // nothing new there
            continue;
        const PixelStatistics& own = pixel.statistics;
        const Radiance undetected = UndetectedError(own, around.Around(estimate, i)), mean = own.Mean();
        for (std::size_t c = 0; c < undetected.size(); c++)
            pixel.active |= undetected[c] > settings.reactivationFactor * pixel.target * SquaredScale(mean[c]);
    }
}

} // namespace tilt_lens
