// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/tile_sampler.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tile_results.h"

namespace tilt_lens
{
namespace
{

TEST(TileSamplerLimits, ConstantLightTakesTheMinimum)
{
    for (const std::uint32_t min : {2u, 8u, 64u})
        for (const Result& r : ResultsOf(Limits(min, 1024, 1e-4), 2 * Settings::blockSide, Settings::blockSide, Constant))
        {
            EXPECT_EQ(r.samples, min);
            EXPECT_EQ(r.mean[0], 0.7f);
            EXPECT_NEAR(r.variance, 0.0, 1e-30);
        }
}

TEST(TileSamplerLimits, VarianceZeroTakesTheMaximumEverywhere)
{
    for (const std::uint32_t max : {1u, 2u, 100u, 256u})
        for (const Result& r : ResultsOf(Limits(1, max, 0.0), 0, 0, Constant))
            EXPECT_EQ(r.samples, max);
}

TEST(TileSamplerLimits, SamplesStayWithinMinimumAndMaximum)
{
    const std::uint32_t cases[][2] = {{1, 1}, {1, 2}, {1, 3}, {3, 3}, {3, 100}, {7, 9}, {8, 1000}, {37, 37}, {100, 400}};
    for (const auto& c : cases)
        for (const Tracer& trace : {Tracer(Constant), Tracer(WhiteNoise), Tracer(Edge)})
            for (const double variance : {1e-9, 1e-4, 1.0})
                for (const Result& r : ResultsOf(Limits(c[0], c[1], variance), Settings::blockSide, Settings::blockSide, trace))
                {
                    ASSERT_GE(r.samples, c[0]) << "of " << c[0] << ", " << c[1];
                    ASSERT_LE(r.samples, c[1]) << "of " << c[0] << ", " << c[1];
                    ASSERT_TRUE(std::isfinite(r.mean[0]) && r.variance >= 0.0);
                }
    for (const Result& r : ResultsOf(Limits(3, 1000, 1e-9), Settings::blockSide, Settings::blockSide, WhiteNoise))
        EXPECT_EQ(r.samples, 1000u);
}

TEST(TileSamplerLimits, EverySampleIsTracedOnceAndCounted)
{
    const Area tile{2 * Settings::blockSide, Settings::blockSide, 2 * Settings::blockSide, Settings::blockSide};
    std::set<std::vector<std::uint32_t>> seen;
    std::uint64_t calls = 0, inside = 0;
    const auto trace = [&](const SampleId& id, SampleResult& light)
    {
        const SequencePoint s = SequencePointOf(id);
        calls++;
        inside += tile.Has(id.x, id.y);
        seen.insert({id.x, id.y, id.index});
        const SequencePoint same = PixelSampler(id.x, id.y, 0)(id.index);
        EXPECT_TRUE(same.lensU == s.lensU && same.lensV == s.lensV && same.pixelX == s.pixelX && same.pixelY == s.pixelY);
        Edge(id, light);
    };
    BlockCache store(Limits(6, 300, 1e-4), 8 * Settings::blockSide, 8 * Settings::blockSide, tile);
    TileSampler sampler(store);
    std::uint64_t counted = 0;
    double variance = 0.0;
    for (const Result& r : ResultsOf(sampler, tile, trace))
    {
        counted += r.samples;
        variance += r.variance;
    }
    EXPECT_EQ(inside, counted);
    EXPECT_EQ(seen.size(), calls) << "a sample was traced twice";
    EXPECT_EQ(calls - inside, 8u * (10 * Settings::blockSide * Settings::blockSide)) << "first samples of the blocks around the tile";
    EXPECT_EQ(sampler.Statistics().Samples(), counted);
    EXPECT_EQ(sampler.Statistics().Pixels(), 2u * Settings::blockSide * Settings::blockSide);
    EXPECT_EQ(sampler.Statistics().notFinite, 0u);
    EXPECT_DOUBLE_EQ(sampler.Statistics().variance, variance);
}

constexpr std::uint32_t kWidth = 45, kHeight = 37;

struct Way
{
    std::uint32_t min;
    Tracer trace;
    bool denoise;

