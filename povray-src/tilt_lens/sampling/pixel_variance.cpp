// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/pixel_variance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "tilt_lens/math/window.h"

namespace tilt_lens
{

CircleVariance::CircleVariance(const PaddedSpread* spread, std::size_t at, double samples)
{
    const double others = spread != nullptr ? spread->SamplesAt(at) : 0.0;
    if (!(others > 0.0))
        return;
    total = spread->variance[at];
    double squaredMean = 0.0;
    for (const auto& plane : spread->mean)
        squaredMean += Square(plane[at]);
    if (!(squaredMean > 0.0) || !std::isfinite(squaredMean + total))
        return;
    // fraction of received samples that hit a light, if a single light against darkness explains both moments
    const double hits = squaredMean / (squaredMean + total), missed = std::exp(-hits * samples);
    weight = missed * others / (others + samples - 1.0);
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

double Shrinkage(std::uint32_t samples)
{
    return Square(settings.shrinkageSamples) / (Square(settings.shrinkageSamples) + Square(samples));
}

std::vector<double> MeanVariances(const BlockEstimate& estimate)
{
    if (!estimate.HasNoise())
        return std::vector<double>(estimate.pixels.size());
    std::vector<Radiance> own;
    for (const PixelEstimate& pixel : estimate.pixels)
        own.push_back(pixel.statistics.Variance());
    const std::vector<Radiance> around = WindowMeans<settings.neighbourRadius>(own, estimate.area.width);
    std::vector<double> variances;
    for (std::size_t i = 0; i < own.size(); i++)
    {
        const PixelEstimate& pixel = estimate.pixels[i];
        const double shrinkage = Shrinkage(pixel.statistics.Samples());
        Radiance variance;
        for (std::size_t c = 0; c < variance.size(); c++)
            variance[c] = (1.0 - shrinkage) * own[i][c] + shrinkage * around[i][c];
        variance = RelativeTo(pixel.statistics.Mean(), CircleVariance(estimate, i).Blend(variance));
        variances.push_back(pixel.varianceRatio * LargestChannel(variance) / pixel.statistics.Samples());
    }
    return variances;
}

void AddTo(VarianceRatioTerms& sum, const VarianceRatioTerms& terms)
{
    sum.dualBuffer += terms.dualBuffer;
    sum.independent += terms.independent;
    sum.squaredIndependent += terms.squaredIndependent;
}

void DivideBy(VarianceRatioTerms& terms, double divisor)
{
    terms.dualBuffer /= divisor;
    terms.independent /= divisor;
    terms.squaredIndependent /= divisor;
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

double VarianceRatioTerms::Ratio(double before, double pixels) const
{
    if (!(squaredIndependent > 0.0))
        return before;
    const double noisyPixels = pixels * Square(independent) / squaredIndependent;
    const double prior = settings.varianceRatioPrior;
    return (noisyPixels * dualBuffer / independent + prior * before) / (noisyPixels + prior);
}

double RatioOfMean(double dualBufferRatio, double samples)
{
    double ratio = std::min(1.0, dualBufferRatio);
    for (int i = 0; i < settings.ratioIterations && ratio > 0.0; i++)
        ratio = std::min(1.0, dualBufferRatio / (std::exp2(1.0 - std::log(ratio) / std::log(samples)) - 1.0));
    return ratio;
}

void UpdateVarianceRatios(BlockEstimate& estimate, std::uint32_t samples)
{
    std::array<VarianceRatioTerms, 4> terms;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
        if (estimate.pixels[i].active && estimate.pixels[i].statistics.Samples() > 1)
            terms[estimate.QuadrantOf(i)].Add(estimate.pixels[i].statistics);
    Quadrants ratio;
    for (std::size_t q = 0; q < ratio.size(); q++)
    {
        double& dualBufferRatio = estimate.dualBufferRatio[q];
        dualBufferRatio = std::min(1.0, terms[q].Ratio(dualBufferRatio, 1.0));
        ratio[q] = RatioOfMean(dualBufferRatio, std::max(2u, samples));
    }
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
        if (estimate.pixels[i].active)
            estimate.pixels[i].varianceRatio = ratio[estimate.QuadrantOf(i)];
}

std::vector<double> LocalVarianceRatios(const BlockEstimate& estimate)
{
    std::vector<VarianceRatioTerms> own(estimate.pixels.size());
    for (std::size_t i = 0; i < own.size(); i++)
        own[i].Add(estimate.pixels[i].statistics);
    const std::vector<VarianceRatioTerms> around = WindowMeans<settings.ratioRadius>(own, estimate.area.width);
    std::vector<double> ratios;
    for (std::size_t i = 0; i < own.size(); i++)
    {
        const double ofQuadrant = estimate.dualBufferRatio[estimate.QuadrantOf(i)];
        const double local = around[i].Ratio(ofQuadrant, Square(2 * settings.ratioRadius + 1));
        // the dual buffers overestimate all ratios of a quadrant by the same factor
        const double ratio = ofQuadrant > 0.0 ? estimate.pixels[i].varianceRatio * std::min(1.0, local) / ofQuadrant : 0.0;
        // an outlier: nearly all pixels fill the strata evenly, this one does not
        const double itself = own[i].independent > 0.0 ? std::min(1.0, own[i].dualBuffer / own[i].independent) : 0.0;
        ratios.push_back(itself > settings.outlyingRatio * ratio ? itself : ratio);
    }
    return ratios;
}

} // namespace tilt_lens
