// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/convergence.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include "block_estimates.h"
#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/stop_rule/forecast.h"
#include "tilt_lens/stop_rule/pixel_variance.h"

namespace tilt_lens
{
namespace
{

std::size_t ActiveIn(const BlockEstimate& estimate)
{
    return std::count_if(estimate.pixels.begin(), estimate.pixels.end(), [](const PixelEstimate& pixel) { return pixel.active; });
}

std::vector<std::size_t> AllPixels()
{
    std::vector<std::size_t> all(kMiddle.Size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

struct Prepared
{
    BlockEstimate estimate;
    FirstRound round;
    Neighbourhood around;
    SamplingLimits limits;

    Prepared(const SamplingLimits& limits, const Tracer& trace) :
        estimate(FirstEstimate(kMiddle, limits.FirstRound(), trace)), round(estimate), around(Alone(round), limits), limits(limits)
    {
        UpdateVarianceRatios(estimate, limits.FirstRound());
    }
    bool Update(std::uint32_t samples) { return UpdateConvergence(estimate, around, limits, samples); }
};

TEST(ConfidenceFactor, IsTheUpperChiSquareLimitOfAQuadrant)
{
    for (const std::uint32_t samples : {2u, 64u})
    {
        const double freedom = 64.0 * (samples - 1);
        EXPECT_NEAR(ConfidenceFactor(samples, 0.9), freedom / boost::math::quantile(boost::math::chi_squared(freedom), 0.1), 1e-9);
    }
    EXPECT_GT(ConfidenceFactor(8, 0.99), ConfidenceFactor(8, 0.9));
    EXPECT_NEAR(ConfidenceFactor(1u << 20, 0.9), 1.0, 1e-3);
}

TEST(UpdateConvergence, EvenLightConvergesAtOnce)
{
    Prepared even(Limits(8, 1024, 1e-4), Constant);
    EXPECT_FALSE(even.Update(8));
    EXPECT_EQ(ActiveIn(even.estimate), 0u);
}

/// Black samples whose circles are wide: nearly all of a pixel's samples serve others.
std::shared_ptr<const PaddedSpread> WideCircles()
{
    static const LensFootprint lens(Lens(), Aperture::Disc(), 3.0 * Settings::blockSide, 3.0 * Settings::blockSide);
    SpreadSums sums(kMiddle, 3.0 * Settings::blockSide, 3.0 * Settings::blockSide);
    for (int row = 0; row < int(Settings::blockSide); row++)
        for (int column = 0; column < int(Settings::blockSide); column++)
            sums.Add(column, row, {column + 0.5f, row + 0.5f, 6.0f, 0.0f, 0.0f, 6.0f, &lens}, Radiance{});
    PaddedSpread::Sent sent{};
    sent[4] = &sums;
    return PaddedSpread::Of(sent, kFarEdges);
}

TEST(UpdateConvergence, PixelsThatHaveStoppedDoNotKeepAnotherGoing)
{
    constexpr std::size_t x = 7, y = 9, side = Settings::blockSide;
    for (const std::uint32_t samples : {8u, 64u})
    {
        Prepared quiet(Limits(8, 1024, 1e-4), Constant);
        quiet.estimate.spread = WideCircles();
        quiet.Update(8);
        for (std::size_t row = y - 1; row <= y + 1; row++)
            for (std::size_t column = x - 1; column <= x + 1; column++)
                quiet.estimate.pixels[row * side + column].excess = 1.2f;
        quiet.estimate.pixels[y * side + x].active = true;
        TakeRound(quiet.estimate, samples, Constant);
        quiet.Update(samples);
        EXPECT_EQ(ActiveIn(quiet.estimate), samples == 8 ? 1u : 0u) << samples;
    }
}

/// @return  samples of the last round
std::uint32_t TakeAllRounds(Prepared& block, const Tracer& trace)
{
    std::uint32_t samples = block.limits.FirstRound();
    while (block.Update(samples))
    {
        samples *= 2;
        TakeRound(block.estimate, samples, trace);
        UpdateVarianceRatios(block.estimate, samples);
    }
    return samples;
}

double MeanExcess(const BlockEstimate& estimate)
{
    double sum = 0.0;
    for (const PixelEstimate& pixel : estimate.pixels)
        sum += pixel.excess;
    return sum / estimate.pixels.size();
}

TEST(UpdateConvergence, NoiseStaysActiveUntilItsVarianceMeetsTheTarget)
{
    Prepared noisy(Limits(8, 4096, 1e-3), WhiteNoise);
    const std::uint32_t samples = TakeAllRounds(noisy, WhiteNoise);
    EXPECT_GE(samples, 64u);
    EXPECT_LE(samples, 256u);
    EXPECT_LE(MeanExcess(noisy.estimate), 1.0);
    for (std::size_t i = 0; i < kMiddle.Size(); i++)
        EXPECT_LE(noisy.estimate.pixels[i].excess, noisy.estimate.GreatestExcess(i)) << i;
}

/// Noise whose deviation is ten times as great in the first two columns of kMiddle.
void UnevenNoise(const SampleId& id, SampleResult& result)
{
    result = Grey(0.5 + (id.x < kMiddle.left + 2 ? 1.0 : 0.1) * (Noise(id, 1) - 0.5));
}

struct UnevenExcess
{
    double noisy = 0.0, quiet = 0.0;
};

/// Columns beside the border are left out: their windows have both kinds of noise.
UnevenExcess ExcessOfUnevenNoise(double variance, const Settings& settings = {})
{
    SamplingLimits limits = Limits(4, 4096, variance);
    limits.settings = settings;
    Prepared block(limits, UnevenNoise);
    block.estimate.settings = settings;
    TakeAllRounds(block, UnevenNoise);
    UnevenExcess mean;
    for (std::size_t i = 0; i < block.estimate.pixels.size(); i++)
    {
        const std::size_t column = i % Settings::blockSide;
        if (column == 0)
            mean.noisy += block.estimate.pixels[i].excess / Settings::blockSide;
        else if (column > 2)
            mean.quiet += block.estimate.pixels[i].excess / (Settings::blockSide * (Settings::blockSide - 3));
    }
    return mean;
}

TEST(UpdateConvergence, NoisyPixelsMayKeepMoreThanTheTargetWhereOthersKeepLess)
{
    const UnevenExcess mean = ExcessOfUnevenNoise(1e-4);
    EXPECT_GT(mean.noisy, 1.1);
    EXPECT_LT(mean.quiet, 0.75);
    EXPECT_LT((2.0 * mean.noisy + 14.0 * mean.quiet) / 16.0, 1.0);
    Settings equal;
    equal.deviationShare = 0.0;
    EXPECT_LT(ExcessOfUnevenNoise(1e-4, equal).noisy, 1.0);
}

TEST(UpdateConvergence, NoTargetRisesFromFewSamples)
{
    EXPECT_LT(ExcessOfUnevenNoise(1e-2).noisy, 1.0);
}

double MeanExcessOfWhiteNoise(double deviationRatio)
{
    Prepared block(Limits(8, 4096, 1e-4), WhiteNoise);
    block.around.deviationRatio = deviationRatio;
    TakeAllRounds(block, WhiteNoise);
    return MeanExcess(block.estimate);
}

TEST(UpdateConvergence, ABlockMayKeepMoreThanItsTargetWhereNeighboursKeepLess)
{
    EXPECT_LE(MeanExcessOfWhiteNoise(1.0), 1.0);
    EXPECT_GT(MeanExcessOfWhiteNoise(0.3), 1.2) << "quiet neighbours";
    EXPECT_LT(MeanExcessOfWhiteNoise(10.0), 0.6) << "noisy neighbours";
}

TEST(MeanDeviation, IsThatOfOneSampleOverThatWithWhichTheFirstRoundKeepsV)
{
    const SamplingLimits limits = Limits(8, 1024, 1e-4);
    EXPECT_EQ(MeanDeviation(FirstEstimate(kMiddle, 8, Constant), limits), 1.0);
    // windows raise the variances of most pixels
    const double excess = ConfidenceFactor(8, limits.confidence) / 12.0 / 8.0 / 1e-4;
    EXPECT_NEAR(MeanDeviation(FirstEstimate(kMiddle, 8, WhiteNoise), limits), std::sqrt(excess), 0.2 * std::sqrt(excess));
    EXPECT_EQ(MeanDeviation(FirstEstimate(kMiddle, 8, WhiteNoise), Limits(8, 1024, 0.0)), 1.0);
}

TEST(UpdateConvergence, AnUnboundedVarianceKeepsNoOtherPixelActive)
{
    for (const double value : {1e30, double(INFINITY), double(NAN)})
    {
        Prepared block(Limits(8, 1024, 1e-4), Constant);
        block.Update(8);
        for (PixelEstimate& pixel : block.estimate.pixels)
            pixel.excess = 0.9f;
        block.estimate.pixels[100].excess = float(value);
        block.estimate.pixels[100].active = true;
        TakeRound(block.estimate, 16, Constant);
        block.estimate.pixels[100].active = false;  // as if its variance were unknown
        block.Update(16);
        EXPECT_EQ(ActiveIn(block.estimate), 1u) << value;
    }
}

TEST(UpdateConvergence, StopsAtMaximumSamples)
{
    Prepared noisy(Limits(8, 8, 1e-6), WhiteNoise);
    EXPECT_FALSE(noisy.Update(8));
    EXPECT_EQ(ActiveIn(noisy.estimate), kMiddle.Size());
}

TEST(UpdateConvergence, VarianceZeroKeepsEveryPixelActive)
{
    Prepared even(Limits(8, 1024, 0.0), Constant);
    EXPECT_TRUE(even.Update(8));
    EXPECT_EQ(ActiveIn(even.estimate), kMiddle.Size());
}

TEST(UpdateConvergence, OneSampleDecidesNothing)
{
    Prepared one(Limits(1, 16, 1.0), Constant);
    EXPECT_TRUE(one.Update(1));
    EXPECT_EQ(ActiveIn(one.estimate), kMiddle.Size());
}

void LoneHit(const SampleId& id, SampleResult& result)
{
    result = Grey(id.x == kMiddle.left + 8 && id.y == kMiddle.top + 8 && id.index == 3 ? 1.0 : 0.0);
}

TEST(FirstRound, LoneVarianceCountsIsolatedPixelsOnly)
{
    const double inside = Square(Settings::blockSide - 2.0);
    EXPECT_NEAR(FirstRound(FirstEstimate(kMiddle, 8, LoneHit)).loneVariance, 1.0 / 8.0 / inside, 1e-9);
    const auto edge = [](const SampleId& id, SampleResult& result) { result = Grey(id.x == kMiddle.left + 8 && id.index % 2 ? 1.0 : 0.0); };
    EXPECT_EQ(FirstRound(FirstEstimate(kMiddle, 8, edge)).loneVariance, 0.0);
    EXPECT_EQ(FirstRound(FirstEstimate(kMiddle, 8, Constant)).loneVariance, 0.0);
}

TEST(UpdateConvergence, FollowsAnEdgeThatAllMissedAtFirst)
{
    const auto late = [](const SampleId& id, SampleResult& result)
    { result = Grey(id.x == kMiddle.left + 5 && id.index >= 8 && id.index % 2 == 0 ? 1.0 : 0.0); };
    Prepared block(Limits(8, 1024, 1e-4), late);
    ASSERT_FALSE(block.Update(8));
    for (std::uint32_t y = 0; y < Settings::blockSide; y++)
        block.estimate.pixels[y * Settings::blockSide + 5].active = true;
    TakeRound(block.estimate, 16, late);
    block.Update(16);
    for (std::size_t i = 0; i < block.estimate.pixels.size(); i++)
    {
        const std::size_t column = i % Settings::blockSide;
        EXPECT_EQ(block.estimate.pixels[i].active, column >= 4 && column <= 6) << i;
    }
}

/// Neighbours of a pixel with a late hit, which serves them as well.
TEST(UpdateConvergence, PixelsThatReceiveALateHitCountOnTheReconstruction)
{
    constexpr std::size_t middle = 7 * Settings::blockSide + 7;
    const auto late = [](const SampleId& id, SampleResult& result)
    { result = Grey(id.x == kMiddle.left + 7 && id.y == kMiddle.top + 7 && id.index == 9 ? 1.0 : 0.0); };
    for (const bool forecast : {false, true})
    {
        Prepared block(Limits(8, 1024, 6.4e-4), late);
        ASSERT_FALSE(block.Update(8));
        block.estimate.spread = WideCircles();
        for (PixelEstimate& pixel : block.estimate.pixels)
            pixel.forecast = forecast;
        block.estimate.pixels[middle].active = true;
        TakeRound(block.estimate, 16, late);
        block.Update(16);
        EXPECT_EQ(block.estimate.pixels[middle + 1].active, !forecast);
    }
}

TEST(UpdateConvergence, AHitOfOnePixelKeepsTheBlockActive)
{
    const double lone = 1.0 / 8.0 / Square(Settings::blockSide - 2.0);
    Prepared often(Limits(8, 1024, 0.1 * lone / 8.0), LoneHit), seldom(Limits(8, 1024, 10.0 * lone / 8.0), LoneHit);
    often.Update(8);
    seldom.Update(8);
    EXPECT_EQ(ActiveIn(often.estimate), kMiddle.Size());
    EXPECT_LE(ActiveIn(seldom.estimate), 9u) << "the pixel and those beside it";
    const double variance = often.around.loneVariance;
    EXPECT_NEAR(LoneVariance(variance, 8, 16), LoneVariance(variance, 8, 8) / 4.0, 1e-12);
}

PixelStatistics Equal(std::uint32_t samples, double value, double expectedEmission = 0.0)
{
    PixelStatistics pixel;
    pixel.BeginRound(samples);
    for (std::uint32_t i = 0; i < samples; i++)
    {
        SampleResult result;
        result = Radiance{value, value, value, 0.0, 0.0};
        result.expectedEmission = expectedEmission;
        pixel.Add(result);
    }
    return pixel;
}

TEST(HasSearchedEmitters, IsTrueOnceTheirErrorIsBelowTheTarget)
{
    EXPECT_TRUE(HasSearchedEmitters(Equal(4, 0.5), 1e-9, 16)) << "no emitter samples";
    EXPECT_FALSE(HasSearchedEmitters(Equal(4, 0.5, 1.0), 1e-3, 16));
    EXPECT_TRUE(HasSearchedEmitters(Equal(4, 0.5, 0.01), 1e-3, 16)) << "too dim to matter";
    EXPECT_TRUE(HasSearchedEmitters(Equal(16, 0.5, 100.0), 1e-9, 16)) << "believed hidden";
}

TEST(Neighbourhood, ComparesTheDeviationOfTheBlockWithAllAround)
{
    FirstRound own(FirstEstimate(kMiddle, 8, Constant)), left(FirstEstimate(kMiddle, 8, Constant));
    own.deviation = 4.0, left.deviation = 2.0;
    FirstRounds rounds = Alone(own);
    EXPECT_NEAR(Neighbourhood(rounds, Limits(8, 1024, 1e-4)).deviationRatio, 1.0, 1e-12);
    rounds[3] = &left;
    EXPECT_NEAR(Neighbourhood(rounds, Limits(8, 1024, 1e-4)).deviationRatio, 0.75, 1e-12);
}

TEST(Neighbourhood, AveragesFirstRoundsOverTheirPixels)
{
    const FirstRound own(FirstEstimate(kMiddle, 8, LoneHit)), left(FirstEstimate(kMiddle, 8, Constant));
    FirstRounds rounds = Alone(own);
    rounds[3] = &left;
    EXPECT_NEAR(Neighbourhood(rounds, Limits(8, 1024, 1e-4)).loneVariance, own.loneVariance / 2.0, 1e-12);
}

Prepared DimNoise()
{
    SamplingLimits limits = Limits(8, 1024, 1e-3);
    limits.denoise = true;
    return {limits, [](const SampleId& id, SampleResult& result) { result = Grey(0.7 + 0.2 * (Noise(id, 1) - 0.5)); }};
}

TEST(Forecast, PredictsWhatTheReconstructionLeavesOfEvenNoise)
{
    Prepared block = DimNoise();
    for (PixelEstimate& pixel : block.estimate.pixels)
    {
        pixel.variance = pixel.varianceRatio * pixel.statistics.Variance()[0] / 8.0;
        pixel.target = 0.5 * pixel.variance;
    }
    ASSERT_TRUE(UpdateForecast(block.estimate, AllPixels(), block.around, block.limits, 8));
    EXPECT_LT(block.estimate.pixels[100].residualVarianceBound, 0.5);
}

TEST(Forecast, IsSkippedWhereItSavesNoPixel)
{
    Prepared block = DimNoise();
    PixelEstimate& pixel = block.estimate.pixels[100];
    pixel.variance = 4e-4f;
    pixel.target = 1e-3f;  // converged without it
    EXPECT_FALSE(UpdateForecast(block.estimate, {100}, block.around, block.limits, 8));
    pixel.target = 0.9f * pixel.residualVarianceBound * pixel.variance;  // active even with the least bound
    EXPECT_FALSE(UpdateForecast(block.estimate, {100}, block.around, block.limits, 8));
    pixel.target = 1.1f * pixel.residualVarianceBound * pixel.variance;
    EXPECT_TRUE(UpdateForecast(block.estimate, {100}, block.around, block.limits, 8));
}

std::size_t ActiveAfterFirstRound(double variance, bool denoise, const Tracer& trace)
{
    SamplingLimits limits = Limits(8, 1024, variance);
    limits.denoise = denoise;
    Prepared block(limits, trace);
    block.Update(8);
    return ActiveIn(block.estimate);
}

TEST(UpdateConvergence, TheReconstructionSavesRaysOfNoiseButNoneOfALoneHit)
{
    const auto noise = [](const SampleId& id, SampleResult& result) { result = Grey(0.7 + 0.2 * (Noise(id, 1) - 0.5)); };
    const double ofNoise = 0.04 / 12.0 / 8.0, ofLoneHit = 1.0 / 8.0 / Square(Settings::blockSide - 2.0) / 8.0;
    EXPECT_EQ(ActiveAfterFirstRound(0.5 * ofNoise, false, noise), kMiddle.Size());
    EXPECT_LT(ActiveAfterFirstRound(0.5 * ofNoise, true, noise), kMiddle.Size() / 4);
    EXPECT_EQ(ActiveAfterFirstRound(0.1 * ofLoneHit, true, LoneHit), kMiddle.Size());
}

} // namespace
} // namespace tilt_lens
