// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/emitter_sampling.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tile_results.h"

namespace tilt_lens
{
namespace
{

constexpr std::uint32_t kWidth = 64, kHeight = 48;
constexpr double kBackground = 0.3;

/// Lens 1 wide at the origin, focus at 10; `turn` in degrees.
Lens LensOf(double turn, const Character& character = {})
{
    Statement statement;
    statement.family = FocusFamily::FocusTurn;
    statement.focusTilt = turn;
    statement.focalPoint = {0.0, 0.0, 10.0};
    statement.aperture = 2.0;
    statement.character = character;
    return Solve({{}, {0.0, 0.0, 1.0}, {4.0 / 3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, statement);
}

Aperture Window()
{
    return Aperture::Picture([](double u, double v) { return u < 0.4 || v > 0.7 ? 1.0 : 0.2; });
}

struct World
{
    std::vector<Emitter> spheres;
    double background = kBackground;

    double operator()(const LensRay& ray) const
    {
        const Vec3 way = Normalized(ray.direction);
        for (const Emitter& sphere : spheres)
        {
            const Vec3 to = sphere.centre - ray.origin;
            const double along = Dot(to, way);
            if (along > 0.0 && Length(to - along * way) < sphere.radius)
                return sphere.radiance;
        }
        return background;
    }
};

/// Mean of n samples, and variances of one.
struct Pixel
{
    double mean, variance, withinStrata;
};

Pixel SampleOf(const EmitterSampling& emitters, const Lens& lens, const World& world, std::uint32_t x, std::uint32_t y, std::uint32_t n,
               std::uint32_t seed)
{
    const EmitterSampling::Targets targets = emitters.TargetsOf(x, y);
    const PixelSampler sampler(x, y, seed);
    double sums[2] = {}, counts[2] = {}, squares = 0.0;
    for (std::uint32_t i = 0; i < n; i++)
    {
        const CameraSample start = emitters.Draw(targets, {x, y, i}, sampler(i));
        const double light = start.weight > 0.0 ? start.weight * world(MakeRay(lens, start.x, start.y, start.point.a, start.point.b)) : 0.0;
        const bool atEmitter = start.expectedEmission > 0.0;
        sums[atEmitter] += light;
        counts[atEmitter]++;
        squares += light * light;
    }
    double between = 0.0;
    for (int i = 0; i < 2; i++)
        between += counts[i] > 0.0 ? sums[i] * sums[i] / counts[i] : 0.0;
    const double mean = (sums[0] + sums[1]) / n;
    return {mean, squares / n - mean * mean, (squares - between) / n};
}

SamplingLimits Limits(std::uint32_t min = 8, std::uint32_t max = 1u << 20, double variance = SamplingLimits().variance)
{
    SamplingLimits limits;
    limits.variance = variance;
    limits.min = min;
    limits.max = max;
    return limits;
}

struct Case
{
    const char* name;
    double turn;
    Aperture aperture;
    std::vector<Emitter> lamps;
    Character character = {};
};

Character Real()
{
    Character character;
    character.naturalVignetting = 1.0;
    character.opticalVignetting = 0.7;
    character.distortion1 = 0.15;
    character.fieldCurvature = 0.3;
    return character;
}

std::vector<Case> Cases()
{
    const Emitter far{{1.0, 0.5, 40.0}, 0.03, 40.0}, near{{-0.4, 0.3, 5.0}, 0.005, 40.0}, sharp{{0.7, -0.6, 10.0}, 0.03, 40.0},
        nearlySharp{{0.7, 0.9, 10.4}, 0.02, 40.0};
    const Emitter beside{{1.1, 0.55, 41.0}, 0.05, 20.0};
    return {{"far", 0.0, Aperture::Disc(), {far}},
            {"near", 0.0, Aperture::Disc(), {near}},
            {"sharp", 0.0, Aperture::Disc(), {sharp}},
            {"nearly sharp", 0.0, Aperture::Disc(), {nearlySharp}},
            {"two", 0.0, Aperture::Disc(), {far, beside}},
            {"tilted", 30.0, Aperture::Disc(), {far, near, sharp, nearlySharp}},
            {"blades", 0.0, Aperture::Polygon(5, 0.3), {far, sharp}},
            {"squeezed", 20.0, Aperture::Squeezed(Aperture::Polygon(5, 0.3, 0.5), 2.0), {far, near, sharp}},
            {"picture", 20.0, Window(), {far, near, sharp}},
            {"rim", 0.0, Aperture::Graded(Aperture::Disc(), 0.5), {far, near, sharp}},
            {"real", 0.0, Aperture::Disc(), {far, near, sharp}, Real()},
            {"real tilted",
             20.0,
             Aperture::Squeezed(Aperture::Graded(Aperture::Polygon(5, 0.3), -0.3), 1.5),
             {far, near, sharp, nearlySharp},
             Real()},
            {"real picture", 0.0, Window(), {far, near, sharp}, Real()}};
}

std::shared_ptr<const LensCamera> CameraOf(const Lens& lens, const Aperture& aperture = Aperture::Disc(), const Character& character = {})
{
    return std::make_shared<const LensCamera>(Shared(lens), aperture, character);
}

struct Prepared
{
    Lens lens;
    World world;
    LensSampler lensSampler;
    EmitterSampling emitterSampled, plain;

    explicit Prepared(const Case& one) :
        lens(LensOf(one.turn, one.character)),
        world{one.lamps},
        lensSampler(CameraOf(lens, one.aperture, one.character), kWidth, kHeight),
        emitterSampled(lensSampler, Limits(), one.lamps),
        plain(lensSampler, Limits(), {})
    {
    }
};

std::pair<int, int> PixelOf(const Lens& lens, const Emitter& lamp)
{
    const double scale = lens.direction.z / lamp.centre.z;
    return {int((lamp.centre.x * scale / lens.right.x + 0.5) * kWidth), int((0.5 - lamp.centre.y * scale / lens.up.y) * kHeight)};
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> PixelsAround(const Lens& lens, const Case& one)
{
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pixels;
    for (const Emitter& lamp : one.lamps)
    {
        const auto [x, y] = PixelOf(lens, lamp);
        for (int step = -3; step <= 3; step++)
            pixels.push_back({std::uint32_t(x + step), std::uint32_t(y + step / 2)});
    }
    return pixels;
}

TEST(EmitterSampling, IsUnbiased)
{
    for (const Case& one : Cases())
    {
        const Prepared prepared(one);
        const auto& [lens, world, lensSampler, emitterSampled, plain] = prepared;
        ASSERT_FALSE(emitterSampled.Empty()) << one.name;
        double squares = 0.0;
        int count = 0;
        for (const auto& [x, y] : PixelsAround(lens, one))
        {
            if (emitterSampled.TargetsOf(x, y).share == 0.0)
                continue;
            const std::uint32_t n = 1u << 16;
            const Pixel a = SampleOf(emitterSampled, lens, world, x, y, n, 1), p = SampleOf(plain, lens, world, x, y, n, 2);
            const double error = std::sqrt((a.variance + p.variance) / n) + 1e-9;
            EXPECT_LT(std::fabs(a.mean - p.mean), 3.5 * error) << one.name << " at " << x << ", " << y;
            squares += std::pow((a.mean - p.mean) / error, 2);
            count++;
        }
        EXPECT_LT(squares / count, 1.5) << one.name;
    }
}

/// Relative weights are those of a sample of even light through an unvignetted lens: 1 on average.
TEST(EmitterSampling, RelativeWeightsLeaveVignettingOut)
{
    for (const Case& one : Cases())
    {
        const Prepared prepared(one);
        const auto [x, y] = PixelOf(prepared.lens, one.lamps.front());
        const EmitterSampling::Targets targets = prepared.emitterSampled.TargetsOf(x, y);
        const PixelSampler sampler(x, y, 1);
        constexpr std::uint32_t n = 1u << 14;
        double sum = 0.0;
        for (std::uint32_t i = 0; i < n; i++)
        {
            const SampleId id{std::uint32_t(x), std::uint32_t(y), i};
            const CameraSample sample = prepared.emitterSampled.Draw(targets, id, sampler(i));
            sum += sample.weight > 0.0 ? sample.overPlain / n : 0.0;
            if (sample.weight > 0.0 && one.character.opticalVignetting == 0.0)
            {
                ASSERT_EQ(sample.overPlain, sample.weight) << one.name;
            }
        }
        EXPECT_NEAR(sum, 1.0, 0.05) << one.name;
    }
}

TEST(EmitterSampling, LowersTheVarianceOfLamps)
{
    for (const Case& one : Cases())
    {
        const Prepared prepared(one);
        const auto& [lens, world, lensSampler, emitterSampled, plain] = prepared;
        double with = 0.0, without = 0.0;
        for (const auto& [x, y] : PixelsAround(lens, one))
        {
            with += SampleOf(emitterSampled, lens, world, x, y, 1u << 14, 1).withinStrata;
            without += SampleOf(plain, lens, world, x, y, 1u << 14, 2).withinStrata;
        }
        EXPECT_LT(with, without / 8.0) << one.name;
    }
}

TEST(EmitterSampling, HiddenLampsLeaveEvenLightEven)
{
    const Emitter lamp{{1.0, 0.5, 40.0}, 0.03, 40.0};
    const Lens lens = LensOf(0.0);
    const LensSampler plain(CameraOf(lens), kWidth, kHeight);
    const EmitterSampling emitterSampled(plain, Limits(), {lamp});
    int reached = 0;
    for (std::uint32_t y = 0; y < kHeight; y++)
        for (std::uint32_t x = 0; x < kWidth; x++)
        {
            const Pixel pixel = SampleOf(emitterSampled, lens, {{}}, x, y, 64, 1);
            EXPECT_NEAR(pixel.mean, kBackground, 0.1 * kBackground) << x << ", " << y;
            reached += emitterSampled.TargetsOf(x, y).share > 0.0;
        }
    EXPECT_GT(reached, 4);
    EXPECT_LT(reached, 100);
}

bool LampIsWithin(int pixels, const Lens& lens, const Case& one, std::uint32_t x, std::uint32_t y)
{
    return std::any_of(one.lamps.begin(), one.lamps.end(), [&](const Emitter& lamp)
    {
        const auto [middleX, middleY] = PixelOf(lens, lamp);
        return std::abs(int(x) - middleX) <= pixels && std::abs(int(y) - middleY) <= pixels;
    });
}

/// Blur spreads these lamps over at most 3 pixels.
TEST(EmitterSampling, ReachesEveryPixelThatSeesALamp)
{
    for (const Case& one : Cases())
    {
        const Prepared prepared(one);
        const auto& [lens, world, lensSampler, emitterSampled, plain] = prepared;
        for (std::uint32_t y = 0; y < kHeight; y++)
            for (std::uint32_t x = 0; x < kWidth; x++)
            {
                const std::uint32_t n = LampIsWithin(6, lens, one, x, y) ? 1024 : 16;
                const bool seen = SampleOf(plain, lens, {one.lamps, 0.0}, x, y, n, 2).mean > 0.0;
                EXPECT_TRUE(!seen || emitterSampled.TargetsOf(x, y).share > 0.0) << one.name << " at " << x << ", " << y;
            }
    }
}

TEST(EmitterSampling, KeepsOnlySmallBrightEmittersInFront)
{
    const LensSampler plain(CameraOf(LensOf(0.0)), kWidth, kHeight);
    const auto empty = [&](const Emitter& emitter, const SamplingLimits& limits = Limits())
    { return EmitterSampling(plain, limits, {emitter}).Empty(); };
    EXPECT_FALSE(empty({{0.0, 0.0, 40.0}, 0.03, 40.0}));
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 3.0, 40.0})) << "large: found by chance";
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 0.03, 1.0})) << "dim";
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 1e-5, 40.0})) << "too small to matter";
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 0.03, 40.0, 39.0})) << "hardly brighter than what may lie around it";
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 0.03, 40.0}, Limits(8, 1024, 1.0))) << "within the noise that is allowed";
    EXPECT_TRUE(empty({{0.0, 0.0, -40.0}, 0.03, 40.0})) << "behind the camera";
    EXPECT_TRUE(empty({{0.0, 0.0, 0.1}, 0.03, 40.0})) << "at the lens";
    EXPECT_TRUE(empty({{0.0, 0.0, 40.0}, 0.03, 40.0}, Limits(1, 2))) << "fewer samples than a block of four";
}

