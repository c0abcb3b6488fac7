// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/pixel_variance.h"

#include <cmath>

#include <gtest/gtest.h>

#include "block_estimates.h"

namespace tilt_lens
{
namespace
{

void Ramp(const SampleId& id, SampleResult& result)
{
    result = Grey(SequencePointOf(id).lensU);
}

Quadrants RatiosOf(const Tracer& trace, std::uint32_t rounds)
{
    BlockEstimate estimate = FirstEstimate(kMiddle, 8, trace);
    for (std::uint32_t round = 0, samples = 8; round < rounds; round++, samples *= 2)
    {
        if (round > 0)
            TakeRound(estimate, samples, trace);
        UpdateVarianceRatios(estimate, samples);
    }
    return {estimate.pixels[0].varianceRatio, estimate.pixels[Settings::blockSide - 1].varianceRatio,
            estimate.pixels[Settings::blockSide * (Settings::blockSide - 1)].varianceRatio, estimate.pixels.back().varianceRatio};
}

TEST(VarianceRatio, IsAboutOneForIndependentSamples)
{
    double sum = 0.0;
    constexpr std::uint32_t blocks = 25;
    for (std::uint32_t block = 0; block < blocks; block++)
    {
        const auto noise = [block](const SampleId& id, SampleResult& result) { result = Grey(Noise(id, 100 + block)); };
        for (const double ratio : RatiosOf(noise, 4))
        {
            EXPECT_LE(ratio, 1.0);
            sum += ratio / (4 * blocks);
        }
    }
    EXPECT_GT(sum, 0.85);  // ratios above 1 are clamped
}

TEST(VarianceRatio, FallsWithTheNumberOfStratifiedSamples)
{
    double before = 1.0;
    for (std::uint32_t rounds = 1; rounds < 5; rounds++)
    {
        double greatest = 0.0;
        for (const double ratio : RatiosOf(Ramp, rounds))
            greatest = std::max(greatest, ratio);
        EXPECT_LT(greatest, 0.5 * before) << rounds;
        before = greatest;
    }
    EXPECT_LT(before, 1.0 / 32.0);
}

TEST(VarianceRatio, IsEstimatedForEachQuadrant)
{
    const Quadrants ratios = RatiosOf([](const SampleId& id, SampleResult& result)
    { (id.x < kMiddle.left + Settings::blockSide / 2 ? Ramp : WhiteNoise)(id, result); }, 3);
    EXPECT_LT(ratios[0], 0.2);
    EXPECT_GT(ratios[1], 0.6);
    EXPECT_LT(ratios[2], 0.2);
    EXPECT_GT(ratios[3], 0.6);
}

TEST(VarianceRatio, ConvergedPixelsKeepTheirsAndDoNotContribute)
{
    BlockEstimate estimate = FirstEstimate(kMiddle, 8, Ramp);
    for (PixelEstimate& pixel : estimate.pixels)
        pixel.active = false;
    UpdateVarianceRatios(estimate, 8);
    for (const PixelEstimate& pixel : estimate.pixels)
        EXPECT_EQ(pixel.varianceRatio, 1.0);
    EXPECT_EQ(estimate.dualBufferRatio, (Quadrants{1.0, 1.0, 1.0, 1.0}));
}

TEST(VarianceRatio, IsShrunkTowardsThePriorForFewNoisyPixels)
{
    const double prior = Settings().varianceRatioPrior;
    VarianceRatioTerms one;
    one.dualBuffer = 0.0, one.independent = 1.0, one.squaredIndependent = 1.0;
    EXPECT_NEAR(one.Ratio(0.9, prior), 0.9 * prior / (1.0 + prior), 1e-15);
    VarianceRatioTerms many;
    many.dualBuffer = 0.0, many.independent = 25.0, many.squaredIndependent = 25.0;
    EXPECT_NEAR(many.Ratio(0.9, prior), 0.9 * prior / (25.0 + prior), 1e-15);
    EXPECT_EQ(VarianceRatioTerms().Ratio(0.9, prior), 0.9) << "no noise at all";
}

TEST(VarianceRatio, RatioOfMeanSolvesBothEquations)
{
    for (const double n : {8.0, 64.0, 4096.0})
        for (const double slope : {1.0, 1.25, 1.5})
            for (const double growth : {4.0 / 3.0, 1.5, 2.0})
            {
                const double ratio = std::pow(n, 1.0 - slope), measured = ratio * (std::pow(growth, slope) - 1.0) / (growth - 1.0);
                EXPECT_NEAR(RatioOfMean(measured, n, growth), ratio, 0.06 * ratio) << n << ", " << slope << ", " << growth;
            }
}

TEST(DecisiveVariance, IsTheMeanOfTheColoursOrAShareOfTheWorst)
{
    EXPECT_DOUBLE_EQ(DecisiveVariance({0.3, 0.3, 0.3, 0.0, 0.0}), 0.3);
    EXPECT_DOUBLE_EQ(DecisiveVariance({0.3, 0.4, 0.2, 0.0, 0.0}), 0.3);
    EXPECT_DOUBLE_EQ(DecisiveVariance({0.0, 0.6, 0.0, 0.0, 0.0}), Settings::worstColourShare * 0.6);
    EXPECT_DOUBLE_EQ(DecisiveVariance({0.0, 0.6, 0.0, 0.0, 0.5}), 0.5);
}

TEST(VariancesToDecide, AreThoseOfTheWantedRows)
{
    const auto noise = [](const SampleId& id, SampleResult& result)
    { result = Radiance{Noise(id, 1), Noise(id, 2) * id.x / 32.0, 0.0, 0.0, 0.0}; };
    const BlockEstimate estimate = FirstEstimate(kMiddle, 32, noise);
    constexpr int side = Settings::blockSide;
    const std::vector<double> all = VariancesToDecide(estimate, {0, side}), some = VariancesToDecide(estimate, {3, 7});
    for (int i = 0; i < side * side; i++)
    {
        EXPECT_GT(all[i], 0.0) << i;
        EXPECT_EQ(some[i], i >= 3 * side && i < 7 * side ? all[i] : 0.0) << i;
    }
}

TEST(RatiosOrOutliers, AnOutlierKeepsItsOwn)
{
    const auto split = [](const SampleId& id, SampleResult& result)
    {
        const bool standsOut = id.x == kMiddle.left + 7 && id.y == kMiddle.top + 9;
        result = Grey(standsOut ? id.index < 2 : id.index % 2);
    };
    BlockEstimate estimate = FirstEstimate(kMiddle, 4, split);
    UpdateVarianceRatios(estimate, 4);
    const std::vector<double> ratios = RatiosOrOutliers(estimate);
    for (std::size_t i = 0; i < ratios.size(); i++)
    {
        if (i == 9 * Settings::blockSide + 7)
            EXPECT_EQ(ratios[i], 1.0);
        else
            EXPECT_LT(ratios[i], 0.25) << i;
    }
}

} // namespace
} // namespace tilt_lens
