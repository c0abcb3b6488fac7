// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Follows light to the film by the thin lens equation.

#include "tilt_lens/camera/ray.h"

#include <limits>

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "random_cameras.h"
#include "reference_camera.h"

namespace tilt_lens
{
namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();
const FocusFamily kFamilies[] = {FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane, FocusFamily::FocalPoints};

struct LensCoordinates
{
    double a, b;
};
const LensCoordinates kLensPoints[] = {{0, 0}, {1, 0}, {0, 1}, {-0.6, 0.8}, {0.3, -0.4}, {-0.7, -0.7}};

template<typename Check>
void ForManyCameras(int count, Check check)
{
    Random random(11);
    for (int i = 0; i < count && !testing::Test::HasFailure(); i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, kFamilies[i % 4], i % 8 < 4, lens);
        SCOPED_TRACE(testing::Message() << request);
        check(request, lens, random);
    }
}

Vec3 ChiefRay(const Lens& lens, double x, double y)
{
    return MakeRay(lens, x, y, 0.0, 0.0).direction;
}

TEST(Ray, ChiefRayPassesTheLensCentreUnbent)
{
    ForManyCameras(4000, [](const Request&, const Lens& lens, Random& random)
    {
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5);
        const LensRay ray = MakeRay(lens, x, y, 0.0, 0.0);
        EXPECT_EQ(Length(ray.origin), 0.0);
        EXPECT_LT(Length(ray.direction - (lens.direction + x * lens.right + y * lens.up)), 1e-15 * Length(ray.direction));
    });
}

TEST(Ray, OriginLiesInTheLens)
{
    ForManyCameras(4000, [](const Request&, const Lens& lens, Random& random)
    {
        for (const LensCoordinates& l : kLensPoints)
        {
            const LensRay ray = MakeRay(lens, random(-0.5, 0.5), random(-0.5, 0.5), l.a, l.b);
            const double radius = lens.diameter / 2;
            EXPECT_NEAR(Dot(ray.origin, lens.normal), 0.0, 4e-15 * radius);
            EXPECT_NEAR(Length(ray.origin), radius * std::hypot(l.a, l.b), 4e-15 * radius);
        }
    });
}

TEST(Ray, AllRaysOfAFilmPointMeetInThePlaneOfSharpFocus)
{
    int before = 0, behind = 0;
    ForManyCameras(8000, [&](const Request&, const Lens& lens, Random& random)
    {
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5);
        const Vec3 chief = ChiefRay(lens, x, y);
        const double w = Dot(lens.focus, chief);
        (w > 0.0 ? before : behind)++;
        for (const LensCoordinates& l : kLensPoints)
        {
            const LensRay ray = MakeRay(lens, x, y, l.a, l.b);
            const double size = Length(chief) + std::fabs(w) * Length(ray.origin);
            EXPECT_LT(Length(w * ray.origin + ray.direction - chief), 4e-15 * size);
            EXPECT_NEAR(Dot(lens.focus, w * ray.origin + ray.direction), w, 1e-14 * Length(lens.focus) * size);
            EXPECT_GT(Dot(ray.direction, lens.normal), 0.0) << "the ray leaves towards the film";
        }
    });
    EXPECT_GT(before, 100);
    EXPECT_GT(behind, 100) << "no film point with its focus behind the lens: the test lacks half";
}

TEST(Ray, FocusAtInfinityGivesParallelRays)
{
    const CameraFrame camera{{0, 1, 0}, {0, 0, 1}, {1.25, 0, 0}, {0, 1, 0}};
    Statement given;
    given.family = FocusFamily::FocalPlane;
    given.planeNormal = {0, 1, 0};
    given.aperture = 0.02;
    const Lens lens = Solve(camera, given);
    for (const double x : {-0.5, 0.0, 0.375})
        for (const LensCoordinates& l : kLensPoints)
        {
            const LensRay ray = MakeRay(lens, x, 0.0, l.a, l.b);
            EXPECT_EQ(Length(Cross(ray.direction, ChiefRay(lens, x, 0.0))), 0.0) << l.a << ", " << l.b;
            EXPECT_GT(ray.direction.z, 0.0);
            const Vec3 step = MakeRay(lens, x, 1e-9, l.a, l.b).direction - MakeRay(lens, x, -1e-9, l.a, l.b).direction;
            EXPECT_NEAR(Length(step), 2e-9, 1e-10);
        }
}

