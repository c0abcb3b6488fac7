// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/convergence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/math/rows.h"
#include "tilt_lens/stop_rule/forecast.h"
#include "tilt_lens/stop_rule/pixel_variance.h"

namespace tilt_lens
{

namespace
{

/// Mean excess of the 3 by 3 window within the block. Pixels that have stopped count as if they had taken as many samples as this one, which
/// would otherwise go on in vain for them.
double ExcessAround(const BlockEstimate& estimate, std::size_t pixel)
{
    constexpr int radius = Settings::neighbourRadius;
    const int width = int(estimate.area.width), height = int(estimate.area.height), x = int(pixel) % width, y = int(pixel) / width;
    const Rows rows = Rows{y, y + 1}.Grown(radius, height), columns = Rows{x, x + 1}.Grown(radius, width);
    const double samples = estimate.pixels[pixel].statistics.Samples();
    double sum = 0.0;
    for (int row = rows.begin; row < rows.end; row++)
        for (int column = columns.begin; column < columns.end; column++)
        {
            const PixelEstimate& other = estimate.pixels[row * width + column];
            sum += other.excess * std::min(1.0, other.statistics.Samples() / samples);
        }
    return sum / (rows.Count() * columns.Count());
}

/// Pixels with wide circles of confusion decide with their neighbours: alone, one that missed a lamp by chance would stop dark, and one
/// that hit it would dilute it.
std::vector<double> SharedExcess(const BlockEstimate& estimate)
{
    std::vector<double> excess;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        const double own = estimate.pixels[i].excess, shared = estimate.SharedPart(i);
        excess.push_back(shared > 0.0 ? own + shared * (ExcessAround(estimate, i) - own) : own);
    }
    return excess;
}

/// Variance of a mean of so many samples that is aimed at.
double TargetOf(const SamplingLimits& limits, std::uint32_t samples)
{
    return limits.variance / ConfidenceFactor(samples, limits.confidence);
}

/// Standard deviation of one sample, as defined for MeanDeviation().
/// @param samples  with which the pixel has this excess, over those of the first round
double Deviation(double excess, double samples)
{
    return std::sqrt(std::max(1.0, excess * samples));  // 1 for NaN
}

/// Greatest excess with which each pixel converges. The mean variance is V with the fewest samples if each pixel's variance is in proportion
/// to the standard deviation of one of its samples.
std::vector<double> AllowedExcess(const BlockEstimate& estimate, const std::vector<double>& excess, double firstSamples,
                                  double deviationRatio)
{
    std::vector<double> allowed;
    for (std::size_t i = 0; i < excess.size(); i++)
        allowed.push_back(Deviation(excess[i], estimate.pixels[i].statistics.Samples() / firstSamples));
    const double mean = deviationRatio * std::accumulate(allowed.begin(), allowed.end(), 0.0) / allowed.size();
    for (std::size_t i = 0; i < allowed.size(); i++)
        allowed[i] = std::min(1.0 + estimate.settings.deviationShare * (allowed[i] / mean - 1.0), estimate.GreatestExcess(i));
    return allowed;
}

/// @param samples  taken by active pixels; those with fewer still catch up
void Decide(BlockEstimate& estimate, const Neighbourhood& around, std::uint32_t samples, std::uint32_t firstSamples)
{
    const std::vector<double> excess = SharedExcess(estimate);
    const std::vector<double> allowed = AllowedExcess(estimate, excess, firstSamples, around.deviationRatio);
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        if (pixel.active && pixel.statistics.Samples() < samples)
            continue;
        const bool searching = pixel.active && !HasSearchedEmitters(pixel.statistics, pixel.target, estimate.settings.hiddenEmitterSamples);
        // a pixel that has stopped goes on if its excess grows, not if noisy pixels take more of V
        const double most = pixel.active ? allowed[i] : std::max(1.0, allowed[i]);
        pixel.active = searching || !(excess[i] <= most);  // also if infinite or NaN
    }
}

/// Reconsiders converged pixels whose neighbours have hit more since: an edge is then followed from pixel to pixel. The reconstruction counts
/// as far as samples serve other pixels; otherwise one late hit of a rare highlight would take a whole block to MAX.
void RaiseWhereNeighboursFoundMore(BlockEstimate& estimate, const std::vector<double>& variances)
{
    for (std::size_t i = 0; i < variances.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        const float variance = FiniteFloat(variances[i]);
        if (pixel.active || !(variance > pixel.variance))
            continue;
        const double left = pixel.forecast ? 1.0 + estimate.SharedPart(i) * (pixel.residualVarianceBound - 1.0) : 1.0;
        pixel.excess = FiniteFloat(pixel.excess + left * (double(variance) - pixel.variance) / pixel.target);
        pixel.variance = variance;
    }
}

