// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The sampling loop: limits, independence of order, when a pixel may stop, and the account of it.

#include "tilt_lens/cell_sampler.h"

#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "cell_results.h"

namespace tilt_lens
{
namespace
{

TEST(CellSamplerLimits, AConstantEndsAtTheMinimum)
{
    for (const std::uint32_t min : {2u, 8u, 64u})
        for (const Result& r : ResultsOf(Limits(min, 1024, 1e-4), 16, 8, Constant))
        {
            EXPECT_EQ(r.samples, min);
            EXPECT_NEAR(r.mean[0], 0.7, 1e-15);
            EXPECT_NEAR(r.variance, 0.0, 1e-17);
        }
}

TEST(CellSamplerLimits, VarianceZeroTakesTheMaximumEverywhere)
{
    for (const std::uint32_t max : {1u, 2u, 100u, 256u})
        for (const Result& r : ResultsOf(Limits(1, max, 0.0), 0, 0, Constant))
            EXPECT_EQ(r.samples, max);
}

TEST(CellSamplerLimits, MinimumAndMaximumAreKept)
{
    const std::uint32_t cases[][2] = {
        {1, 1}, {1, 2}, {1, 3}, {3, 3}, {3, 100}, {7, 9}, {8, 1000}, {37, 37}, {100, 400}};
    for (const auto& c : cases)
        for (const CellSampler::Tracer& trace : {CellSampler::Tracer(Constant),
                 CellSampler::Tracer(WhiteNoise), CellSampler::Tracer(Edge)})
            for (const double variance : {1e-9, 1e-4, 1.0})
                for (const Result& r : ResultsOf(Limits(c[0], c[1], variance), 8, 8, trace))
                {
                    ASSERT_GE(r.samples, c[0]) << "of " << c[0] << ", " << c[1];
                    ASSERT_LE(r.samples, c[1]) << "of " << c[0] << ", " << c[1];
                    ASSERT_TRUE(std::isfinite(r.mean[0]) && r.variance >= 0.0);
                }
    for (const Result& r : ResultsOf(Limits(3, 1000, 1e-9), 8, 8, WhiteNoise))
        EXPECT_EQ(r.samples, 1000u);
}

TEST(CellSamplerLimits, EverySampleIsTracedOnceAndCounted)
{
    std::set<std::vector<std::uint32_t>> seen;
    std::uint64_t calls = 0;
    const auto trace = [&](const SampleId& id, const Sample& s, Radiance& light)
    {
        calls++;
        seen.insert({id.x, id.y, id.index});
        const Sample same = PixelSampler(id.x, id.y, 0)(id.index);
        EXPECT_TRUE(same.lensU == s.lensU && same.lensV == s.lensV && same.pixelX == s.pixelX &&
                    same.pixelY == s.pixelY);
        Edge(id, s, light);
    };
    std::uint64_t counted = 0;
    for (const Result& r : ResultsOf(Limits(6, 300, 1e-4), 16, 8, trace))
        counted += r.samples;
    EXPECT_EQ(calls, counted);
    EXPECT_EQ(seen.size(), counted);
}

TEST(CellSamplerOrder, CellsDoNotDependOnWhatRanBefore)
{
    const SamplingLimits limits = Limits(8, 512, 1e-4);
    CellSampler used(limits);
    for (const CellSampler::Tracer& trace :
        {CellSampler::Tracer(Edge), CellSampler::Tracer(WhiteNoise)})
        for (const std::uint32_t left : {48u, 0u, 16u, 48u})
        {
            ResultsOf(used, 8, 24, 3, 5, Constant);
            EXPECT_TRUE(
                ResultsOf(used, left, 8, kSize, kSize, trace) == ResultsOf(limits, left, 8, trace))
                << left;
        }
}

TEST(CellSamplerOrder, CellsAtThePicturesBorderAreSmaller)
{
    for (const std::uint32_t width : {1u, 3u, 8u})
        for (const std::uint32_t height : {1u, 5u})
        {
            CellSampler sampler(Limits(8, 64, 0.0));
            const auto small = ResultsOf(sampler, 16, 8, width, height, Edge);
            const auto whole = ResultsOf(Limits(8, 64, 0.0), 16, 8, Edge);
            for (std::uint32_t y = 0; y < height; y++)
                for (std::uint32_t x = 0; x < width; x++)
                    EXPECT_TRUE(small[y * width + x].mean == whole[y * kSize + x].mean);
        }
}

TEST(CellSamplerStop, EqualSamplesBesideAnEdgeAreNoCertainty)
{
    // Pixels left and right of the one that the edge crosses see it through 3 % of the lens.
    const auto trace = [](const SampleId& id, const Sample& s, Radiance& light)
    {
        const bool crossed = id.x % 8 == 4;
        light = Grey(s.lensU < (crossed ? 0.5 : 0.03) ? 1.0 : 0.0);
    };
    int stopped = 0;
    for (std::uint32_t cell = 0; cell < 50; cell++)
    {
        const auto results = ResultsOf(Limits(8, 4096, 1e-4), cell * kSize, 0, trace);
        for (std::uint32_t y = 0; y < kSize; y++)
            for (const std::uint32_t x : {3u, 5u})
                stopped += results[y * kSize + x].samples <= 8;
    }
    EXPECT_EQ(stopped, 0);
}

TEST(CellSamplerStop, BrightPixelsAreJudgedRelativeToTheirBrightness)
{
    const auto bright = [](const SampleId& id, const Sample&, Radiance& light)
    { light = Grey(1000.0 * Noise(id, 1)); };
    for (const Result& r : ResultsOf(Limits(8, 1 << 20, 1e-3), 0, 0, bright))
    {
        EXPECT_GT(r.samples, 100u);
        EXPECT_LT(r.samples, 10000u);
    }
}

TEST(CellSamplerStop, EveryChannelCounts)
{
    for (std::size_t channel = 0; channel < 5; channel++)
    {
        const auto trace = [&](const SampleId& id, const Sample&, Radiance& light)
        {
            light = {};
            light[channel] = Noise(id, 1);
        };
        for (const Result& r : ResultsOf(Limits(8, 4096, 1e-4), 0, 0, trace))
            ASSERT_GT(r.samples, 400u) << "channel " << channel;
    }
}

TEST(CellSamplerStop, OneBadSampleLeavesTheOtherPixelsAlone)
{
    for (const double bad :
        {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    {
        const auto trace = [&](const SampleId& id, const Sample& s, Radiance& light)
        {
            Edge(id, s, light);
            if (id.x == 18 && id.y == 11 && id.index == 5)
                light[1] = bad;
        };
        const auto results = ResultsOf(Limits(8, 1024, 1e-4), 16, 8, trace);
        for (std::uint32_t i = 0; i < results.size(); i++)
        {
            const bool others = i != 3 * kSize + 2;
            for (const double value : results[i].mean)
                EXPECT_TRUE(!others || std::isfinite(value)) << "pixel " << i;
        }
    }
}

TEST(SamplingAccount, AddsUpAndKnowsItsQuantiles)
{
    SamplingAccount account, other;
    EXPECT_EQ(account.Pixels(), 0u);
    EXPECT_EQ(account.Samples(), 0u);
    EXPECT_EQ(account.Most(), 0u);
    EXPECT_EQ(account.Quantile(0.99), 0u);
    EXPECT_EQ(account.StandardError(), 0.0);

    account.pixelsBySamples = {{8, 97}, {64, 1}};
    account.variance = 0.005;
    other.pixelsBySamples = {{64, 1}, {1024, 1}};
    other.variance = 0.005;
    account.Add(other);
    EXPECT_EQ(account.Pixels(), 100u);
    EXPECT_EQ(account.Samples(), 97u * 8 + 2 * 64 + 1024);
    EXPECT_EQ(account.Most(), 1024u);
    EXPECT_EQ(account.Quantile(0.0), 8u);
    EXPECT_EQ(account.Quantile(0.97), 8u);
    EXPECT_EQ(account.Quantile(0.98), 64u);
    EXPECT_EQ(account.Quantile(0.99), 64u);
    EXPECT_EQ(account.Quantile(1.0), 1024u);
    EXPECT_DOUBLE_EQ(account.StandardError(), 0.01);

    SamplingAccount huge;
    huge.pixelsBySamples = {{1u << 31, 1ull << 20}};
    EXPECT_EQ(huge.Samples(), 1ull << 51);
}

} // namespace
} // namespace tilt_lens
