// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/pixel_variance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "tilt_lens/math/window.h"

namespace tilt_lens
{

namespace
{

/// Probability that one sample hits the light, if one light against darkness explains mean and variance.
double HitProbability(double squaredMean, double variance)
{
    return squaredMean > 0.0 ? squaredMean / (squaredMean + variance) : 0.0;
}

double SquaredSum(const Radiance& light)
{
    return std::inner_product(light.begin(), light.end(), light.begin(), 0.0);
}

/// Weights of the surrounding pixels' excess variance: less than 1 beyond Settings::reliableSamples.
std::vector<double> WeightsOf(const BlockEstimate& estimate, const std::vector<Radiance>& variancesAround, const Rows& rows)
{
    std::vector<double> weights(estimate.pixels.size(), 1.0);
    const auto isBeyond = [](const PixelEstimate& pixel) { return pixel.statistics.Samples() > Settings::reliableSamples; };
    if (std::none_of(estimate.pixels.begin(), estimate.pixels.end(), isBeyond))
        return weights;
    std::vector<Radiance> light;
    for (const PixelEstimate& pixel : estimate.pixels)
        light.push_back(pixel.statistics.Mean());
    const auto around = WindowMeans<Settings::neighbourRadius>(light, estimate.area.width, rows);
    for (std::size_t i = 0; i < weights.size(); i++)
    {
        const double more = std::max(0.0, double(estimate.pixels[i].statistics.Samples()) - Settings::reliableSamples);
        const double variance = std::accumulate(variancesAround[i].begin(), variancesAround[i].end(), 0.0);
        const double hits = more * HitProbability(SquaredSum(around[i]), variance);
        if (hits > 0.0)
            weights[i] = -std::expm1(-hits) / hits;
    }
    return weights;
}

} // namespace

CircleVariance::CircleVariance(const PaddedSpread* spread, std::size_t at, double samples)
{
    const double received = spread != nullptr ? spread->samples[at] : 0.0;
    if (!(received > 0.0))
        return;
    total = spread->variance[at];
    double squaredMean = 0.0;
    for (const auto& plane : spread->mean)
        squaredMean += Square(plane[at]);
    if (!(squaredMean > 0.0) || !std::isfinite(squaredMean + total))
        return;
    weight = std::exp(-HitProbability(squaredMean, total) * samples) * received / (received + samples - 1.0);
    for (std::size_t c = 0; c < spread->mean.size(); c++)
        share[c] = Square(spread->mean[c][at]) / squaredMean;
}

Radiance CircleVariance::Blend(const Radiance& own) const
{
    Radiance blend;
    for (std::size_t c = 0; c < blend.size(); c++)
        blend[c] = own[c] + weight * (total * share[c] - own[c]);
    return blend;
}

CircleVariance::CircleVariance(const BlockEstimate& estimate, std::size_t pixel) :
    CircleVariance(estimate.spread.get(), estimate.PlaceOf(pixel), estimate.pixels[pixel].statistics.Samples())
{
}

Radiance VarianceOfMean(const BlockEstimate& estimate, std::size_t pixel, const Radiance& variance)
{
    const PixelEstimate& its = estimate.pixels[pixel];
    Radiance ofMean = RelativeTo(its.statistics.Mean(), CircleVariance(estimate, pixel).Blend(variance));
    for (double& channel : ofMean)
        channel *= its.varianceRatio / its.statistics.Samples();
    return ofMean;
}

double DecisiveVariance(const Radiance& variance)
{
    const double worst = std::max({variance[0], variance[1], variance[2]});
    return std::max({MeanColour(variance), Settings::worstColourShare * worst, variance[3], variance[4]});
}

std::vector<double> VariancesToDecide(const BlockEstimate& estimate, const Rows& rows)
{
    const std::size_t width = estimate.area.width;
    std::vector<double> variances(estimate.pixels.size());
    if (!estimate.HasNoise())
        return variances;
    std::vector<Radiance> own;
    for (const PixelEstimate& pixel : estimate.pixels)
        own.push_back(pixel.statistics.Variance());
    const auto around = WindowMeans<Settings::neighbourRadius>(own, int(width), rows);
    const std::vector<double> weights = WeightsOf(estimate, around, rows);
    for (std::size_t i = rows.begin * width; i < rows.end * width; i++)
    {
        Radiance greater = own[i];
        for (std::size_t c = 0; c < greater.size(); c++)
            greater[c] += weights[i] * std::max(0.0, around[i][c] - own[i][c]);
        variances[i] = DecisiveVariance(VarianceOfMean(estimate, i, greater));
    }
    return variances;
}

void VarianceRatioTerms::Add(const PixelStatistics& pixel)
{
    const double n = pixel.Samples(), a = pixel.FirstBufferSamples(), b = n - a;
    const Radiance difference = pixel.DualBufferDifference();
    const Radiance variance = pixel.Variance();
    double ofPixel = 0.0;
    for (std::size_t c = 0; c < difference.size(); c++)
    {
        dualBuffer += Square(difference[c]) * (a * b) / (n * n);
        ofPixel += variance[c] / n;
    }
    independent += ofPixel;
    squaredIndependent += Square(ofPixel);
}

double VarianceRatioTerms::Ratio(double before, double prior) const
{
    if (!(squaredIndependent > 0.0))
        return before;
    const double noisyPixels = Square(independent) / squaredIndependent;
    return (noisyPixels * dualBuffer / independent + prior * before) / (noisyPixels + prior);
}

double RatioOfMean(double dualBufferRatio, double samples, double growth)
{
    double ratio = std::min(1.0, dualBufferRatio);
    for (int i = 0; i < Settings::ratioIterations && ratio > 0.0; i++)
        ratio = std::min(1.0, dualBufferRatio * (growth - 1.0) / (std::pow(growth, 1.0 - std::log(ratio) / std::log(samples)) - 1.0));
    return ratio;
}

void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples)
{
    std::array<VarianceRatioTerms, 4> terms;
    double growth = 2.0;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        const PixelStatistics& pixel = estimate.pixels[i].statistics;
        if (!estimate.pixels[i].active || pixel.Samples() < 2)
            continue;
        terms[estimate.QuadrantOf(i)].Add(pixel);
        growth = double(pixel.Samples()) / pixel.FirstBufferSamples();
    }
    Quadrants ratio;
    for (std::size_t q = 0; q < ratio.size(); q++)
    {
        double& dualBufferRatio = estimate.dualBufferRatio[q];
        dualBufferRatio = std::min(1.0, terms[q].Ratio(dualBufferRatio, estimate.settings.varianceRatioPrior));
        ratio[q] = RatioOfMean(dualBufferRatio, std::max(2u, samples), growth);
    }
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
        if (estimate.pixels[i].active)
            estimate.pixels[i].varianceRatio = ratio[estimate.QuadrantOf(i)];
}

std::vector<double> RatiosOrOutliers(const BlockEstimate& estimate)
{
    std::vector<double> ratios;
    for (const PixelEstimate& pixel : estimate.pixels)
    {
        VarianceRatioTerms own;
        own.Add(pixel.statistics);
        const double itself = own.independent > 0.0 ? std::min(1.0, own.dualBuffer / own.independent) : 0.0;
        ratios.push_back(itself > Settings::outlyingRatio * pixel.varianceRatio ? itself : pixel.varianceRatio);
    }
    return ratios;
}

} // namespace tilt_lens
