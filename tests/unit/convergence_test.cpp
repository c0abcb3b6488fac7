// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Decisions about a block from statistics alone: active pixels, reactivation, and the forecast of the reconstruction.

#include "tilt_lens/sampling/convergence.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include "block_estimates.h"
#include "tilt_lens/sampling/denoiser_forecast.h"
#include "tilt_lens/sampling/variance_ratio.h"

namespace tilt_lens
{
namespace
{

std::size_t ActiveIn(const BlockEstimate& estimate)
{
    return std::count_if(estimate.pixels.begin(), estimate.pixels.end(), [](const PixelEstimate& pixel) { return pixel.active; });
}

/// A block without neighbours after its first round.
struct Prepared
{
    BlockEstimate estimate;
    FirstRound round;
    Neighbourhood around;
    SamplingLimits limits;

    Prepared(const SamplingLimits& limits, const Tracer& trace) :
        estimate(FirstEstimate(kMiddle, limits.FirstRound(), trace)), round(estimate),
        around(Alone(round), limits), limits(limits)
    {
        UpdateVarianceRatios(estimate, limits.FirstRound());
    }
    bool Update(std::uint32_t samples) { return UpdateConvergence(estimate, around, limits, samples); }
};

TEST(Shrinkage, IsOneHalfAtShrinkageSamplesAndFallsWithTheirSquare)
{
    const std::uint32_t half = settings.shrinkageSamples;
    EXPECT_EQ(Shrinkage(half), 0.5);
    EXPECT_NEAR(Shrinkage(1000 * half), 1e-6, 1e-9);
}

TEST(ConfidenceFactor, IsTheUpperChiSquareLimit)
{
    const double freedom = settings.pooledPixels * 7;
    const double limit = boost::math::quantile(boost::math::chi_squared(freedom), 0.1);
    EXPECT_NEAR(ConfidenceFactor(8, 0.0, 0.9), freedom / limit, 1e-12);
    EXPECT_LT(ConfidenceFactor(8, 0.5, 0.9), ConfidenceFactor(8, 0.0, 0.9)) << "nine pixels tell more than one";
    EXPECT_GT(ConfidenceFactor(8, 0.0, 0.99), ConfidenceFactor(8, 0.0, 0.9));
    EXPECT_NEAR(ConfidenceFactor(1u << 22, 0.0, 0.9), 1.0, 1e-3);
}

TEST(UpdateConvergence, EvenLightConvergesAtOnce)
{
    Prepared even(Limits(8, 1024, 1e-4), Constant);
    EXPECT_FALSE(even.Update(8));
    EXPECT_EQ(ActiveIn(even.estimate), 0u);
}

TEST(UpdateConvergence, NoiseStaysActiveUntilItsVarianceMeetsTheTarget)
{
    Prepared noisy(Limits(8, 4096, 1e-3), WhiteNoise);  // variance 1/12 of one sample
    std::uint32_t samples = 8;
    while (noisy.Update(samples))
    {
        samples *= 2;
        TakeRound(noisy.estimate, samples, WhiteNoise);
        UpdateVarianceRatios(noisy.estimate, samples);
    }
    EXPECT_GE(samples, 64u);
    EXPECT_LE(samples, 256u);
    for (const PixelEstimate& pixel : noisy.estimate.pixels)
        EXPECT_LE(pixel.excess, 1.0);
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

TEST(Reactivate, FollowsAnEdgeThatAllMissedAtFirst)
{
    // only a later round hits anything, in one column
    const auto late = [](const SampleId& id, SampleResult& result)
    { result = Grey(id.x == kMiddle.left + 5 && id.index >= 8 && id.index % 2 == 0 ? 1.0 : 0.0); };
    Prepared block(Limits(8, 1024, 1e-4), late);
    ASSERT_FALSE(block.Update(8));
    for (std::uint32_t y = 0; y < settings.blockSide; y++)
        block.estimate.pixels[y * settings.blockSide + 5].active = true;
    TakeRound(block.estimate, 16, late);
    Reactivate(block.estimate, block.around);
    for (std::size_t i = 0; i < block.estimate.pixels.size(); i++)
    {
        const std::size_t column = i % settings.blockSide;
        EXPECT_EQ(block.estimate.pixels[i].active, column >= 4 && column <= 6) << i;
    }
}

/// A single sample, of a pixel in the middle, hits something bright.
void LoneHit(const SampleId& id, SampleResult& result)
{
    result = Grey(id.x == kMiddle.left + 8 && id.y == kMiddle.top + 8 && id.index == 3 ? 1.0 : 0.0);
}

TEST(FirstRound, LoneVarianceCountsIsolatedPixelsOnly)
{
    const double inside = Square(settings.blockSide - 2.0);
    EXPECT_NEAR(FirstRound(FirstEstimate(kMiddle, 8, LoneHit)).loneVariance, 1.0 / 8.0 / inside, 1e-9);
    const auto edge = [](const SampleId& id, SampleResult& result) { result = Grey(id.x == kMiddle.left + 8 && id.index % 2 ? 1.0 : 0.0); };
    EXPECT_EQ(FirstRound(FirstEstimate(kMiddle, 8, edge)).loneVariance, 0.0);
    EXPECT_EQ(FirstRound(FirstEstimate(kMiddle, 8, Constant)).loneVariance, 0.0);
}

TEST(UpdateConvergence, AHitOfOnePixelKeepsTheBlockActive)
{
    const double lone = 1.0 / 8.0 / Square(settings.blockSide - 2.0);
    Prepared often(Limits(8, 1024, 0.1 * lone / 8.0), LoneHit), seldom(Limits(8, 1024, 10.0 * lone / 8.0), LoneHit);
    often.Update(8);
    seldom.Update(8);
    EXPECT_EQ(ActiveIn(often.estimate), kMiddle.Size());
    EXPECT_LE(ActiveIn(seldom.estimate), 9u) << "the pixel and those beside it";
    EXPECT_GE(often.estimate.pixels[0].variance, std::exp(-1.0) * lone / 8.0 * 0.999) << "and it counts as noise";
    EXPECT_NEAR(LoneVariance(often.around, 8, 16), LoneVariance(often.around, 8, 8) / 4.0, 1e-12);
}

TEST(Neighbourhood, UsesFirstRoundsOutsideTheBlock)
{
    const BlockEstimate own = FirstEstimate(kMiddle, 8, Constant);
    const BlockEstimate left = FirstEstimate({0, settings.blockSide, settings.blockSide, settings.blockSide}, 8, WhiteNoise);
    const FirstRound ownRound(own), leftRound(left);
    FirstRounds rounds = Alone(ownRound);
    rounds[3] = &leftRound;
    const Neighbourhood around(rounds, Limits(8, 1024, 1e-4));
    EXPECT_FALSE(around.IsUniformAround());
    EXPECT_NEAR(around.MeanDeviation(), 0.5 * std::sqrt(1.0 / 12.0), 0.02);
    EXPECT_TRUE(IsNonZero(around.Around(own, 3 * settings.blockSide).variance));
    EXPECT_FALSE(IsNonZero(around.Around(own, 3 * settings.blockSide + 1).variance));
    // three pixels outside, of variance 1/12 each, and six inside
    EXPECT_NEAR(around.Around(own, 3 * settings.blockSide).variance[0], 1.0 / 12.0 / 3.0, 0.02);
}

TEST(DenoiserForecast, SubtractsNoiseOfSmoothPixelsButNoUndetectedError)
{
    SamplingLimits limits = Limits(8, 1024, 1e-3);
    limits.denoise = true;
    // dim noise around 0.7
    Prepared block(limits, [](const SampleId& id, SampleResult& result) { result = Grey(0.7 + 0.2 * (Noise(id, 1) - 0.5)); });
    const double undetected = 3e-3;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < block.estimate.pixels.size(); i++)
    {
        PixelEstimate& pixel = block.estimate.pixels[i];
        pixel.seenVariance = pixel.statistics.Variation().variance;
        const double own = pixel.varianceRatio * pixel.statistics.Variation().variance[0] / 8.0;
        const double variance = own + (i < settings.blockSide ? undetected : 0.0);
        candidates.push_back({i, {variance, variance, variance, 0.0, 0.0}, 0.9 * own});
    }
    ApplyDenoiserForecast(candidates, block.estimate, block.around, 8);
    std::size_t converged = 0;
    for (const Candidate& one : candidates)
    {
        if (one.pixel < settings.blockSide)
        {
            EXPECT_GE(LargestChannel(one.variance), undetected - 1e-9) << one.pixel;
        }
        converged += one.HasConverged();
    }
    EXPECT_GT(converged, kMiddle.Size() / 2);
    EXPECT_LT(block.estimate.pixels[100].residualVarianceRatio, 0.5);
}

/// Undetected error counts as a pixel's noise, so that filters may replace the pixel by its surroundings.
TEST(BlockStatistics, NoiseIncludesUndetectedError)
{
    const auto noisyColumn = [](const SampleId& id, SampleResult& result)
    {
        result = Grey(id.x == kMiddle.left + 5 ? Noise(id, 1) : 0.5);
    };
    Prepared block(Limits(8, 1024, 1e-4), noisyColumn);
    block.Update(8);
    UpdateBlockStatistics(block.estimate, 8);
    for (int x = 0; x < int(settings.blockSide); x++)
    {
        const double noise = block.estimate.statistics->Noise()[8 * settings.blockSide + x];
        EXPECT_EQ(noise > 0.0, x >= 4 && x <= 6) << x;
        if (std::abs(x - 5) > settings.neighbourRadius)
        {
            EXPECT_FLOAT_EQ(noise, block.estimate.pixels[8 * settings.blockSide + x].undetectedNoise) << x;
        }
    }
}

TEST(DenoiserForecast, IsSkippedWhereItSavesTooFewRays)
{
    SamplingLimits limits = Limits(8, 1024, 1e-3);
    limits.denoise = true;
    Prepared block(limits, [](const SampleId& id, SampleResult& result) { result = Grey(0.7 + 0.2 * (Noise(id, 1) - 0.5)); });
    std::vector<Candidate> candidates = {{100, {4e-4, 4e-4, 4e-4, 0.0, 0.0}, 3e-4}};
    const Radiance before = candidates[0].variance;
    ApplyDenoiserForecast(candidates, block.estimate, block.around, 8);
    EXPECT_EQ(candidates[0].variance, before);
}

} // namespace
} // namespace tilt_lens