    SamplingLimits Limited() const
    {
        SamplingLimits limits = Limits(min, 200, 1e-3);
        limits.denoise = denoise;
        return limits;
    }
    std::vector<Result> Whole() const { return ResultsOf(Limited(), {0, 0, kWidth, kHeight}, kWidth, kHeight, trace); }
};

std::vector<Way> Ways()
{
    std::vector<Way> ways;
    for (const std::uint32_t min : {1u, 6u})
        for (const Tracer& trace : {Tracer(Edge), Tracer(WhiteNoise)})
            for (const bool denoise : {false, true})
                ways.push_back({min, trace, denoise});
    return ways;
}

void ExpectPartOf(const std::vector<Result>& whole, const std::vector<Result>& part, const Area& tile)
{
    for (std::uint32_t y = 0; y < tile.height; y++)
        for (std::uint32_t x = 0; x < tile.width; x++)
            ASSERT_TRUE(part[y * tile.width + x] == whole[(tile.top + y) * kWidth + tile.left + x])
                << "tile at " << tile.left << ", " << tile.top << ", pixel " << x << ", " << y;
}

TEST(TileSamplerOrder, AnySubImageGivesTheSamePixels)
{
    const Area tiles[] = {{0, 0, 1, 1}, {44, 36, 1, 1}, {0, 0, 32, 32},  {32, 0, 13, 32}, {0, 32, 32, 5}, {32, 32, 13, 5},
                          {7, 9, 3, 2}, {7, 7, 2, 2},   {15, 0, 18, 37}, {8, 8, 8, 8},    {3, 20, 42, 1}};
    for (const Way& way : Ways())
        for (const Area& tile : tiles)
            ExpectPartOf(way.Whole(), ResultsOf(way.Limited(), tile, kWidth, kHeight, way.trace), tile);
}

TEST(TileSamplerOrder, AnyTilesInAnyOrderGiveTheSamePixelsAndFreeAllBlocks)
{
    for (const Way& way : Ways())
    {
        const auto whole = way.Whole();
        for (const std::uint32_t side : {5u, 8u, 20u, 32u})
        {
            std::vector<Area> tiles;
            for (std::uint32_t y = 0; y < kHeight; y += side)
                for (std::uint32_t x = 0; x < kWidth; x += side)
                    tiles.push_back({x, y, std::min(side, kWidth - x), std::min(side, kHeight - y)});
            std::shuffle(tiles.begin(), tiles.end(), std::mt19937(side));
            BlockCache store(way.Limited(), kWidth, kHeight, {0, 0, kWidth, kHeight});
            for (const Area& tile : tiles)
            {
                TileSampler sampler(store);
                ExpectPartOf(whole, ResultsOf(sampler, tile, way.trace), tile);
            }
            EXPECT_EQ(store.Size(), 0u) << "blocks that nobody needs any more";
        }
    }
}

TEST(TileSamplerOrder, ThreadsShareBlocksAndGiveTheSamePixels)
{
    for (const Way& way : Ways())
    {
        const auto whole = way.Whole();
        std::atomic<std::uint64_t> calls{0};
        const Tracer counted = [&](const SampleId& id, SampleResult& light)
        {
            calls++;
            TraceOne(way.trace, id, light);
        };
        BlockCache store(way.Limited(), kWidth, kHeight, {0, 0, kWidth, kHeight});
        std::atomic<std::uint32_t> row{0};
        std::atomic<std::uint64_t> samples{0};
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; i++)
            threads.emplace_back([&]
            {
                for (std::uint32_t y = row++; y < kHeight; y = row++)
                {
                    TileSampler sampler(store);
                    ExpectPartOf(whole, ResultsOf(sampler, {0, y, kWidth, 1}, counted), {0, y, kWidth, 1});
                    samples += sampler.Statistics().Samples();
                }
            });
        for (std::thread& thread : threads)
            thread.join();
        EXPECT_EQ(calls, samples) << "a sample was taken twice, or for nothing";
        EXPECT_EQ(store.Size(), 0u);
    }
}

TEST(TileSamplerOrder, AnInterruptedStepStartsAgain)
{
    for (const Way& way : Ways())
    {
        const std::vector<Result> whole = way.Whole();
        int samples = 0;
        for (const Result& pixel : whole)
            samples += pixel.samples;
        for (const int broken : {1, 100, samples * 9 / 10})
        {
            BlockCache store(way.Limited(), kWidth, kHeight, {0, 0, kWidth, kHeight});
            int calls = 0;
            const Tracer failing = [&](const SampleId& id, SampleResult& light)
            {
                if (++calls == broken)
                    throw std::runtime_error("cancelled");
                TraceOne(way.trace, id, light);
            };
            TileSampler sampler(store);
            const Area all{0, 0, kWidth, kHeight};
            EXPECT_THROW(sampler.Run(all, failing), std::runtime_error);
            ExpectPartOf(whole, ResultsOf(sampler, all, way.trace), all);
        }
    }
}

TEST(TileSamplerStop, EqualSamplesBesideAnEdgeAreNotTrusted)
{
    // the pixel beside the edge's sees 3 % of the lens
    const auto trace = [](const SampleId& id, SampleResult& light)
    {
        const SequencePoint s = SequencePointOf(id);
        const bool crossed = id.x % 8 == 4;
        light = Grey(s.lensU < (crossed ? 0.5 : 0.03) ? 1.0 : 0.0);
    };
    int stopped = 0;
    for (std::uint32_t block = 0; block < 25; block++)
    {
        const auto results = ResultsOf(Limits(8, 4096, 1e-4), block * Settings::blockSide, 0, trace);
        for (std::uint32_t y = 0; y < Settings::blockSide; y++)
            for (const std::uint32_t x : {3u, 5u})
                stopped += results[y * Settings::blockSide + x].samples <= 8;
    }
    EXPECT_EQ(stopped, 0);
}

TEST(TileSamplerReconstruction, RowsWithoutNoiseStayAsTheyAre)
{
    const auto trace = [](const SampleId& id, SampleResult& light) { light = Grey(id.y < 5 ? 0.5 : Noise(id, 1)); };
    SamplingLimits limits = Limits(8, 8, 1e-2);
    const std::vector<Result> plain = ResultsOf(limits, 8, 0, trace);
    limits.denoise = true;
    const std::vector<Result> rebuilt = ResultsOf(limits, 8, 0, trace);
    for (std::uint32_t i = 0; i < rebuilt.size(); i++)
    {
        if (i / Settings::blockSide == 4)  // pixels there may have missed the noise beside them
            continue;
        EXPECT_EQ(rebuilt[i] == plain[i], i / Settings::blockSide < 4) << i;
    }
}

TEST(TileSamplerStop, ErrorOfBrightPixelsIsRelative)
{
    const auto bright = [](const SampleId& id, SampleResult& light) { light = Grey(1000.0 * Noise(id, 1)); };
    for (const Result& r : ResultsOf(Limits(8, 1 << 20, 1e-3), 0, 0, bright))
    {
        EXPECT_GT(r.samples, 100u);
        EXPECT_LT(r.samples, 10000u);
    }
}

TEST(TileSamplerStop, EveryChannelCounts)
{
    for (std::size_t channel = 0; channel < 5; channel++)
    {
        const auto trace = [&](const SampleId& id, SampleResult& light)
        {
            light = Radiance{};
            light.radiance[channel] = Noise(id, 1);
        };
        for (const Result& r : ResultsOf(Limits(8, 4096, 1e-4), 0, 0, trace))
            ASSERT_GT(r.samples, 400u) << "channel " << channel;
    }
}

TEST(TileSamplerStop, NonFiniteSamplesAreBlackAndCounted)
{
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()})
    {
        const auto spoiled = [](const SampleId& id)
        { return id.x == 2 * Settings::blockSide + 2 && id.y == Settings::blockSide + 3 && id.index % 8 == 5; };
        const auto broken = [&](const SampleId& id, SampleResult& light)
        {
            Edge(id, light);
            if (spoiled(id))
                light.radiance[1] = bad;
        };
        const auto black = [&](const SampleId& id, SampleResult& light)
        {
            Edge(id, light);
            if (spoiled(id))
                light = Radiance{};
        };
        const Area tile{2 * Settings::blockSide, Settings::blockSide, Settings::blockSide, Settings::blockSide};
        const SamplingLimits limits = Limits(8, 1024, 1e-4);
        BlockCache brokenStore(limits, 8 * Settings::blockSide, 8 * Settings::blockSide, tile);
        BlockCache blackStore(limits, 8 * Settings::blockSide, 8 * Settings::blockSide, tile);
        TileSampler brokenTile(brokenStore), blackTile(blackStore);
        const auto results = ResultsOf(brokenTile, tile, broken);
        const auto expected = ResultsOf(blackTile, tile, black);
        for (std::size_t i = 0; i < results.size(); i++)
        {
            // sums round otherwise: samples after one that is not finite are added one by one
            EXPECT_EQ(results[i].samples, expected[i].samples) << bad;
            for (std::size_t c = 0; c < results[i].mean.size(); c++)
                EXPECT_NEAR(results[i].mean[c], expected[i].mean[c], 1e-6) << bad;
            EXPECT_NEAR(results[i].variance, expected[i].variance, 1e-5 * expected[i].variance) << bad;
        }
        EXPECT_EQ(brokenTile.Statistics().notFinite, results[3 * Settings::blockSide + 2].samples / 8) << bad;
        EXPECT_EQ(blackTile.Statistics().notFinite, 0u);
    }
}

