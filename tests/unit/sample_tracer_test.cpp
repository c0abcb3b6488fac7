// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/sample_tracer.h"

#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "random_cameras.h"
#include "tile_results.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kWidth = 64, kHeight = 48;

struct Wall : RayTracer
{
    double distance = 20.0;
    std::vector<RayRange> asked;

    void Trace(const CameraRays& rays, const RayRange& range, Hit* hits) override
    {
        asked.push_back(range);
        for (std::uint32_t i = 0; i < range.count; i++)
        {
            EXPECT_NE(rays.samples.weight[range.place + i], 0.0) << "a blocked ray";
            hits[i] = {{1.0, 2.0, 3.0, 0.5, 0.25}, distance / rays.direction[2][range.place + i]};
        }
    }
};

Statement StatementWith(const Character& character = {})
{
    Statement statement;
    statement.focalPoint = {0.0, 0.0, 10.0};
    statement.aperture = 2.0;
    statement.character = character;
    return statement;
}

SampledCamera CameraWith(const Statement& statement, bool denoise = true, bool deflects = false, const std::vector<Emitter>& lamps = {})
{
    const SolvedLens lens = Solve({{}, {0.0, 0.0, 1.0}, {4.0 / 3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, statement);
    SamplingLimits limits = Limits(0, 64, 1e-3);
    limits.denoise = denoise;
    return SampledCamera(std::make_shared<const LensCamera>(Shared(lens), Aperture::Disc(), statement.character, deflects), limits,
                         {kWidth, kHeight, lamps}, statement.sampleSeed);
}

Statement StatementOfGlass()
{
    Statement statement;
    statement.prescription = std::make_shared<const Prescription>(ReadPrescription(kDoubleGauss));
    statement.sceneUnit = 1.0;
    statement.focalPoint = {0.0, 0.0, 3000.0};
    return statement;
}

std::vector<SampleResult> FirstGroup(const SampledCamera& camera, Wall& wall, std::uint32_t x, std::uint32_t y, bool aims = true)
{
    SampleTracer tracer(camera, wall, aims);
    std::vector<SampleResult> results(Settings::cameraRaysOfBatch);
    tracer.Trace({{x, y, 0}, Settings::cameraRaysOfBatch}, results.data());
    return results;
}

TEST(SampleTracer, AsksOnceForARunOfPlainSamples)
{
    Wall wall;
    const SampledCamera camera = CameraWith(StatementWith());
    for (const SampleResult& result : FirstGroup(camera, wall, 20, 30))
    {
        EXPECT_EQ(result.radiance, (Radiance{1.0, 2.0, 3.0, 0.5, 0.25}));
        EXPECT_EQ(result.expectedEmission, 0.0);
    }
    ASSERT_EQ(wall.asked.size(), 1u);
    EXPECT_EQ(wall.asked[0].count, Settings::cameraRaysOfBatch);
    EXPECT_EQ(wall.asked[0].index, 0u);
    EXPECT_TRUE(wall.asked[0].distances);
}

/// Lens 1 wide, focus 10, frame 4/3 wide at 1.
TEST(SampleTracer, TurnsTheDistanceIntoACircle)
{
    Wall wall;
    const SampledCamera camera = CameraWith(StatementWith());
    const double radius = 0.5 * (1.0 / 10.0 - 1.0 / 20.0) * kWidth / (4.0 / 3.0);
    for (const SampleResult& result : FirstGroup(camera, wall, 20, 30))
    {
        ASSERT_EQ(result.circle.lens, &camera.footprint);
        EXPECT_NEAR(std::fabs(result.circle.xa), radius, 1e-4 * radius);
        EXPECT_NEAR(std::fabs(result.circle.yb), radius, 1e-4 * radius);
    }
    wall.distance = 10.0;
    for (const SampleResult& result : FirstGroup(camera, wall, 20, 30))
        EXPECT_NEAR(result.circle.xa, 0.0, 1e-5) << "in focus";
}

TEST(SampleTracer, WeighsSamplesAimedAtEmitters)
{
    Wall wall;
    const SampledCamera camera = CameraWith(StatementWith(), true, false, {{{0.0, 0.0, 40.0}, 0.03, 40.0}});
    int aimed = 0;
    double mean = 0.0;
    for (const SampleResult& result : FirstGroup(camera, wall, 32, 24))
    {
        aimed += result.expectedEmission > 0.0;
        mean += result.radiance[0] / Settings::cameraRaysOfBatch;
        EXPECT_EQ(result.radiance[2], 3.0 * result.radiance[0]);
    }
    EXPECT_EQ(aimed, int(Settings::cameraRaysOfBatch / 2));
    EXPECT_NE(mean, 1.0);
    for (const SampleResult& result : FirstGroup(camera, wall, 32, 24, false))
        EXPECT_EQ(result.radiance[0], 1.0) << "plain samples alone";
}

TEST(SampleTracer, DoesNotAskForBlockedRays)
{
    Statement statement = StatementOfGlass();
    statement.shiftUp = 12.0;
    const SampledCamera camera = CameraWith(statement);
    Wall wall;
    SampleTracer tracer(camera, wall);
    int blocked = 0;
    for (std::uint32_t y = 0; y < kHeight; y++)
    {
        SampleResult results[Settings::cameraRaysOfBatch];
        tracer.Trace({{0, y, 0}, Settings::cameraRaysOfBatch}, results);
        for (const SampleResult& result : results)
            blocked += result.radiance == Radiance{};
    }
    std::uint32_t traced = 0;
    for (const RayRange& range : wall.asked)
        traced += range.count;
    EXPECT_EQ(traced + blocked, kHeight * Settings::cameraRaysOfBatch);
    EXPECT_GT(blocked, 0);
    EXPECT_GT(traced, 0u);
    EXPECT_GT(tracer.refusedRays, 0u);
}

TEST(SampleTracer, MixesASampleOfThreeColours)
{
    Character fringes;
    fringes.lateralColour = 0.1;
    Wall wall;
    const SampledCamera camera = CameraWith(StatementWith(fringes));
    for (const SampleResult& result : FirstGroup(camera, wall, 20, 30))
    {
        for (std::size_t channel = 0; channel < result.radiance.size(); channel++)
            EXPECT_NEAR(result.radiance[channel], (Radiance{1.0, 2.0, 3.0, 0.5, 0.25}[channel]), 1e-12);
        EXPECT_EQ(result.circle.lens, nullptr);
    }
    ASSERT_EQ(wall.asked.size(), 3 * Settings::cameraRaysOfBatch);
    for (std::uint32_t i = 0; i < wall.asked.size(); i++)
    {
        EXPECT_EQ(wall.asked[i].count, 1u);
        EXPECT_EQ(wall.asked[i].index, i / 3);
    }
}

TEST(SampledCamera, SpreadsSamplesOnlyWhereTheirCirclesAreKnown)
{
    EXPECT_TRUE(CameraWith(StatementWith()).spreads);
    EXPECT_FALSE(CameraWith(StatementWith(), false).spreads) << "not denoised";
    EXPECT_FALSE(CameraWith(StatementWith(), true, true).spreads) << "the renderer deflects rays";
    EXPECT_FALSE(CameraWith(StatementOfGlass()).spreads);
}

TEST(SampledCamera, TakesMoreFirstSamplesWhereNoneCanBeAimed)
{
    EXPECT_EQ(CameraWith(StatementWith()).limits.min, Settings::firstSamples);
    EXPECT_EQ(CameraWith(StatementWith(), false).limits.min, Settings::firstSamplesAlone);
    EXPECT_EQ(CameraWith(StatementWith(), true, true).limits.min, Settings::firstSamplesAlone);
    EXPECT_TRUE(CameraWith(StatementWith(), true, true, {{{0.0, 0.0, 40.0}, 0.03, 40.0}}).emitters.Empty());
}

} // namespace
} // namespace tilt_lens
