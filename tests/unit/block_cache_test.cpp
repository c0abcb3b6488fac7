// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/block_cache.h"

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tile_results.h"
#include "together.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kTile = 32, kTiles = 4, kWidth = kTile * kTiles;

SamplingLimits DenoisedLimits()
{
    SamplingLimits limits = Limits(4, 64, 1e-3);
    limits.denoise = true;
    return limits;
}

void SlowNoise(const SampleId& id, SampleResult& result)
{
    if (id.index == 0 && PixelHash(id.x, id.y, 0, 9) % 64 == 0)
        std::this_thread::sleep_for(std::chrono::microseconds(PixelHash(id.x, id.y, 0, 10) % 500));
    WhiteNoise(id, result);
}

std::vector<Radiance> PictureOf(int threads, const Tracer& trace)
{
    BlockCache cache(DenoisedLimits(), kWidth, kWidth, {0, 0, kWidth, kWidth});
    std::vector<Radiance> picture(kWidth * kWidth);
    std::atomic<std::uint32_t> next{0};
    const auto work = [&]
    {
        for (std::uint32_t i = next++; i < kTiles * kTiles; i = next++)
        {
            const Area tile{i % kTiles * kTile, i / kTiles * kTile, kTile, kTile};
            TileSampler sampler(cache);
            sampler.Run(tile, trace);
            for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
                for (std::uint32_t x = tile.left; x < tile.Right(); x++)
                    picture[y * kWidth + x] = sampler.Mean(x, y);
        }
    };
    RunTogether(threads, work);
    EXPECT_EQ(cache.At({1, 1}), nullptr) << "a block that was released is not made again";
    EXPECT_EQ(cache.Size(), 0u);
    return picture;
}

TEST(BlockCache, TakesEachSampleOnceWithManyThreads)
{
    std::vector<std::atomic<std::uint32_t>> traced(kWidth * kWidth);
    const Tracer counting([&](const SampleId& id, SampleResult& result)
    {
        EXPECT_EQ(traced[id.y * kWidth + id.x]++, id.index);
        SlowNoise(id, result);
    });
    const std::vector<Radiance> alone = PictureOf(1, SlowNoise);
    EXPECT_EQ(PictureOf(5, counting), alone);
}

TEST(BlockCache, HoldsFewRowsOfAWidePicture)
{
    constexpr std::uint32_t width = 7680, rows = 12, columns = width / Settings::blockSide, tiles = width / kTile;
    constexpr std::size_t window = (Settings::windowRows + Settings::dependencyRadius) * columns;
    BlockCache cache(DenoisedLimits(), width, rows * Settings::blockSide, {0, 0, width, rows * Settings::blockSide});
    std::atomic<std::uint32_t> next{0};
    std::atomic<bool> held{false};
    std::atomic<std::size_t> most{0};
    const auto count = [&]
    {
        const std::size_t size = cache.Size();
        for (std::size_t before = most; before < size && !most.compare_exchange_weak(before, size);)
        {
        }
        return size;
    };
    const Tracer trace([&](const SampleRun& run, SampleResult* results)
    {
        if (!held.exchange(true))
        {
            for (int i = 0; i < 60000 && count() < window; i++)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        for (std::uint32_t i = 0; i < run.count; i++)
            results[i] = Grey(0.5 * (run.first.x / 100 % 2));
    });
    const auto work = [&]
    {
        for (std::uint32_t i = next++; i < tiles * rows / 2; i = next++)
        {
            TileSampler(cache).Run({i % tiles * kTile, i / tiles * kTile, kTile, kTile}, trace);
            count();
        }
    };
    std::future<void> first = std::async(std::launch::async, work), second = std::async(std::launch::async, work);
    first.get(), second.get();
    EXPECT_GE(most, window);
    EXPECT_LE(most, window + Settings::dependencyRadius * columns);
    EXPECT_EQ(cache.Size(), 0u);
}

/// One thread waits; the other must finish all first rounds but one.
TEST(BlockCache, ThreadsWorkAheadInsteadOfWaiting)
{
    const std::uint32_t others = 2 * Settings::blockSide;
    std::atomic<bool> held{false};
    std::atomic<std::uint32_t> reached{0};
    const Tracer trace([&](const SampleId& id, SampleResult& result)
    {
        if (id.x == 0 && id.y == 0 && id.index == 0 && !held.exchange(true))
        {
            for (int i = 0; i < 20000 && reached < others; i++)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        for (std::uint32_t before = reached; before < id.y && !reached.compare_exchange_weak(before, id.y);)
        {
        }
        WhiteNoise(id, result);
    });
    BlockCache cache(DenoisedLimits(), Settings::blockSide, 8 * Settings::blockSide, {0, 0, Settings::blockSide, 8 * Settings::blockSide});
    const auto run = [&](std::uint32_t top) { TileSampler(cache).Run({0, top, Settings::blockSide, Settings::blockSide}, trace); };
    std::future<void> first = std::async(std::launch::async, run, 0u);
    while (!held)
        std::this_thread::yield();
    run(Settings::blockSide);
    first.get();
    EXPECT_GE(reached, others);
}

TEST(BlockCache, AnotherThreadRetakesAnInterruptedStep)
{
    std::atomic<bool> thrown{false};
    const Tracer trace([&](const SampleId& id, SampleResult& result)
    {
        if (id.x == 5 && id.y == 5 && !thrown.exchange(true))
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            throw std::runtime_error("stop");
        }
        WhiteNoise(id, result);
    });
    BlockCache cache(DenoisedLimits(), 2 * Settings::blockSide, Settings::blockSide, {0, 0, 2 * Settings::blockSide, Settings::blockSide});
    const auto run = [&](std::uint32_t left) { TileSampler(cache).Run({left, 0, Settings::blockSide, Settings::blockSide}, trace); };
    std::future<void> first = std::async(std::launch::async, run, 0u), second = std::async(std::launch::async, run, Settings::blockSide);
    int broken = 0;
    for (std::future<void>* one : {&first, &second})
        try
        {
            one->get();
        }
        catch (const std::runtime_error&)
        {
            broken++;
        }
    EXPECT_EQ(broken, 1);
}

TEST(BlockCache, MemoryOfABlock)
{
    const double pixels = Settings::blockSide * Settings::blockSide;
    const double seen = (sizeof(SpreadSums) + sizeof(BlockStatistics)) / pixels;
    EXPECT_LE(sizeof(PixelEstimate) + seen, 300.0) << "after the first step";
    EXPECT_LE(sizeof(PixelEstimate) + sizeof(PixelResult) + 2.0 * seen, 460.0) << "after the second step";
    EXPECT_LE(sizeof(PixelResult) + seen, 170.0) << "after the last step";
}

} // namespace
} // namespace tilt_lens