TEST(SamplingStatistics, AddsUpAndHasQuantiles)
{
    SamplingStatistics statistics, other;
    EXPECT_EQ(statistics.Pixels(), 0u);
    EXPECT_EQ(statistics.Samples(), 0u);
    EXPECT_EQ(statistics.Most(), 0u);
    EXPECT_EQ(statistics.Quantile(0.99), 0u);
    EXPECT_EQ(statistics.StandardError(), 0.0);

    statistics.pixelsBySamples = {{8, 97}, {64, 1}};
    statistics.variance = 0.005;
    statistics.risk = 0.07;
    other.pixelsBySamples = {{64, 1}, {1024, 1}};
    other.variance = 0.005;
    other.risk = -0.03;
    other.notFinite = 3;
    statistics.Add(other);
    EXPECT_EQ(statistics.Pixels(), 100u);
    EXPECT_EQ(statistics.Samples(), 97u * 8 + 2 * 64 + 1024);
    EXPECT_EQ(statistics.Most(), 1024u);
    EXPECT_EQ(statistics.notFinite, 3u);
    EXPECT_EQ(statistics.Quantile(0.0), 8u);
    EXPECT_EQ(statistics.Quantile(0.97), 8u);
    EXPECT_EQ(statistics.Quantile(0.98), 64u);
    EXPECT_EQ(statistics.Quantile(0.99), 64u);
    EXPECT_EQ(statistics.Quantile(1.0), 1024u);
    EXPECT_DOUBLE_EQ(statistics.StandardError(), 0.02) << "noise and bias";
    statistics.risk = -0.04;
    EXPECT_DOUBLE_EQ(statistics.StandardError(), 0.01) << "noise";

    SamplingStatistics huge;
    huge.pixelsBySamples = {{1u << 31, 1ull << 20}};
    EXPECT_EQ(huge.Samples(), 1ull << 51);
}

