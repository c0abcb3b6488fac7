// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Undetected error: a pixel's search for features that its neighbours hit, and for emitters at which it aims samples.

#include "tilt_lens/sampling/tile_sampler.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tile_results.h"

namespace tilt_lens
{
namespace
{

/// Black and white noise in every fourth column, grey elsewhere.
void NoisyColumns(const SampleId& id, SampleResult& light)
{
    light = Grey(id.x % 4 == 0 ? (Noise(id, 1) > 0.5 ? 1.0 : 0.0) : 0.5);
}

std::uint32_t SamplesBesideNoise(double variance)
{
    std::uint32_t most = 0;
    const std::vector<Result> results = ResultsOf(Limits(8, 65536, variance), 2 * settings.blockSide, settings.blockSide, NoisyColumns);
    for (std::uint32_t i = 0; i < results.size(); i++)
        if (i % 4 == 1 || i % 4 == 3)
            most = std::max(most, results[i].samples);
    return most;
}

// No filter removes undetected error: it stays in the variance of the pixels beside the noise.
TEST(TileSamplerUndetectedError, StaysAfterTheReconstruction)
{
    SamplingLimits limits = Limits(8, 8, 1e-4);
    const Area area{0, 0, settings.blockSide, settings.blockSide};
    BlockCache cache(limits, area.width, area.height, area);
    cache.Finish({{0, 0}}, NoisyColumns);
    const std::shared_ptr<const Block> sampled = cache.At({0, 0});
    limits.denoise = true;
    const std::vector<Result> results = ResultsOf(limits, area, area.width, area.height, NoisyColumns);
    double undetected = 0.0, all = 0.0;
    for (std::uint32_t i = 0; i < results.size(); i++)
    {
        const PixelResult& before = sampled->ResultOf(i % area.width, i / area.width);
        EXPECT_GE(results[i].variance, before.undetected) << i;
        EXPECT_LE(results[i].variance, before.variance) << i;
        undetected += i % 2 ? before.undetected : 0.0;
        all += i % 2 ? results[i].variance : 0.0;
    }
    EXPECT_GT(undetected, 0.5 * all);
}

// A feature that deviates from the mean by 1/2 and covers a fraction p is missed by n samples. The expected square
// error is at most (2 / n / e)^2 / 4, so n = 0.37 / sqrt(V) suffice: the round after that is the last, and the first
// is not.
TEST(TileSamplerUndetectedError, PixelsBesideNoiseStopOnceTheyWouldHaveHitIt)
{
    for (const double variance : {1e-4, 1e-5, 1e-6})
    {
        const double enough = 0.5 * 2.0 / std::exp(1.0) / std::sqrt(variance);
        EXPECT_GT(SamplesBesideNoise(variance), 0.5 * enough) << variance;
        EXPECT_LT(SamplesBesideNoise(variance), 4.0 * enough) << variance;
    }
}

/// One sample in twelve hits something bright.
void Seldom(const SampleId& id, SampleResult& light)
{
    light = Grey(Noise(id, 1) < 1.0 / 12.0 ? 1.0 : 0.5);
}

/// Number of pixels whose samples all missed it.
std::uint32_t MissedBy(bool denoise)
{
    SamplingLimits limits = Limits(8, 65536, 3e-4);
    limits.denoise = denoise;
    std::uint32_t missed = 0;
    for (std::uint32_t left = 0; left < 5 * settings.blockSide; left += settings.blockSide)
    {
        const std::vector<Result> results = ResultsOf(limits, left, settings.blockSide, Seldom);
        for (std::uint32_t i = 0; i < results.size(); i++)
        {
            bool met = false;
            for (SampleId id{left + i % settings.blockSide, settings.blockSide + i / settings.blockSide, 0};
                 id.index < results[i].samples; id.index++)
                met = met || Noise(id, 1) < 1.0 / 12.0;
            missed += !met;
        }
    }
    return missed;
}

// The reconstruction averages noise that a pixel shows; features that it missed must still be searched for.
TEST(TileSamplerUndetectedError, IsNotLeftToTheReconstruction)
{
    EXPECT_LE(MissedBy(true), MissedBy(false));  // fewer with longer first rounds
}

/// A black line that covers a sixteenth of each pixel of a row.
void LineAlongRow(const SampleId& id, SampleResult& light)
{
    light = Grey(id.y == settings.blockSide / 2 && SequencePointOf(id).pixelY < 1.0 / 16.0 ? 0.0 : 1.0);
}

// Three adjacent pixels may all have missed it with eight samples; then their samples show no difference.
TEST(TileSamplerUndetectedError, FindsAThinLineThatNeighboursMissedAtLowVariance)
{
    const std::uint32_t width = 32 * settings.blockSide;
    const std::vector<Result> results =
        ResultsOf(Limits(8, 65536, 1e-6), {0, 0, width, settings.blockSide}, width, settings.blockSide, LineAlongRow);
    for (std::uint32_t x = 0; x < width; x++)
        EXPECT_NEAR(results[settings.blockSide / 2 * width + x].mean[0], 15.0 / 16.0, 0.02) << x;
    EXPECT_LE(results[0].samples, 256u);  // but not without limit, far from the line
}

/// Every fourth sample is aimed at an emitter of this expected emission and hits an object in front of it.
Tracer HiddenLamp(double light)
{
    return [light](const SampleId& id, SampleResult& traced)
    {
        traced = Grey(0.0);
        if (id.index % 4 == 0)
            traced.expectedEmission = light;
    };
}

std::uint32_t SamplesForHiddenLamp(double light, double variance)
{
    std::uint32_t most = 0;
    for (const Result& result : ResultsOf(Limits(8, 65536, variance), settings.blockSide, settings.blockSide, HiddenLamp(light)))
        most = std::max(most, result.samples);
    return most;
}

TEST(TileSamplerUndetectedError, SearchForAHiddenLampGrowsWithItsLight)
{
    EXPECT_EQ(SamplesForHiddenLamp(0.02, 1e-3), 8u);
    EXPECT_GT(SamplesForHiddenLamp(0.2, 1e-3), 8u);
    EXPECT_LT(SamplesForHiddenLamp(0.2, 1e-3), 64u);
    // after sixteen misses any emitter is taken for hidden
    EXPECT_EQ(SamplesForHiddenLamp(1.0, 1e-5), 64u);
    EXPECT_EQ(SamplesForHiddenLamp(100.0, 1e-5), 64u);
}

} // namespace
} // namespace tilt_lens
