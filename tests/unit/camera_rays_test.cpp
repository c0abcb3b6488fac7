// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/camera_rays.h"

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

std::vector<SampleRun> Runs(std::uint32_t x, std::uint32_t y)
{
    std::vector<SampleRun> runs;
    for (const std::uint32_t group : {0u, 8u, 24u, 4096u, 4294967288u})
        for (const std::uint32_t place : {0u, 1u, 2u, 3u, 4u, 6u})
            for (std::uint32_t count = 1; place + count <= Settings::cameraRaysOfBatch; count++)
                runs.push_back({{x, y, group + place}, count});
    return runs;
}

Lens SomeLens(const Character& character = {}, double scale = 1.0)
{
    Statement statement;
    statement.family = FocusFamily::FocusTurn;
    statement.focusTilt = 20.0;
    statement.focalPoint = {0.0, 0.0, 10.0};
    statement.aperture = 2.0;
    statement.character = character;
    Lens lens = Solve({{}, {0.1, 0.0, 1.0}, {4.0 / 3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, statement);
    for (Vec3* const along : {&lens.direction, &lens.right, &lens.up})
        *along = scale * *along;
    return lens;
}

std::vector<double> NumbersOf(const CameraRays& rays, std::uint32_t i)
{
    const CameraSamples& s = rays.samples;
    return {s.x[i],
            s.y[i],
            s.a[i],
            s.b[i],
            s.weight[i],
            s.overPlain[i],
            s.expectedEmission[i],
            rays.origin[0][i],
            rays.origin[1][i],
            rays.origin[2][i],
            rays.direction[0][i],
            rays.direction[1][i],
            rays.direction[2][i],
            rays.length[i],
            rays.w[i]};
}

void ExpectRaysOneByOne(const Lens& lens, const Aperture& aperture, const Character& character = {}, const std::vector<Emitter>& lamps = {})
{
    const SampledCamera camera(std::make_shared<const LensCamera>(Shared(lens), aperture, character), Limits(8, 64, 1e-3),
                               {kWidth, kHeight, lamps}, 5);
    const EmitterSampling& emitters = camera.emitters;
    EXPECT_EQ(emitters.TargetsOf(27, 24).targets.empty(), lamps.empty());
    for (const std::uint32_t x : {0u, 27u, 63u})
    {
        CameraRayBatch batch(camera);
        const EmitterSampling::Targets targets = emitters.TargetsOf(x, 24);
        const PixelSampler sampler(x, 24, 5);
        for (const SampleRun& run : Runs(x, 24))
        {
            batch.Make(run);
            EXPECT_EQ(batch.Refused(), 0u);
            for (std::uint32_t i = 0; i < run.count; i++)
            {
                CameraRays expected{};
                const CameraSample sample = emitters.Draw(targets, run[i], sampler(run[i].index));
                expected.samples.Put(0, sample);
                expected.Put(0, MakeRay(lens, sample.x, sample.y, sample.point.a, sample.point.b));
                ASSERT_EQ(NumbersOf(batch.Rays(), run.Place() + i), NumbersOf(expected, 0)) << x << ", sample " << run[i].index;
            }
        }
    }
}

TEST(CameraRays, EqualRaysComputedOneByOne)
{
    Character distorts, curves, rims;
    distorts.distortion1 = -0.05;
    curves.fieldCurvature = 0.1;
    rims.opticalVignetting = 1.0;
    const Aperture bright = Aperture::Picture([](double u, double v) { return u < 0.4 || v > 0.7 ? 1.0 : 0.2; });
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(5, 0.3), Aperture::Polygon(7, 0.3, 0.5), bright,
                                     Aperture::Squeezed(Aperture::Disc(), 2.0), Aperture::Graded(Aperture::Polygon(6, 0.0), 0.5)})
        for (const Character& character : {Character(), distorts, curves})
            ExpectRaysOneByOne(SomeLens(character), aperture);
    ExpectRaysOneByOne(SomeLens(rims), Aperture::Disc(), rims);
}

