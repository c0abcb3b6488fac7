// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/pixel_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

SampleResult Result(double value)
{
    SampleResult result;
    result = Radiance{value, 2.0 * value, 0.0, 0.0, 1.0};
    return result;
}

PixelStatistics StatisticsOf(const std::vector<double>& values)
{
    PixelStatistics pixel;
    for (std::size_t until = 4; pixel.Samples() < values.size(); until *= 2)
    {
        pixel.BeginRound(until);
        while (pixel.Samples() < until)
            pixel.Add(Result(values[pixel.Samples()]));
    }
    return pixel;
}

TEST(PixelStatistics, HasMeanAndVarianceOfTheSamples)
{
    const std::vector<double> values = {0.1, 0.9, 0.4, 0.2, 0.3, 0.3, 0.8, 0.2};
    const PixelStatistics pixel = StatisticsOf(values);
    double mean = 0.0, variance = 0.0;
    for (const double value : values)
        mean += value / 8.0;
    for (const double value : values)
        variance += Square(value - mean) / 7.0;
    EXPECT_EQ(pixel.Samples(), 8u);
    EXPECT_NEAR(pixel.Mean()[0], mean, 1e-15);
    EXPECT_NEAR(pixel.Mean()[1], 2.0 * mean, 1e-15);
    EXPECT_NEAR(pixel.Variance()[0], variance, 1e-6 * variance);
    EXPECT_NEAR(pixel.Variance()[1], 4.0 * variance, 4e-6 * variance);
    EXPECT_EQ(pixel.Variance()[4], 0.0);
}

TEST(PixelStatistics, BuffersSplitTheFirstRoundAndSeparateTheLast)
{
    const PixelStatistics first = StatisticsOf({0.0, 1.0, 2.0, 4.0});
    EXPECT_EQ(first.FirstBufferSamples(), 2u);
    EXPECT_NEAR(first.DualBufferDifference()[0], 0.5 - 3.0, 1e-15);
    const PixelStatistics third = StatisticsOf({1, 1, 1, 1, 2, 2, 2, 2, 5, 5, 5, 5, 5, 5, 5, 5});
    EXPECT_EQ(third.FirstBufferSamples(), 8u);
    EXPECT_NEAR(third.DualBufferDifference()[0], 1.5 - 5.0, 1e-15);
}

TEST(PixelStatistics, NonFiniteSamplesAreBlackAndCounted)
{
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL})
    {
        const PixelStatistics pixel = StatisticsOf({1.0, bad, 1.0, 1.0}), black = StatisticsOf({1.0, 0.0, 1.0, 1.0});
        EXPECT_EQ(pixel.NotFinite(), 1u);
        EXPECT_EQ(black.NotFinite(), 0u);
        EXPECT_NEAR(pixel.Mean()[0], 0.75, 1e-15);
        EXPECT_EQ(pixel.Variance()[0], black.Variance()[0]);
    }
}

void ExpectNear(const Radiance& a, const Radiance& b, double tolerance)
{
    for (std::size_t c = 0; c < a.size(); c++)
        EXPECT_NEAR(a[c], b[c], tolerance * (1.0 + std::fabs(b[c]))) << "channel " << c;
}

TEST(PixelStatistics, AddingGroupsEqualsAddingOneByOne)
{
    for (const double odd : {0.3, 1e30, HUGE_VAL, std::numeric_limits<double>::quiet_NaN()})
        for (const std::uint32_t group : {2u, 3u, 8u, 16u})
        {
            std::vector<SampleResult> results(32);
            for (std::uint32_t i = 0; i < 32; i++)
            {
                results[i].radiance = {0.1 * (i % 7), 1.0 / (i + 1), -0.5 * i, i == 9 ? odd : 0.7, i == 20 ? odd : 0.0};
                results[i].expectedEmission = i % 4 == 1 ? 0.25 * i : 0.0;
            }
            PixelStatistics together, single;
            for (const std::uint32_t until : {8u, 16u, 32u})
            {
                together.BeginRound(until);
                single.BeginRound(until);
                for (std::uint32_t i = single.Samples(); i < until; i++)
                    single.Add(results[i]);
                for (std::uint32_t i = together.Samples(); i < until; i = together.Samples())
                    together.Add(&results[i], std::min(group, until - i));
                EXPECT_EQ(together.Samples(), single.Samples());
                EXPECT_EQ(together.NotFinite(), single.NotFinite());
                EXPECT_EQ(together.EmitterSamples(), single.EmitterSamples());
                EXPECT_EQ(together.ExpectedEmission(), single.ExpectedEmission());
                ExpectNear(together.Mean(), single.Mean(), 1e-14);
                ExpectNear(together.DualBufferDifference(), single.DualBufferDifference(), 1e-14);
                ExpectNear(together.Variance(), single.Variance(), 1e-6);
            }
        }
}

TEST(PixelStatistics, VarianceIsWithinEmitterSamplesAndWithinPlainOnes)
{
    PixelStatistics pixel;
    pixel.BeginRound(8);
    for (int i = 0; i < 8; i++)
    {
        SampleResult result = Result(i % 2 ? 0.25 : 3.0);
        result.expectedEmission = i % 2 ? 0.0 : 0.5;
        pixel.Add(result);
    }
    EXPECT_EQ(pixel.EmitterSamples(), 4u);
    EXPECT_EQ(pixel.ExpectedEmission(), 0.5);
    EXPECT_NEAR(pixel.Variance()[0], 0.0, 1e-15);
    EXPECT_NEAR(pixel.Mean()[0], 1.625, 1e-15);
}

TEST(PixelStatistics, VarianceIsPreciseBesideALargeMean)
{
    for (const double mean : {0.0, 1e3, 1e6})
    {
        std::vector<double> values;
        for (int i = 0; i < 4096; i++)
            values.push_back(mean + (i * 2654435761u % 4096) / 4096.0);
        EXPECT_NEAR(StatisticsOf(values).Variance()[0], 4096.0 * 4097.0 / (12.0 * 4096.0 * 4096.0), 1e-5 / 12.0) << mean;
    }
}

TEST(PixelStatistics, TheGreatestRadiancesHaveMeanAndVariance)
{
    for (const double bright : {1e10, 1e18, 1e25, 3e38})
        for (const std::size_t place : {0u, 3u, 5u, 15u})
        {
            std::vector<double> values(16, 0.25);
            values[place] = bright;
            const PixelStatistics pixel = StatisticsOf(values);
            EXPECT_DOUBLE_EQ(pixel.Mean()[0], (bright + 15.0 * 0.25) / 16.0);
            EXPECT_NEAR(pixel.Variance()[0] / Square(bright), 1.0 / 16.0, 1e-6);
            values[place] = 0.25;
            EXPECT_EQ(StatisticsOf(values).Variance()[0], 0.0);
        }
}

} // namespace
} // namespace tilt_lens