TEST(Ray, LensPointThatTouchesItsFilmPointHasADirection)
{
    // turned into the axis, radius 1, film 1 behind its centre
    Lens lens;
    lens.direction = {0, 0, 1};
    lens.right = {1, 0, 0};
    lens.up = {0, 1, 0};
    lens.focus = {0, -1, -1};
    lens.focusMiddle = -1.0;
    lens.focusUp = -1.0;
    lens.lensX = {1, 0, 0};
    lens.lensY = {0, 0, 1};
    const LensRay ray = MakeRay(lens, 0.0, 0.0, 0.0, -1.0);
    EXPECT_EQ(Length(ray.direction - lens.direction), 0.0);
    EXPECT_EQ(Length(ray.origin - Vec3{0, 0, -1}), 0.0);
}

TEST(Ray, KeepsItsDigitsWhereFocusAndRayAreNearlyParallel)
{
    // the plane passes 1e-7 below the lens: k is large, k.D is not
    Random random(31);
    for (int i = 0; i < 200; i++)
    {
        Request request = PlainRequest();
        const Vec3 axis = random.Direction(), right = Normalized(Cross(axis, random.Direction()));
        request.camera = {{0, 0, 0}, 1.6 * axis, 1.6 * right, 1.2 * Cross(axis, right)};
        request.given.family = FocusFamily::FocalPlane;
        request.given.planeNormal = Cross(axis, right);
        request.given.planeDistance = -1e-7;
        request.given.fStop.reset();
        request.given.aperture = 0.1;
        const Lens lens = Solved(request);
        const double x = random(-0.5, 0.5), y = random.Power(-12.0, -6.0), a = random(-0.7, 0.7);
        const auto truth = ReferenceCamera<boost::multiprecision::cpp_bin_float_50>(request.camera, request.given).Ray(x, y, a, 0.3);
        const Vec3 direction = MakeRay(lens, x, y, a, 0.3).direction;
        const Vec<boost::multiprecision::cpp_bin_float_50> found(direction);
        EXPECT_LT(double((found - truth.direction).Length() / truth.direction.Length()), 1e-14);
    }
}

TEST(Ray, IsLinearInTheFilmPointForAFixedLensPoint)
{
    // a program without lenses can then render single lens points
    ForManyCameras(2000, [](const Request&, const Lens& lens, Random& random)
    {
        const double a = random(-0.7, 0.7), b = random(-0.7, 0.7), x = random(-0.5, 0.5), y = random(-0.5, 0.5);
        const Vec3 l = a * lens.lensX + b * lens.lensY;
        const auto pinhole = [&](const Vec3& v) { return v - Dot(lens.focus, v) * l; };
        const LensRay ray = MakeRay(lens, x, y, a, b);
        const Vec3 linear = pinhole(lens.direction) + x * pinhole(lens.right) + y * pinhole(lens.up);
        EXPECT_LT(Length(ray.direction - linear), 1e-14 * Length(ray.direction));
    });
}

/// By 1/g + 1/b = 1/f through the lens centre.
Vec3 FilmPointOfLight(const Lens& lens, const Vec3& point, const Vec3& l)
{
    const double g = Dot(point, lens.normal);
    const double magnification = lens.focalLength / (g - lens.focalLength);
    const Vec3 image = -magnification * point;
    const Vec3 path = image - l;
    return l + (-lens.filmDistance - Dot(l, lens.axis)) / Dot(path, lens.axis) * path;
}

TEST(Ray, IsThePathOfLightFromSceneToFilm)
{
    ForManyCameras(8000, [](const Request&, const Lens& lens, Random& random)
    {
        const Vec3 chief = ChiefRay(lens, random(-0.4, 0.4), random(-0.4, 0.4));
        const double g = lens.focalLength * (random.Coin() ? random(1.5, 10.0) : random.Power(1.0, 5.0));
        const Vec3 point = g / Dot(chief, lens.normal) * chief;
        const Vec3 right = lens.right / Dot(lens.right, lens.right);
        for (const LensCoordinates& p : kLensPoints)
        {
            const Vec3 l = p.a * lens.lensX + p.b * lens.lensY;
            const Vec3 film = FilmPointOfLight(lens, point, l);
            const Vec3 frame = film * (-Dot(lens.direction, lens.axis) / lens.filmDistance) - lens.direction;
            const double y = Dot(frame, lens.axisUp) / Dot(lens.up, lens.axisUp);
            const double x = Dot(frame - y * lens.up, right);
            const LensRay ray = MakeRay(lens, x, y, p.a, p.b);
            EXPECT_LT(Length(ray.origin - l), 1e-15 * lens.diameter);
            EXPECT_LT(Length(Cross(Normalized(ray.direction), Normalized(point - l))), 1e-11);
            EXPECT_GT(Dot(ray.direction, point - l), 0.0);
        }
    });
}