TEST(CameraRays, EqualRaysComputedOneByOneWithEmitterSampling)
{
    ExpectRaysOneByOne(SomeLens(), Aperture::Disc(), {}, {{{0.0, 0.0, 30.0}, 0.05, 1e4}});
}

/// At the frame's edge, rims block some samples.
TEST(CameraRays, EqualRaysComputedOneByOneWithAGlassLens)
{
    Statement statement;
    statement.prescription = std::make_shared<const Prescription>(ReadPrescription(kDoubleGauss));
    statement.sceneUnit = 1.0;
    statement.focalPoint = {0.0, 0.0, 3000.0};
    statement.shiftUp = 9.0;
    const SolvedLens lens = Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, statement);
    Character natural;
    natural.naturalVignetting = 1.0;
    const SampledCamera camera(std::make_shared<const LensCamera>(Shared(lens), Aperture::Disc(), natural), Limits(8, 64, 1e-3),
                               {kWidth, kHeight}, 5);
    std::uint32_t refusedInAll = 0;
    for (const std::uint32_t y : {0u, 24u, 47u})
    {
        CameraRayBatch batch(camera);
        const PixelSampler sampler(27, y, 5);
        for (const SampleRun& run : Runs(27, y))
        {
            batch.Make(run);
            std::uint32_t refused = 0;
            for (std::uint32_t i = 0; i < run.count; i++)
            {
                const SequencePoint point = sampler(run[i].index);
                const FilmPoint film = FilmPointAt(27 + point.pixelX, y + point.pixelY, kWidth, kHeight);
                const GlassSample one = camera.lens->Glass()->Draw(film, point.lensU, point.lensV,
                                                                   PixelHash(27, y, camera.lens->SeedSalt(), run[i].index));
                refused += one.refused;
                ASSERT_EQ(batch.Rays().samples.weight[run.Place() + i], one.weight);
                if (one.weight == 0.0)
                    continue;
                CameraRays expected{};
                expected.samples.Put(0, {film.x, film.y, {0.0, 0.0}, one.weight, 0.0});
                expected.Put(0, one.ray);
                ASSERT_EQ(NumbersOf(batch.Rays(), run.Place() + i), NumbersOf(expected, 0)) << y << ", sample " << run[i].index;
            }
            EXPECT_EQ(batch.Refused(), refused);
            refusedInAll += refused;
        }
    }
    EXPECT_GT(refusedInAll, 100u);
}

/// Squares of such lengths overflow or underflow.
TEST(CameraRays, MayHaveAnyLength)
{
    for (const double scale : {1e-170, 1e-101, 1e101, 1e160})
    {
        Lens lens = SomeLens({}, scale);
        lens.lensX = scale * lens.lensX;
        lens.focusMiddle = lens.focusRight = lens.focusUp = 0.0;
        ExpectRaysOneByOne(lens, Aperture::Disc());
    }
}

TEST(CameraRays, AreChiefRaysWhereThereIsNoDirection)
{
    Lens lens = SomeLens();
    lens.direction = lens.lensX = {0.25, 0.0, 0.0};
    lens.right = lens.up = lens.lensY = {};
    lens.focusMiddle = 1.0;
    lens.focusRight = lens.focusUp = 0.0;
    CameraRays rays{};
    for (std::uint32_t i = 0; i < Settings::cameraRaysOfBatch; i++)
        rays.samples.Put(i, {0.1, 0.2, {i % 2 ? 1.0 : 0.5, 0.0}, 1.0, 0.0});
    FindRays(lens, {{0, 0, 0}, Settings::cameraRaysOfBatch}, rays);
    for (std::uint32_t i = 0; i < Settings::cameraRaysOfBatch; i++)
    {
        EXPECT_EQ(rays.direction[0][i], 1.0);
        EXPECT_EQ(rays.length[i], i % 2 ? 0.25 : 0.125);
    }
}

} // namespace
} // namespace tilt_lens
