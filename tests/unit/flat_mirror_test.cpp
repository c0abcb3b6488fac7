// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/flat_mirror.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

constexpr double kLensRadius = 0.2;

using Random = std::mt19937;

double Uniform(Random& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

Vec3 AnyVector(Random& random, double size)
{
    return {Uniform(random, -size, size), Uniform(random, -size, size), Uniform(random, -size, size)};
}

Vec3 NormalOf(const FlatMirror& mirror)
{
    return Normalized(Cross(mirror.sides[0], mirror.sides[1]));
}

double DistanceOf(const Vec3& point, const FlatMirror& mirror)
{
    return Dot(point - mirror.corner, NormalOf(mirror));
}

struct Path
{
    Vec3 origin, direction;
};

/// Ends the ray at the first mirror; returns its index, or the number of mirrors.
std::size_t Reflect(Path& path, const std::vector<FlatMirror>& mirrors, std::size_t before)
{
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t hit = mirrors.size();
    for (std::size_t i = 0; i < mirrors.size(); i++)
    {
        const FlatMirror& mirror = mirrors[i];
        const Vec3 normal = NormalOf(mirror);
        const double distance = -DistanceOf(path.origin, mirror) / Dot(path.direction, normal);
        if (i == before || !(distance > 0.0) || distance >= nearest || (!mirror.unbounded && Dot(path.direction, normal) > 0.0))
            continue;
        const Vec3 at = path.origin + distance * path.direction - mirror.corner;
        const double area = Length(Cross(mirror.sides[0], mirror.sides[1]));
        const double a = Dot(Cross(at, mirror.sides[1]), normal) / area, b = Dot(Cross(mirror.sides[0], at), normal) / area;
        if (mirror.unbounded || (a > 0.0 && a < 1.0 && b > 0.0 && b < 1.0))
        {
            nearest = distance;
            hit = i;
        }
    }
    if (hit == mirrors.size())
        return hit;
    const Vec3 normal = NormalOf(mirrors[hit]);
    path.origin = path.origin + nearest * path.direction;
    path.direction = path.direction - 2.0 * Dot(path.direction, normal) * normal;
    return hit;
}

double DistanceFrom(const Path& path, const Vec3& point)
{
    const Vec3 to = point - path.origin;
    const double along = Dot(to, path.direction) / Dot(path.direction, path.direction);
    return along > 0.0 ? Length(to - along * path.direction) : std::numeric_limits<double>::infinity();
}

FlatMirror AnyMirror(Random& random)
{
    return {AnyVector(random, 4.0), {AnyVector(random, 6.0), AnyVector(random, 6.0)}, Uniform(random, 0, 1) < 0.3, Uniform(random, 0.3, 1)};
}

std::vector<Emitter> ImagesOf(const Emitter& source, const std::vector<FlatMirror>& mirrors)
{
    return MirrorImages({source}, mirrors, 2.0 * kLensRadius);
}

TEST(FlatMirror, ImageIsBehindTheMirror)
{
    const FlatMirror wall{{-1.0, -1.0, 5.0}, {{0.0, 2.0, 0.0}, {2.0, 0.0, 0.0}}, false, 0.5};
    const std::vector<Emitter> images = ImagesOf({{1.0, 0.0, -2.0}, 0.1, 8.0, 1.0}, {wall});
    ASSERT_EQ(images.size(), 1u);
    EXPECT_NEAR(Length(images[0].centre - Vec3{1.0, 0.0, 12.0}), 0.0, 1e-12);
    EXPECT_DOUBLE_EQ(images[0].radius, 0.1);
    EXPECT_DOUBLE_EQ(images[0].radiance, 4.0);
    EXPECT_DOUBLE_EQ(images[0].around, 1.0);
}

TEST(FlatMirror, NothingIsSeenBesideTheMirrorBehindItOrTooFaint)
{
    const FlatMirror wall{{-1.0, -1.0, 5.0}, {{0.0, 2.0, 0.0}, {2.0, 0.0, 0.0}}, false, 0.5};
    EXPECT_TRUE(ImagesOf({{8.0, 0.0, -2.0}, 0.1, 8.0, 1.0}, {wall}).empty());
    EXPECT_TRUE(ImagesOf({{1.0, 0.0, 6.0}, 0.1, 8.0, 1.0}, {wall}).empty());
    EXPECT_TRUE(ImagesOf({{1.0, 0.0, -2.0}, 0.1, 1.9, 1.0}, {wall}).empty());
    const FlatMirror back{wall.corner, {wall.sides[1], wall.sides[0]}, false, 0.5};
    EXPECT_TRUE(ImagesOf({{1.0, 0.0, -2.0}, 0.1, 8.0, 1.0}, {back}).empty());
    const FlatMirror line{wall.corner, {wall.sides[0], wall.sides[0]}, false, 0.5};
    EXPECT_TRUE(ImagesOf({{1.0, 0.0, -2.0}, 0.1, 8.0, 1.0}, {line}).empty());
    const FlatMirror endless{wall.corner, {wall.sides[1], wall.sides[0]}, true, 0.5};
    EXPECT_EQ(ImagesOf({{8.0, 0.0, -2.0}, 0.1, 8.0, 1.0}, {endless}).size(), 1u);
}

TEST(FlatMirror, ComputingIsBounded)
{
    const FlatMirror wall{{-1.0, -1.0, 5.0}, {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, true, 1.0};
    FlatMirror facing = wall;
    facing.corner.z = -5.0;
    const std::vector<FlatMirror> two = {wall, facing};
    const Emitter lamp{{0.0, 0.0, 1.0}, 0.1, 8.0};
    EXPECT_EQ(ImagesOf(lamp, two).size(), 4u);
    const std::vector<Emitter> many(Settings::greatestImages / 4 + 1, lamp);
    EXPECT_EQ(MirrorImages(many, two, 0.4).size(), 2 * many.size());
    std::vector<FlatMirror> small(100, {{-1.0, -1.0, -5.0}, {{2.0, 0.0, 0.0}, {0.0, 2.0, 0.0}}, false, 1.0});
    small.push_back(wall);
    const std::vector<Emitter> most(Settings::greatestImages / 2, lamp);
    for (const Emitter& image : MirrorImages(most, small, 0.4))
        ASSERT_TRUE(image.centre.z == 9.0 || image.centre.z == -11.0) << "the largest mirror is kept";
}

TEST(FlatMirror, EveryReflectedRayToALampPointsAtAnImage)
{
    Random random(7);
    std::size_t met[3] = {};
    for (int world = 0; world < 20000; world++)
    {
        const std::vector<FlatMirror> mirrors = {AnyMirror(random), AnyMirror(random), AnyMirror(random)};
        const Vec3 start{Uniform(random, -0.7, 0.7) * kLensRadius, Uniform(random, -0.7, 0.7) * kLensRadius, 0.0};
        const Path first{start, AnyVector(random, 1.0)};
        Path path = first;
        Vec3 eye{};
        std::size_t last = mirrors.size();
        for (int reflections = 0; reflections <= 2; reflections++)
        {
            const std::size_t hit = Reflect(path, mirrors, last);
            if (hit == mirrors.size())
                break;
            last = hit;
            if (reflections == 2 || std::fabs(DistanceOf(eye, mirrors[hit])) < kLensRadius)
                break;  // the mirror may cut the lens
            eye = eye - 2.0 * DistanceOf(eye, mirrors[hit]) * NormalOf(mirrors[hit]);
            Path beyond = path;
            Reflect(beyond, mirrors, last);
            const double way = Length(beyond.origin - path.origin) > 0.0 ? Length(beyond.origin - path.origin) : 5.0;
            const Vec3 along = Normalized(path.direction);
            const Emitter lamp{path.origin + Uniform(random, 0.1, 0.9) * way * along, 0.05, 1e6};
            double nearest = std::numeric_limits<double>::infinity();
            for (const Emitter& image : ImagesOf(lamp, mirrors))
                nearest = std::min(nearest, DistanceFrom(first, image.centre));
            EXPECT_LT(nearest, 1e-9 * (1.0 + Length(lamp.centre))) << world;
            met[reflections + 1]++;
        }
    }
    EXPECT_GT(met[1], 3000u);
    EXPECT_GT(met[2], 600u);
}

}  // namespace
}  // namespace tilt_lens