TEST(Blur, IsTheEllipseOfTheTurnedDisc)
{
    // The film sees the turned disc from the axial image of Z. Half axes of the ellipse: v r / sqrt(1 - e^2) along the line of lens and
    // film, v r cos(theta) / (1 - e^2) across. Here e = r sin(theta) (1/s - 1/Z + 1/Z_focus).
    ForManyCameras(2000, [](const Request&, const Lens& lens, Random& random)
    {
        const double Z = lens.focalLength * random.Power(0.7, 4.0), r = lens.diameter / 2;
        const double s = lens.filmDistance, cosine = Dot(lens.normal, lens.axis);
        const double defocus = 1.0 / Z - Dot(lens.focus, lens.axis), v = std::fabs(defocus) * s;
        const double e = r * std::sqrt((1 - cosine) * (1 + cosine)) * (1.0 / s - defocus);
        if (cosine > 0.9999 || v * lens.focalLength < 1e-3 || Dot(lens.normal, Z * lens.axis) < 1.5 * lens.focalLength)
            return;
        const Vec3 shared = Normalized(Cross(lens.axis, lens.normal)), across = Cross(lens.axis, shared);
        double most = 0.0, low = 0.0, high = 0.0;
        const int steps = 720;
        for (int i = 0; i < steps; i++)
        {
            const double angle = 360.0 * kDegree * i / steps;
            const Vec3 l = std::cos(angle) * lens.lensX + std::sin(angle) * lens.lensY;
            const Vec3 film = FilmPointOfLight(lens, Z * lens.axis, l);
            most = std::max(most, Dot(film, shared));
            low = std::min(low, Dot(film, across));
            high = std::max(high, Dot(film, across));
        }
        const double shared_axis = v * r / std::sqrt(1 - e * e), across_axis = v * r * cosine / (1 - e * e);
        EXPECT_NEAR(most / shared_axis, 1.0, 2e-4) << "e = " << e;
        EXPECT_NEAR((high - low) / 2 / across_axis, 1.0, 2e-4) << "e = " << e;
    });
}

TEST(Blur, VergenceIsTheBlurOfAParallelLens)
{
    ForManyCameras(8000, [](const Request& request, const Lens&, Random& random)
    {
        Request parallel = request;
        parallel.given.family = FocusFamily::LensTurn;
        parallel.given.tilt = parallel.given.swing = 0.0;
        parallel.given.focalLength.reset();
        const Lens lens = Solve(parallel.camera, parallel.given);
        const double x = random(-0.4, 0.4), y = random(-0.4, 0.4), a = random(-0.7, 0.7), b = random(-0.7, 0.7);
        const Vec3 chief = ChiefRay(lens, x, y);
        const double T = random.Power(0.5, 4.0) * lens.focalLength / Dot(chief, lens.axis);
        const Vec3 l = a * lens.lensX + b * lens.lensY;
        const Vec3 moved = FilmPointOfLight(lens, T * chief, l) - FilmPointOfLight(lens, T * chief, {0, 0, 0});
        const double scale = lens.filmDistance / Dot(chief, lens.axis), blur = BlurVergence(lens, chief, T);
        EXPECT_LT(Length(moved - scale * blur * l), 4e-15 * scale * Length(chief));
    });
}

TEST(Blur, VergenceHasTheSignOfTheDefocusAndStaysFinite)
{
    ForManyCameras(2000, [](const Request&, const Lens& lens, Random& random)
    {
        const Vec3 chief = ChiefRay(lens, random(-0.5, 0.5), random(-0.5, 0.5));
        const double w = Dot(lens.focus, chief);
        EXPECT_EQ(BlurVergence(lens, chief, kInfinity), -w);
        if (w > 0.0)
        {
            EXPECT_GT(BlurVergence(lens, chief, 0.5 / w), 0.0);
            EXPECT_LT(BlurVergence(lens, chief, 2.0 / w), 0.0);
            EXPECT_NEAR(BlurVergence(lens, chief, 1.0 / w), 0.0, 1e-15 * w);
        }
    });
}

}  // namespace
}  // namespace tilt_lens
