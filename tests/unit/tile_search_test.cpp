// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/tile_sampler.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tile_results.h"

namespace tilt_lens
{
namespace
{

void LineAlongRow(const SampleId& id, SampleResult& light)
{
    light = Grey(id.y == Settings::blockSide / 2 && SequencePointOf(id).pixelY < 1.0 / 16.0 ? 0.0 : 1.0);
}

// If three adjacent pixels miss it with eight samples, nothing shows it.
TEST(TileSamplerSearch, FindsAThinLineThatNeighboursMissedAtLowVariance)
{
    const std::uint32_t width = 32 * Settings::blockSide;
    const std::vector<Result> results = ResultsOf(Limits(8, 65536, 1e-6), {0, 0, width, Settings::blockSide}, width, Settings::blockSide,
                                                  LineAlongRow);
    for (std::uint32_t x = 0; x < width; x++)
        EXPECT_NEAR(results[Settings::blockSide / 2 * width + x].mean[0], 15.0 / 16.0, 0.02) << x;
    EXPECT_LE(results[0].samples, 256u);
}

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
    for (const Result& result : ResultsOf(Limits(8, 65536, variance), Settings::blockSide, Settings::blockSide, HiddenLamp(light)))
        most = std::max(most, result.samples);
    return most;
}

TEST(TileSamplerSearch, SearchForAHiddenLampGrowsWithItsLight)
{
    EXPECT_EQ(SamplesForHiddenLamp(0.02, 1e-3), 8u);
    EXPECT_GT(SamplesForHiddenLamp(0.2, 1e-3), 8u);
    EXPECT_LT(SamplesForHiddenLamp(0.2, 1e-3), 64u);
    // after sixteen misses an emitter counts as hidden
    EXPECT_EQ(SamplesForHiddenLamp(1.0, 1e-5), 64u);
    EXPECT_EQ(SamplesForHiddenLamp(100.0, 1e-5), 64u);
}

} // namespace
} // namespace tilt_lens
