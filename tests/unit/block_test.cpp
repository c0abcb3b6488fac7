// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/block.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tile_results.h"
#include "tilt_lens/stop_rule/sent_samples.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kSide = Settings::blockSide;
constexpr std::uint32_t kMost = 8;  // samples of a pixel that serve others

const LensFootprint& Footprint()
{
    static const LensFootprint lens(Lens(), Aperture::Disc(), 2.0 * kSide, kSide);
    return lens;
}

SampleResult Blurred(const SampleId& id, double grey, float radius)
{
    SampleResult result;
    result = Grey(grey);
    result.circle = {id.x + 0.5f, id.y + 0.5f, radius, 0.0f, 0.0f, radius, &Footprint()};
    return result;
}

SamplingLimits Denoised(double variance)
{
    SamplingLimits limits = Limits(4, 256, variance);
    limits.denoise = true;
    return limits;
}

/// Light kept by plain means, with one bright sample in 64.
double LightKept(float blur)
{
    const Tracer trace([blur](const SampleId& id, SampleResult& result)
    { result = Blurred(id, Noise(id, 1) < 1.0 / 64.0 ? 1.0 : 0.0, blur); });
    const std::uint32_t side = 8 * kSide;
    double light = 0.0;
    for (const Result& result : ResultsOf(Limits(4, 256, 1e-3), {0, 0, side, side}, side, side, trace))
        light += result.mean[0];
    return 64.0 * light / Square(side);
}

TEST(Block, BlurredPixelsDecideTogetherAndLoseNoLight)
{
    EXPECT_LT(LightKept(0.0f), 0.6);
    EXPECT_GT(LightKept(6.0f), 0.8);
}

/// Only the left block's later samples hit the lamp.
TEST(Block, UsesLaterRoundsOfItsNeighbours)
{
    const std::uint32_t seen = kSide + 4;
    const Tracer trace([&](const SampleId& id, SampleResult& result)
    {
        const bool lamp = id.x >= kSide - 4 && id.x < seen && id.index >= 8 && Noise(id, 2) < 0.125;
        result = Blurred(id, lamp ? 4.0 : id.x < kSide ? Noise(id, 1) : 0.25, 4.0f);
    });
    const std::vector<Result> results = ResultsOf(Denoised(1e-3), {0, 0, 2 * kSide, kSide}, 2 * kSide, kSide, trace);
    double mean = 0.0;
    for (std::uint32_t y = 0; y < kSide; y++)
    {
        EXPECT_GT(results[y * 2 * kSide + kSide].samples, 8u) << "beside the border, row " << y;
        EXPECT_EQ(results[y * 2 * kSide + 2 * kSide - 1].samples, 4u) << "beyond the circles, row " << y;
        mean += results[y * 2 * kSide + kSide].mean[0] / kSide;
    }
    EXPECT_GT(mean, 0.4) << "a part of the lamp's light is there";
}

TEST(Block, TakesEachStepOnce)
{
    const Area area{0, 0, kSide, kSide};
    const SamplingLimits limits = Denoised(1e-3);
    Block block(area, kSide, kSide, Settings());
    Block::Neighbours neighbours{};
    neighbours[4] = &block;
    for (int step = 0; step < Block::kSteps; step++)
    {
        EXPECT_EQ(block.StepsTaken(), step);
        EXPECT_FALSE(block.TakeStep(step + 1, neighbours, limits, WhiteNoise));
        EXPECT_TRUE(block.TakeStep(step, neighbours, limits, WhiteNoise));
        EXPECT_FALSE(block.TakeStep(step, neighbours, limits, WhiteNoise));
    }
    EXPECT_EQ(block.StepsTaken(), Block::kSteps);
}

TEST(SentSamples, EachPixelHasTheSameTotalWeight)
{
    const Area area{0, 0, kSide, kSide};
    SentSamples few(area, 2 * kSide, kSide, kMost), many(area, 2 * kSide, kSide, kMost);
    std::vector<std::uint32_t> samples(kSide * kSide, 4), more = samples;
    more[0] = 16;
    for (std::uint32_t pixel = 0; pixel < kSide * kSide; pixel++)
        for (std::uint32_t index = 0; index < more[pixel]; index++)
        {
            const SampleId id{pixel % kSide, pixel / kSide, index};
            const SampleResult result = Blurred(id, pixel == 0 ? 1.0 : 0.25, 3.0f);
            many.Add(id, result);
            if (index < samples[pixel])
                few.Add(id, result);
        }
    const auto equal = few.Spread(samples, 4), unequal = many.Spread(more, 4);
    for (const SpreadSums::Sum sum : {SpreadSums::kRed, SpreadSums::kShare, SpreadSums::kSquares})
        for (int x = 0; x < 4; x++)
            EXPECT_NEAR(*unequal->From(sum, x, 1), *equal->From(sum, x, 1), 1e-4) << sum << ", " << x;
    EXPECT_LT(*unequal->From(SpreadSums::kSquaredShares, 1, 1), *equal->From(SpreadSums::kSquaredShares, 1, 1));
    EXPECT_NEAR(unequal->OwnShare(0, 0), equal->OwnShare(0, 0), 1e-4);
    EXPECT_NEAR(unequal->OwnWeight(0, 0), 4.0f, 1e-5);
}

