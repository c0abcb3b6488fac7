// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/lamp_search.h"

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tile_results.h"
#include "together.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kWidth = 64, kHeight = 48;
/// Margins are an eighth of the width.
constexpr double kWithMargin = 80.0 * 64.0 / (kWidth * kHeight);

/// Lens 4 wide at the origin, focus at 10; the frame is 4/3 wide at 1.
SampledCamera CameraWith(const std::vector<Emitter>& emitters = {})
{
    Statement statement;
    statement.focalPoint = {0.0, 0.0, 10.0};
    statement.aperture = 8.0;
    const SolvedLens lens = Solve({{}, {0.0, 0.0, 1.0}, {4.0 / 3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, statement);
    SamplingLimits limits = Limits(0, 64, 1e-4);
    limits.denoise = true;
    return SampledCamera(std::make_shared<const LensCamera>(Shared(lens), Aperture::Disc(), statement.character, false), limits,
                         {kWidth, kHeight, emitters}, 0);
}

/// Spheres before a wall at z = `wall`, whose radiance depends on the point.
struct World : RayTracer
{
    std::vector<Emitter> spheres;
    double wall = 100.0;
    std::function<double(const Vec3&)> radiance = [](const Vec3&) { return 0.5; };
    std::atomic<int> traced{0};
    int failing = 0;  ///< every how many rays the tracer throws

    void Trace(const CameraRays& rays, const RayRange& range, Hit* hits) override
    {
        EXPECT_EQ(range.count, 1u);
        EXPECT_TRUE(range.distances);
        if (++traced; failing > 0 && traced % failing == 0)
            throw std::runtime_error("interrupted");
        const Vec3 origin{rays.origin[0][0], rays.origin[1][0], rays.origin[2][0]};
        const Vec3 way{rays.direction[0][0], rays.direction[1][0], rays.direction[2][0]};
        EXPECT_NEAR(Length(origin), 0.0, 1e-12) << "through the lens centre";
        for (const Emitter& sphere : spheres)
        {
            const double along = Dot(sphere.centre, way);
            if (Length(sphere.centre - along * way) < sphere.radius)
            {
                *hits = {Grey(sphere.radiance), along};
                return;
            }
        }
        const double distance = wall / way.z;
        *hits = {Grey(radiance(distance * way)), distance};
    }
};

void RunSearch(LampSearch& search, World& world, int threads = 1)
{
    TakeTogether(threads, [&] { return search.NextRow(); }, [&](std::size_t row) { search.Take(row, world); });
}

std::size_t LampsFound(World& world, const std::vector<Emitter>& known = {})
{
    world.traced = 0;
    SampledCamera camera = CameraWith(known);
    LampSearch search(camera, kWidth, kHeight, 16.0);
    RunSearch(search, world);
    EXPECT_EQ(search.Rays(), std::size_t(world.traced));
    return search.Lamps();
}

const std::vector<Emitter> kLamps{{{2.0, 1.0, 40.0}, 0.6, 40.0}, {{-9.0, 5.0, 50.0}, 0.9, 30.0}, {{1.0, -6.0, 30.0}, 0.5, 60.0}};

TEST(LampSearch, FindsPlaceAndSize)
{
    World world;
    world.spheres = kLamps;
    SampledCamera camera = CameraWith();
    LampSearch search(camera, kWidth, kHeight, 16.0);
    RunSearch(search, world);
    ASSERT_EQ(search.Lamps(), kLamps.size());
    const SampledCamera exact = CameraWith(kLamps);
    const auto found = camera.emitters.SharpImages(), known = exact.emitters.SharpImages();
    for (const EmitterSampling::SharpImage& one : known)
    {
        int near = 0;
        for (const EmitterSampling::SharpImage& other : found)
        {
            if (std::hypot(one.x - other.x, one.y - other.y) > 0.3)
                continue;
            near++;
            EXPECT_GT(other.radius, 0.9 * one.radius);
            EXPECT_LT(other.radius, one.radius + 0.7) << "a third of a pixel is a cell";
        }
        EXPECT_EQ(near, 1) << one.x << " " << one.y;
    }
}

TEST(LampSearch, FindsLampsBesideThePictureAndAtInfinity)
{
    World world;
    world.spheres = {{{28.0, 0.0, 40.0}, 0.6, 40.0}};
    EXPECT_EQ(LampsFound(world), 1u) << "its blur reaches the picture";
    world.spheres = {{{38.0, 0.0, 40.0}, 0.6, 40.0}};
    EXPECT_EQ(LampsFound(world), 0u) << "far away";
    World sky;
    sky.wall = HUGE_VAL;
    sky.radiance = [](const Vec3&) { return 0.0; };
    sky.spheres = {{{0.2e9, 0.1e9, 1e9}, 1.5e7, 40.0}};
    EXPECT_EQ(LampsFound(sky), 1u);
}

TEST(LampSearch, LeavesOutWhatNeedsNoAim)
{
    World world;
    world.spheres = kLamps;
    EXPECT_EQ(LampsFound(world, kLamps), 0u) << "known";
    for (Emitter& sphere : world.spheres)
        sphere.radiance = 3.9;
    EXPECT_EQ(LampsFound(world), 0u) << "dim";
    for (Emitter& sphere : world.spheres)
        sphere.radiance = HUGE_VAL;
    EXPECT_EQ(LampsFound(world), 0u) << "not finite: such samples are black";
    world.spheres = {{{0.0, 0.0, 0.0}, 0.1, 40.0}};
    EXPECT_EQ(LampsFound(world), 0u) << "at the lens centre";
}

/// One ray in each pixel suffices to see that nothing is to be found.
TEST(LampSearch, EndsEarlyWhereNothingIsFound)
{
    const auto raysOf = [](const std::function<double(const Vec3&)>& radiance)
    {
        World world;
        world.radiance = radiance;
        EXPECT_EQ(LampsFound(world), 0u);
        return double(world.traced);
    };
    const double even = raysOf([](const Vec3&) { return 10.0; });
    EXPECT_EQ(even, kWithMargin * kWidth * kHeight);
    EXPECT_EQ(raysOf([](const Vec3&) { return 0.5; }), even);
    const auto checks = [](const Vec3& point) { return (std::lround(point.x / 2.1) + std::lround(point.y / 2.1)) % 2 ? 10.0 : 0.5; };
    EXPECT_EQ(raysOf(checks), even) << "plain samples find these";
}

TEST(LampSearch, FewBlurredPixelsNeedNoFinerCells)
{
    World world;
    world.spheres = {{{0.125, 0.125, 12.0}, 0.13, 40.0}};
    EXPECT_EQ(LampsFound(world), 1u);
    EXPECT_EQ(world.traced, kWithMargin * kWidth * kHeight);
    world.spheres = kLamps;
    EXPECT_EQ(LampsFound(world), kLamps.size());
    EXPECT_GT(world.traced, 9.0 * kWithMargin * kWidth * kHeight);
}

TEST(LampSearch, TakesNoMoreRaysThanAllowed)
{
    for (const double most : {1.0, 1.5, 3.0, 6.0, 100.0})
    {
        SampledCamera camera = CameraWith();
        LampSearch search(camera, kWidth, kHeight, most);
        World world;
        world.spheres = kLamps;
        RunSearch(search, world);
        const double limit = std::min(most, kWithMargin * (1.0 + Settings::searchRays));
        EXPECT_LE(search.RaysOfPixel(), 1.05 * limit) << most;
        EXPECT_GT(search.RaysOfPixel(), 0.9 * (most < 2.0 * kWithMargin ? std::min(most, kWithMargin) : limit)) << most;
    }
}

TEST(LampSearch, FindsTheSameWithManyThreadsAndInterruptions)
{
    World world, failing;
    world.spheres = failing.spheres = kLamps;
    failing.failing = 497;
    SampledCamera one = CameraWith(), many = CameraWith();
    LampSearch alone(one, kWidth, kHeight, 16.0), together(many, kWidth, kHeight, 16.0);
    RunSearch(alone, world);
    RunSearch(together, failing, 4);
    EXPECT_GT(failing.traced, world.traced);
    const auto a = one.emitters.SharpImages(), b = many.emitters.SharpImages();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); i++)
    {
        EXPECT_EQ(a[i].x, b[i].x);
        EXPECT_EQ(a[i].y, b[i].y);
        EXPECT_EQ(a[i].radius, b[i].radius);
    }
}

} // namespace
} // namespace tilt_lens