/// Pixels active in the last round.
std::vector<std::size_t> Candidates(const BlockEstimate& estimate, std::uint32_t samples)
{
    std::vector<std::size_t> candidates;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
        if (estimate.pixels[i].active && estimate.pixels[i].statistics.Samples() >= samples)
            candidates.push_back(i);
    return candidates;
}

}  // namespace

double ConfidenceFactor(std::uint32_t samples, double confidence)
{
    constexpr double pixels = Settings::blockSide * Settings::blockSide / 4;
    const double freedom = pixels * (samples - 1);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

double LoneVariance(double loneVariance, std::uint32_t firstSamples, std::uint32_t samples)
{
    return loneVariance * firstSamples / Square(samples);
}

bool HasSearchedEmitters(const PixelStatistics& own, double target, std::uint32_t most)
{
    const double n = own.EmitterSamples();
    if (n == 0.0 || n >= most)
        return true;
    // square error of a missed lamp of radiance 1: mean of q^2 exp(-q n) over the share q that it covers, uniform in [0, 1]
    const double missed = (2.0 - (2.0 + n * (2.0 + n)) * std::exp(-n)) / (n * n * n);
    return std::min(1.0, Square(own.ExpectedEmission())) * missed <= target;
}

double MeanDeviation(const BlockEstimate& first, const SamplingLimits& limits)
{
    const std::uint32_t samples = limits.FirstRound();
    if (!(limits.variance > 0.0) || samples < 2)
        return 1.0;  // not used then
    const double target = TargetOf(limits, samples);
    double sum = 0.0;
    for (const double variance : VariancesToDecide(first, {0, int(first.area.height)}))
        sum += Deviation(FiniteFloat(variance) / target, 1.0);
    return sum / first.pixels.size();
}

bool UpdateConvergence(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples)
{
    if (samples < 2)
        return samples < limits.max;  // one sample shows no error
    const std::vector<std::size_t> candidates = Candidates(estimate, samples);
    const double target = TargetOf(limits, samples);
    const double lone = LoneVariance(around.loneVariance, limits.FirstRound(), samples);
    const Rows sampled = Rows::Of(candidates, estimate.area.width);
    const std::vector<double> variances = VariancesToDecide(estimate, sampled.Grown(Settings::neighbourRadius, int(estimate.area.height)));
    for (const std::size_t i : candidates)
    {
        estimate.pixels[i].variance = FiniteFloat(variances[i]);
        estimate.pixels[i].target = target;
    }
    if (limits.variance > 0.0)
    {
        RaiseWhereNeighboursFoundMore(estimate, variances);
        const bool reconstructs = limits.Denoises() && limits.settings.forecasts &&
                                  UpdateForecast(estimate, candidates, around, limits, samples);
        for (const std::size_t i : candidates)
        {
            PixelEstimate& pixel = estimate.pixels[i];
            pixel.forecast = reconstructs;
            pixel.excess = FiniteFloat(std::max((reconstructs ? pixel.residualVarianceBound : 1.0) * pixel.variance, lone) / target);
        }
        Decide(estimate, around, samples, limits.FirstRound());
    }
    return std::any_of(estimate.pixels.begin(), estimate.pixels.end(),
                       [&limits](const PixelEstimate& pixel) { return pixel.active && pixel.statistics.Samples() < limits.max; });
}

std::uint32_t ActivateWhereMissed(BlockEstimate& estimate, const PaddedSpread& received, const SamplingLimits& limits)
{
    std::uint32_t fewest = 0;
    for (std::size_t i = 0; i < estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = estimate.pixels[i];
        const PixelStatistics& own = pixel.statistics;
        const Radiance seen = own.Variance();
        Radiance missed = CircleVariance(&received, estimate.PlaceOf(i), own.Samples()).Blend(seen);
        for (std::size_t c = 0; c < missed.size(); c++)
            missed[c] = std::max(0.0, missed[c] - seen[c]) / own.Samples();
        pixel.active = own.Samples() < limits.max && LargestChannel(RelativeTo(own.Mean(), missed)) > limits.variance;
        if (pixel.active)
            fewest = fewest == 0 ? own.Samples() : std::min(fewest, own.Samples());
    }
    return fewest;
}

}  // namespace tilt_lens