TEST(SentSamples, SharpSamplesServeTheirOwnPixelAloneAndExcessSamplesNone)
{
    const Area area{0, 0, kSide, kSide};
    SentSamples sent(area, 2 * kSide, kSide, kMost);
    const std::vector<std::uint32_t> samples(kSide * kSide, 2 * kMost);
    for (std::uint32_t pixel = 0; pixel < kSide * kSide; pixel++)
    {
        const SampleId first{pixel % kSide, pixel / kSide, 0};
        const bool blurs = first.x == 3 && first.y == 3;
        for (std::uint32_t index = blurs ? 1 : 0; index < kMost; index++)
            sent.Add({first.x, first.y, index}, Blurred(first, 1.0, 0.1f));
    }
    sent.Add({3, 3, kMost}, Blurred({3, 3, 0}, 1.0, 3.0f));
    EXPECT_EQ(sent.Spread(samples, 4), nullptr);
    sent.Add({3, 3, 0}, Blurred({3, 3, 0}, 1.0, 3.0f));
    const auto spread = sent.Spread(samples, 4);
    ASSERT_NE(spread, nullptr);
    EXPECT_NEAR(spread->OwnWeight(3, 3), 4.0f, 1e-5);
    EXPECT_NEAR(spread->OwnShare(4, 3), 4.0f, 1e-5);
    const float share = *spread->From(SpreadSums::kShare, 4, 3) - 4.0f;
    EXPECT_GT(share, 0.0f);
    EXPECT_LT(share, 4.0f / kMost);
    EXPECT_NEAR(*spread->From(SpreadSums::kSquaredShares, 4, 3), 16.0f / kMost + share * share, 1e-5);
    EXPECT_EQ(*spread->From(SpreadSums::kRed, 9, 9), 4.0f);
}

/// Half of the samples of the left pixels are aimed at something small.
TEST(SentSamples, WeightsOfAimedSamplesLeaveEvenLightEven)
{
    SentSamples sent({0, 0, kSide, kSide}, 2 * kSide, kSide, kMost);
    for (std::uint32_t pixel = 0; pixel < kSide * kSide; pixel++)
        for (std::uint32_t index = 0; index < 4; index++)
        {
            const SampleId id{pixel % kSide, pixel / kSide, index};
            const bool aims = id.x < 8, aimed = aims && index % 2 == 0;
            const float weight = !aims ? 1.0f : aimed ? 0.1f : 1.9f;
            SampleResult result = Blurred(id, 0.5 * weight, aimed ? 2.0f : 6.0f);
            result.circle.weight = weight;
            sent.Add(id, result);
        }
    const auto spread = sent.Spread(std::vector<std::uint32_t>(kSide * kSide, 4), 4);
    for (int y = 0; y < int(kSide); y++)
        for (int x = 0; x < int(kSide); x++)
            EXPECT_NEAR(*spread->From(SpreadSums::kRed, x, y) / *spread->From(SpreadSums::kShare, x, y), 0.5, 1e-4) << x << ", " << y;
}

TEST(SentSamples, ServeTheirOwnPixelAsOthers)
{
    SentSamples sent({0, 0, kSide, kSide}, 2 * kSide, kSide, kMost);
    for (const std::uint32_t x : {4u, 12u})
    {
        SampleResult result = Blurred({x, 8, 0}, 1.0, 2.0f);
        result.circle.weight = x == 4 ? 0.1f : 1.0f;
        sent.Add({x, 8, 0}, result);
    }
    const auto spread = sent.Spread(std::vector<std::uint32_t>(kSide * kSide, 1), 1);
    for (const int x : {4, 12})
        EXPECT_FLOAT_EQ(*spread->From(SpreadSums::kRed, x, 8), spread->OwnShare(x, 8));
}

TEST(SentSamples, AimsBesideTheLensAreNotKeptByTheirPixel)
{
    SentSamples with({0, 0, kSide, kSide}, 2 * kSide, kSide, kMost);
    SampleResult beside;
    beside = Grey(0.0);
    beside.circle.weight = 0.0f;
    for (const std::uint32_t index : {0u, 1u})
        with.Add({5, 5, index}, index == 0 ? Blurred({5, 5, 0}, 1.0, 6.0f) : beside);
    const auto spread = with.Spread(std::vector<std::uint32_t>(kSide * kSide, 2), 2);
    EXPECT_LT(spread->OwnShare(5, 5), 0.1f * spread->OwnWeight(5, 5));
}

} // namespace
} // namespace tilt_lens