/// Pixels at the lamp's rim mostly miss it.
TEST(TileSampler, RimsOfBlurredLampsAreNotTorn)
{
    constexpr double blur = 12.0, lamp = 3.0, brightness = 0.5, middle = 32.0;
    Lens lens;
    const Aperture disc = Aperture::Disc();
    const LensFootprint footprint(lens, disc, 64.0, 64.0);
    const auto trace = [&](const SampleId& id, SampleResult& result)
    {
        const SequencePoint s = SequencePointOf(id);
        const AperturePoint lensPoint = disc(s.lensU, s.lensV);
        const double x = id.x + s.pixelX + blur * lensPoint.a, y = id.y + s.pixelY + blur * lensPoint.b;
        result = Grey(std::hypot(x - middle, y - middle) < lamp ? brightness : 0.0);
        result.circle = {float(x), float(y), float(blur), 0.0f, 0.0f, float(blur), &footprint};
    };
    SamplingLimits limits = Limits(4, 64, 1e-3);
    limits.denoise = true;
    const Area all{0, 0, 64, 64};
    const std::vector<Result> results = ResultsOf(limits, all, 64, 64, trace);
    int rim = 0, black = 0;
    for (int y = 0; y < 64; y++)
        for (int x = 0; x < 64; x++)
        {
            const double distance = std::hypot(x + 0.5 - middle, y + 0.5 - middle);
            if (distance < blur - 1.0 || distance > blur + 1.0)
                continue;
            rim++;
            black += results[y * 64 + x].mean[0] < 0.1 * brightness * (lamp / blur) * (lamp / blur) * 0.5;
        }
    EXPECT_GT(rim, 100);
    EXPECT_LE(20 * black, rim) << black << " of " << rim;
}

} // namespace
} // namespace tilt_lens
