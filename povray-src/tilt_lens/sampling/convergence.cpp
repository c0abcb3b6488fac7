// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "tilt_lens/math/window.h"
#include "tilt_lens/sampling/denoiser_forecast.h"
#include "tilt_lens/sampling/undetected_error.h"
#include "tilt_lens/sampling/variance_target.h"

namespace tilt_lens
{

namespace
{

struct MeanVariance
{
    Radiance whole{}, undetected{};  ///< variance, and its undetected part; each channel relative to its SquaredScale
    double undetectedNoise = 0.0;    ///< undetected variance, summed over the channels, absolute
};

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

/// True if a pixel of the 3 by 3 window, within the block, is active.
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

/// Pixels with wide circles of confusion decide together with their neighbours, since all see the same: if each decided alone, a pixel that
/// missed a lamp by chance would stop dark, and one that hit it would go on and dilute it. Sharp pixels decide alone.
/// @param samples  taken by pixels that have been active; active pixels with fewer still have to catch up
void DecideTogether(BlockEstimate& estimate, std::uint32_t samples)
{
    std::vector<double> excesses;
    for (const PixelEstimate& pixel : estimate.pixels)
        excesses.push_back(pixel.excess);
    const std::vector<double> around = WindowMeans<settings.neighbourRadius>(excesses, estimate.area.width);
    for (std::size_t i = 0; i < excesses.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (pixel.active && pixel.statistics.Samples() < samples)
            continue;
        const double others = estimate.SamplesReceivedBy(i), together = others / (others + settings.samplesToDecideTogether);
        const bool searching = pixel.active && !HasSearchedEmitters(pixel.statistics, pixel.target);
        // also of variances that are beyond a double
        pixel.active = searching || !(pixel.excess + together * (around[i] - pixel.excess) <= 1.0);
    }
}

} // namespace

double Shrinkage(std::uint32_t samples)
{
    return Square(settings.shrinkageSamples) / (Square(settings.shrinkageSamples) + Square(samples));
}

double ConfidenceFactor(std::uint32_t samples, double shrinkage, double confidence)
{
    // sums of squared weights of the pixel's own variance and of its neighbours'
    constexpr double pixels = settings.neighbourhoodPixels;
    const double own = 1.0 - shrinkage + shrinkage / pixels, others = (pixels - 1.0) * Square(shrinkage / pixels);
    const double freedom = settings.pooledPixels * (samples - 1) / (Square(own) + others);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

double LoneVariance(const Neighbourhood& around, std::uint32_t firstSamples, std::uint32_t samples)
{
    return settings.loneVarianceFactor * around.LoneVariance() * firstSamples / Square(samples);
}

bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits,
                       std::uint32_t samples)
{
    if (samples < 2)
        return samples < limits.max;  // one sample shows no error
    const double shrinkage = Shrinkage(samples), confidence = ConfidenceFactor(samples, shrinkage, limits.confidence);
    const VarianceTarget target(limits, samples);
    const double lone = LoneVariance(around, estimate.firstSamples, samples);
    const bool uniform = estimate.IsUniform() && around.IsUniformAround();  // no noise at all
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (!pixel.active || pixel.statistics.Samples() < samples)
            continue;
        MeanVariance variance;
        if (!uniform)
            variance = EstimatedVariance(pixel, around.Around(estimate, i), estimate.CircleVarianceOf(i), shrinkage);
        // n samples miss a feature of share 1/n with probability exp(-1)
        pixel.variance = std::max(LargestChannel(variance.whole), std::exp(-1.0) * lone);
        pixel.undetected = LargestChannel(variance.undetected);
        pixel.undetectedNoise = variance.undetectedNoise;
        for (double& channel : variance.whole)
            channel = std::max(channel, lone);
        const double deviation = std::sqrt(LargestChannel(variance.whole) / pixel.varianceRatio * samples);
        pixel.target = target(deviation / around.MeanDeviation()) / confidence;
        candidates.push_back({i, variance.whole, pixel.target});
    }
    if (!(limits.variance > 0.0))
        return samples < limits.max;
    if (limits.Denoises())
        ApplyDenoiserForecast(candidates, estimate, around, samples);
    for (const Candidate& one : candidates)
        estimate.pixels[one.pixel].excess = LargestChannel(one.variance) / one.target;
    DecideTogether(estimate, samples);
    return std::any_of(estimate.pixels.begin(), estimate.pixels.end(), [&limits](const PixelEstimate& pixel)
        { return pixel.active && pixel.statistics.Samples() < limits.max; });
}

void Reactivate(BlockEstimate& estimate, const Neighbourhood& around)
{
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (pixel.active || !IsBesideActive(estimate, i))  // no new samples there
            continue;
        const PixelStatistics& own = pixel.statistics;
        const Radiance undetected = UndetectedError(own, around.Around(estimate, i)), mean = own.Mean();
        for (std::size_t c = 0; c < undetected.size(); c++)
            pixel.active |= undetected[c] > settings.reactivationFactor * pixel.target * SquaredScale(mean[c]);
    }
}

std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits)
{
    std::uint32_t fewest = 0;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        const PixelStatistics& own = pixel.statistics;
        const Radiance& seen = own.Variation().variance;
        Radiance missed = CircleVariance(&received, estimate.PlaceOf(i), own.Samples()).Blend(seen);
        for (std::size_t c = 0; c < missed.size(); c++)
            missed[c] = std::max(0.0, missed[c] - seen[c]) / own.Samples();
        pixel.active = own.Samples() < limits.max && LargestChannel(RelativeTo(own.Mean(), missed)) > settings.missedVariance * limits.variance;
        if (pixel.active)
            fewest = fewest == 0 ? own.Samples() : std::min(fewest, own.Samples());
    }
    return fewest;
}

} // namespace tilt_lens