TEST(EmitterSampling, EveryBlockOfFourHasTheSameShare)
{
    const Emitter lamp{{1.0, 0.5, 40.0}, 0.03, 40.0};
    const Lens lens = LensOf(0.0);
    const LensSampler plain(CameraOf(lens), kWidth, kHeight);
    const EmitterSampling emitterSampled(plain, Limits(8, 39), {lamp});
    for (std::uint32_t y = 0; y < kHeight; y++)
        for (std::uint32_t x = 0; x < kWidth; x++)
        {
            const EmitterSampling::Targets targets = emitterSampled.TargetsOf(x, y);
            const PixelSampler sampler(x, y, 0);
            for (std::uint32_t from = 0; from < 40; from += 4)
            {
                int count = 0;
                for (std::uint32_t i = from; i < from + 4; i++)
                    count += emitterSampled.Draw(targets, {x, y, i}, sampler(i)).expectedEmission > 0.0;
                EXPECT_EQ(count, from + 4 > 39 ? 0 : int(4 * targets.share)) << x << ", " << y << " from " << from;
            }
        }
}

TEST(ApertureDensity, MatchesTheSampledPoints)
{
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(3, 0.2), Aperture::Polygon(8, 2.0), Window(),
                                     Aperture::Graded(Aperture::Disc(), 0.4), Aperture::Graded(Aperture::Polygon(6, 0.1, 0.5), -0.6)})
    {
        constexpr int side = 400, boxes = 8;
        std::vector<double> expected(boxes * boxes), found(boxes * boxes);
        const auto box = [&](const AperturePoint& p) { return int((p.a + 1.5) / 3.0 * boxes) * boxes + int((p.b + 1.5) / 3.0 * boxes); };
        double farthest = 0.0;
        for (int i = 0; i < side; i++)
            for (int j = 0; j < side; j++)
            {
                const double u = (i + 0.5) / side, v = (j + 0.5) / side;
                const AperturePoint grid{3.0 * u - 1.5, 3.0 * v - 1.5}, point = aperture(u, v);
                expected[box(grid)] += aperture.Density(grid) * 9.0 / (side * side);
                found[box(point)] += 1.0 / (side * side);
                EXPECT_GT(aperture.Density(point), 0.0);
                farthest = std::max(farthest, std::hypot(point.a, point.b));
            }
        for (int i = 0; i < boxes * boxes; i++)
            EXPECT_NEAR(found[i], expected[i], 2e-3) << i;
        EXPECT_LE(farthest, aperture.BoundingRadius());
    }
}

} // namespace
} // namespace tilt_lens
