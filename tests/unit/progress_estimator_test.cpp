// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/progress_estimator.h"
#include "tilt_lens/settings.h"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

SamplingLimits Limits(std::uint32_t min, std::uint32_t max, double variance)
{
    SamplingLimits limits;
    limits.min = min, limits.max = max, limits.variance = variance;
    return limits;
}

Radiance Grey(double value)
{
    return {value, value, value, 0.0, 0.0};
}

void TryAll(ProgressEstimator& map, std::uint32_t x, double right)
{
    while (const std::optional<ProgressEstimator::Probe> probe = map.NextProbe())
        map.SetWeight(probe->block, probe->x < x ? 1.0 : right);
}

TEST(ExpectedSamples, IsTheSampleVarianceOverTheTarget)
{
    // 0 and 1 in turn have the variance 8/7 * 1/4
    std::vector<Radiance> tried;
    for (int i = 0; i < 8; i++)
        tried.push_back(Grey(i % 2));
    EXPECT_NEAR(ExpectedSamples(Limits(8, 100000, 1e-3), tried), 2.0 / 7.0 / 1e-3, 1e-9);
    EXPECT_EQ(ExpectedSamples(Limits(8, 100, 1e-3), tried), 100.0) << "never more than MAX";
    EXPECT_EQ(ExpectedSamples(Limits(8, 100, 0.0), tried), 100.0) << "variance 0 takes MAX";
}

TEST(ExpectedSamples, IsTheMinimumForEvenPixels)
{
    EXPECT_EQ(ExpectedSamples(Limits(8, 1024, 1e-4), std::vector<Radiance>(8, Grey(0.3))), 8.0);
    EXPECT_EQ(ExpectedSamples(Limits(64, 1024, 1e-4), std::vector<Radiance>(8, Grey(0.3))), 64.0);
    EXPECT_EQ(ExpectedSamples(Limits(1, 1, 1e-4), std::vector<Radiance>(1, Grey(0.3))), 1.0);
}

TEST(ExpectedSamples, IsRelativeAboveWhite)
{
    std::vector<Radiance> dark, bright;
    for (int i = 0; i < 8; i++)
        dark.push_back(Grey(0.4 + 0.2 * (i % 2))), bright.push_back(Grey(40.0 + 20.0 * (i % 2)));
    const SamplingLimits limits = Limits(1, 1000000, 1e-5);
    EXPECT_NEAR(ExpectedSamples(limits, bright), ExpectedSamples(limits, dark) * 1e4 / 2500.0, 1e-6 * ExpectedSamples(limits, dark));
}

TEST(ExpectedSamples, NonFiniteSamplesAreBlack)
{
    std::vector<Radiance> tried(8, Grey(1.0));
    tried[3] = Grey(std::numeric_limits<double>::quiet_NaN());
    tried[5] = Grey(std::numeric_limits<double>::infinity());
    std::vector<Radiance> black(8, Grey(1.0));
    black[3] = black[5] = Grey(0.0);
    EXPECT_EQ(ExpectedSamples(Limits(8, 1024, 1e-3), tried), ExpectedSamples(Limits(8, 1024, 1e-3), black));
}

TEST(ProgressEstimator, ShareIsUnknownUntilAllBlocksAreProbed)
{
    ProgressEstimator map;
    EXPECT_FALSE(map.Share());
    EXPECT_FALSE(map.NextProbe());
    map.Plan({0, 0, 40, 20}, true);
    for (int block = 0; block < 6; block++)
    {
        EXPECT_FALSE(map.Share()) << block;
        const std::optional<ProgressEstimator::Probe> probe = map.NextProbe();
        ASSERT_TRUE(probe);
        map.SetWeight(probe->block, 1.0);
    }
    EXPECT_FALSE(map.NextProbe());
    EXPECT_EQ(map.Share(), 0.0);
}

TEST(ProgressEstimator, ProbesAPixelOfEachRenderedBlock)
{
    ProgressEstimator map;
    const Area part{100, 7, 37, 50};
    map.Plan(part, true);
    std::set<std::pair<std::uint32_t, std::uint32_t>> blocks;
    while (const std::optional<ProgressEstimator::Probe> probe = map.NextProbe())
    {
        EXPECT_TRUE(part.Has(probe->x, probe->y)) << probe->x << ", " << probe->y;
        blocks.insert({(probe->x - 100) / Settings::blockSide, (probe->y - 7) / Settings::blockSide});
    }
    EXPECT_EQ(blocks.size(), 3u * 4u);
}

TEST(ProgressEstimator, WeighsTheBlocks)
{
    ProgressEstimator map;
    map.Plan({0, 0, 64, 32}, true);
    TryAll(map, 32, 9.0);
    map.Finish({0, 0, 32, 32});
    EXPECT_NEAR(*map.Share(), 0.1, 1e-12);
    map.Finish({32, 0, 32, 16});
    EXPECT_NEAR(*map.Share(), 0.55, 1e-12);
    map.Finish({32, 16, 32, 16});
    EXPECT_NEAR(*map.Share(), 1.0, 1e-12);
}

TEST(ProgressEstimator, TilesOfAnySizeAddUpToOneAndNeverFall)
{
    for (const std::uint32_t size : {4u, 9u, 16u, 32u, 100u})
    {
        ProgressEstimator map;
        const Area part{5, 3, 83, 61};
        map.Plan(part, true);
        TryAll(map, 50, 123.456);
        double before = 0.0;
        for (std::uint32_t y = part.top; y < part.Bottom(); y += size)
            for (std::uint32_t x = part.left; x < part.Right(); x += size)
            {
                map.Finish({x, y, std::min(size, part.Right() - x), std::min(size, part.Bottom() - y)});
                EXPECT_GE(*map.Share(), before);
                before = *map.Share();
            }
        EXPECT_NEAR(before, 1.0, 1e-9);
    }
}

TEST(ProgressEstimator, CountsTilesFinishedBeforeTheProbes)
{
    ProgressEstimator map;
    map.Plan({0, 0, 64, 16}, true);
    map.Finish({32, 0, 32, 16});
    TryAll(map, 32, 3.0);
    EXPECT_NEAR(*map.Share(), 0.75, 1e-12);
}

TEST(ProgressEstimator, TilesMayExtendBeyondTheRenderedPart)
{
    ProgressEstimator map;
    map.Plan({8, 8, 20, 20}, false);
    map.Finish({0, 0, 64, 64});
    EXPECT_EQ(map.Share(), 1.0);
}

TEST(ProgressEstimator, CountsPixelsWithoutProbes)
{
    ProgressEstimator map;
    map.Plan({0, 0, 100, 10}, false);
    EXPECT_FALSE(map.NextProbe());
    EXPECT_EQ(map.Share(), 0.0);
    map.Finish({0, 0, 25, 10});
    EXPECT_NEAR(*map.Share(), 0.25, 1e-12);
}

TEST(ProgressEstimator, EmptyPictureIsFinished)
{
    ProgressEstimator map;
    map.Plan({0, 0, 32, 16}, true);
    TryAll(map, 0, 0.0);
    EXPECT_EQ(map.Share(), 1.0) << "all weights are 0";
}

} // namespace
} // namespace tilt_lens
