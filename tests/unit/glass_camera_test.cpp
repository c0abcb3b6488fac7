// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_camera.h"

#include <cmath>
#include <map>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "tilt_lens/glass/field_aberrations.h"
#include "tilt_lens/samples/sequence.h"

namespace tilt_lens
{
namespace
{

/// Nearly ideal near its axis.
const char* const kThin = "100 1e-6 1.5 20\n-100 1e-6 1 20\n0 0 0 10\n";

/// 36 by 24 mm; 1 unit is 1 mm.
struct Camera
{
    Statement given;

    explicit Camera(const char* text)
    {
        given.prescription = std::make_shared<const Prescription>(ReadPrescription(text));
        given.sceneUnit = 1.0;
        given.focalPoint = {0.0, 0.0, 3000.0};
    }

    Camera& Tilt(double tilt, double swing = 0.0)
    {
        given.tilt = tilt;
        given.swing = swing;
        return *this;
    }
    Camera& Shift(double right, double up)
    {
        given.shiftRight = right;
        given.shiftUp = up;
        return *this;
    }
    Camera& FStop(double fStop)
    {
        given.fStop = fStop;
        return *this;
    }

    SolvedLens Solved() const { return Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given); }
    GlassCamera Made(const Aperture& aperture = Aperture::Disc(), double natural = 0.0) const
    {
        return {std::make_shared<const SolvedLens>(Solved()), aperture, natural};
    }
};

struct Named
{
    const char* name;
    Camera camera;
};

std::vector<Named> Cameras()
{
    return {{"wide open", Camera(kDoubleGauss)},
            {"f/8", Camera(kDoubleGauss).FStop(8.0)},
            {"f/64, tilted", Camera(kDoubleGauss).FStop(64.0).Tilt(6.0)},
            {"wide open, tilted", Camera(kDoubleGauss).Tilt(8.0, -3.0)},
            {"f/2.8, tilted and shifted", Camera(kDoubleGauss).FStop(2.8).Tilt(5.0).Shift(4.0, -3.0)}};
}

Passage TraceThrough(const GlassLens& lens, const Aperture& aperture, GlassRay& ray)
{
    StopPoint stop;
    const Passage passage = lens.Trace(ray, stop);
    return passage == Passage::Passed && !(aperture.Density({stop.a, stop.b}) > 0.0) ? Passage::Stopped : passage;
}

struct Counted
{
    double area = 0.0, l = 0.0, m = 0.0;
    int outside = 0, passed = 0;
};

Counted Count(const GlassCamera& camera, const GlassLens& glass, const Aperture& aperture, const FilmPoint& film, int side)
{
    const Vec3 place = camera.FilmInLens(film);
    const PupilEllipse bounds = camera.BoundsAt(film);
    const PupilPoint radial = RadialAxis(place);
    Counted counted;
    for (int i = 0; i < side; i++)
        for (int j = 0; j < side; j++)
        {
            const double a = 1.6 * (2.0 * (i + 0.5) / side - 1.0), b = 1.6 * (2.0 * (j + 0.5) / side - 1.0);
            const double along = a * bounds.radial, across = b * bounds.tangential;
            const PupilPoint at{bounds.centre.l + along * radial.l - across * radial.m,
                                bounds.centre.m + along * radial.m + across * radial.l};
            auto ray = RayTowards(place, at);
            if (!ray || TraceThrough(glass, aperture, *ray) != Passage::Passed)
                continue;
            counted.passed++;
            counted.outside += a * a + b * b > 1.0;
            counted.l += at.l;
            counted.m += at.m;
        }
    const double cell = 3.2 / side;
    counted.area = counted.passed * cell * cell * bounds.radial * bounds.tangential;
    counted.l /= std::max(1, counted.passed);
    counted.m /= std::max(1, counted.passed);
    return counted;
}

TEST(GlassCamera, ThinGlassImagesAsTheIdealLens)
{
    const Camera setting = Camera(kThin).FStop(50.0).Tilt(2.0, 1.0).Shift(0.5, -0.3);
    const SolvedLens lens = setting.Solved();
    const GlassCamera camera = setting.Made();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 300; i++)
    {
        const FilmPoint film{0.06 * part(random) - 0.03, 0.06 * part(random) - 0.03};
        const GlassSample sample = camera.Draw(film, part(random), part(random), i);
        ASSERT_NEAR(sample.weight, 1.0, 1e-12);
        const Vec3 chief = ChiefRay(lens, film), focused = chief / Dot(lens.focus, chief);
        const LensRay& ray = sample.ray;
        const double step = (1.0 - Dot(lens.focus, ray.origin)) / Dot(lens.focus, ray.direction);
        const Vec3 met = ray.origin + step * ray.direction;
        // f/50: aberrations stay below the effect of a wrong sign
        EXPECT_LT(Length(met - focused), 1e-4 * Length(focused)) << film.x << " " << film.y;
        EXPECT_NEAR(Dot(ray.direction, lens.axis), Dot(chief, lens.axis), 1e-12);
        EXPECT_NEAR(ray.w, Dot(lens.focus, chief), 1e-15);
        EXPECT_LT(Length(ray.origin), 1.1 * lens.diameter);
    }
}

TEST(GlassCamera, SamplesAllDirectionsThatPass)
{
    for (const Named& named : Cameras())
    {
        const SolvedLens lens = named.camera.Solved();
        const GlassCamera camera = named.camera.Made();
        int outside = 0, passed = 0;
        for (double x = -0.49; x < 0.5; x += 0.11)
            for (double y = -0.49; y < 0.5; y += 0.11)
                if (camera.OpenShare({x, y}) > 0.05)
                {
                    const Counted counted = Count(camera, *lens.glass, Aperture::Disc(), {x, y}, 50);
                    outside += counted.outside;
                    passed += counted.passed;
                }
        // an almost closed pupil changes too fast for the table
        EXPECT_LE(outside, 1e-4 * passed) << named.name;
    }
}

TEST(GlassCamera, BrightnessMatchesACountOfDirections)
{
    for (const Named& named : Cameras())
        for (const bool blades : {false, true})
        {
            const Aperture aperture = blades ? Aperture::Polygon(5, 0.3) : Aperture::Disc();
            const SolvedLens lens = named.camera.Solved();
            const GlassCamera camera = named.camera.Made(aperture), natural = named.camera.Made(aperture, 1.0);
            const double middle = Count(camera, *lens.glass, aperture, {0.0, 0.0}, 160).area;
            const auto falloff = [&](const FilmPoint& film)
            {
                const Vec3 direction = Normalized(camera.MiddleRay(film)->direction);
                return std::fabs(Dot(direction, lens.axis) / Dot(direction, lens.normal));
            };
            for (const FilmPoint& film : {FilmPoint{0.31, 0.12}, FilmPoint{-0.44, 0.2}, FilmPoint{0.1, -0.47}, FilmPoint{-0.3, 0.3}})
            {
                const double counted = Count(camera, *lens.glass, aperture, film, 160).area / middle;
                const double turned = falloff(film) / falloff({0.0, 0.0});
                EXPECT_NEAR(natural.Brightness(film), counted * turned, 0.015)
                    << named.name << " " << film.x << " " << film.y << " " << blades;
            }
        }
}

TEST(GlassCamera, DrawsDirectionsUniformly)
{
    for (const Named& named : Cameras())
    {
        const SolvedLens lens = named.camera.Solved();
        const GlassCamera camera = named.camera.Made();
        const FilmPoint film{0.37, -0.28};
        const Counted counted = Count(camera, *lens.glass, Aperture::Disc(), film, 160);
        const PixelSampler sequence(3, 5, 0);
        double x = 0.0, y = 0.0;
        const int samples = 4096;
        for (int i = 0; i < samples; i++)
        {
            const SequencePoint point = sequence(i);
            const GlassSample sample = camera.Draw(film, point.lensU, point.lensV, sequence.Hash(i));
            ASSERT_GT(sample.weight, 0.0);
            const Vec3 axes[3] = {Normalized(lens.lensX), Normalized(lens.lensY), lens.normal};
            const auto inLens = [&](const Vec3& v) { return Vec3{Dot(v, axes[0]), Dot(v, axes[1]), Dot(v, axes[2])}; };
            GlassRay ray{inLens(sample.ray.origin), -Normalized(inLens(sample.ray.direction))};
            ray.origin = ray.origin - 5.0 * ray.direction;
            StopPoint stop;
            ASSERT_EQ(lens.glass->TraceFromScene(ray, stop), Passage::Passed);
            x -= ray.direction.x / samples;
            y -= ray.direction.y / samples;
        }
        const double size = camera.BoundsAt(film).radial;
        EXPECT_NEAR(x, counted.l, 0.01 * size) << named.name;
        EXPECT_NEAR(y, counted.m, 0.01 * size) << named.name;
    }
}

TEST(GlassCamera, DrawsFourAsOneByOne)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    int refused = 0;
    for (const Named& named : Cameras())
        for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(5, 0.3)})
        {
            const GlassCamera camera = named.camera.Made(aperture, 0.7);
            for (unsigned int group = 0; group < 300; group++)
            {
                FourGlassPoints points;
                for (int i = 0; i < 4; i++)
                {
                    points.x[i] = 1.1 * part(random) - 0.55, points.y[i] = 1.1 * part(random) - 0.55;
                    points.u[i] = part(random), points.v[i] = part(random);
                    points.seed[i] = 4 * group + i;
                }
                points.wanted = group % 16;
                FourGlassSamples samples;
                camera.Draw(points, samples);
                for (int i = 0; i < 4; i++)
                {
                    if ((points.wanted >> i & 1u) == 0)
                    {
                        EXPECT_EQ(samples.weight[i], 0.0);
                        EXPECT_EQ(samples.refused[i], 0u);
                        continue;
                    }
                    const GlassSample one = camera.Draw({points.x[i], points.y[i]}, points.u[i], points.v[i], points.seed[i]);
                    ASSERT_EQ(samples.weight[i], one.weight) << named.name;
                    EXPECT_EQ(samples.refused[i], one.refused);
                    refused += one.refused;
                    EXPECT_EQ(samples.w[i], one.ray.w);
                    const Vec3 &origin = one.ray.origin, &direction = one.ray.direction;
                    const double numbers[3][2] = {{origin.x, direction.x}, {origin.y, direction.y}, {origin.z, direction.z}};
                    for (int axis = 0; axis < 3; axis++)
                    {
                        EXPECT_EQ(samples.origin[axis][i], numbers[axis][0]);
                        EXPECT_EQ(samples.direction[axis][i], numbers[axis][1]);
                    }
                }
            }
        }
    EXPECT_GT(refused, 300);
}

TEST(GlassCamera, DrawsThePointOfTheEllipse)
{
    const Aperture disc = Aperture::Disc();
    std::mt19937 random(5);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (const Named& named : Cameras())
    {
        const SolvedLens lens = named.camera.Solved();
        const GlassCamera camera = named.camera.Made();
        const Vec3 axisX = Normalized(lens.lensX), axisY = Normalized(lens.lensY);
        int compared = 0;
        for (int i = 0; i < 300; i++)
        {
            const FilmPoint film{part(random) - 0.5, part(random) - 0.5};
            const double u = part(random), v = part(random);
            const GlassSample sample = camera.Draw(film, u, v, i);
            if (sample.weight == 0.0 || sample.refused != 0)
                continue;
            compared++;
            const Vec3 place = camera.FilmInLens(film);
            const PupilEllipse bounds = camera.BoundsAt(film);
            const PupilPoint axis = RadialAxis(place);
            const AperturePoint point = disc(u, v);
            const double along = bounds.radial * point.a, across = bounds.tangential * point.b;
            auto ray = RayTowards(place,
                                  {bounds.centre.l + along * axis.l - across * axis.m, bounds.centre.m + along * axis.m + across * axis.l});
            ASSERT_TRUE(ray);
            ASSERT_EQ(TraceThrough(*lens.glass, disc, *ray), Passage::Passed);
            const auto world = [&](const Vec3& a) { return a.x * axisX + a.y * axisY + a.z * lens.normal; };
            EXPECT_LT(Length(sample.ray.origin - lens.millimetre * world(ray->origin)), 1e-12 * lens.millimetre) << named.name;
            EXPECT_LT(Length(Normalized(sample.ray.direction) - world(ray->direction)), 1e-13) << named.name;
            EXPECT_NEAR(sample.weight, camera.Brightness(film), 1e-15);
        }
        EXPECT_GT(compared, 100) << named.name;
    }
}

TEST(GlassCamera, BlocksFewRays)
{
    for (const Named& named : Cameras())
    {
        const GlassCamera camera = named.camera.Made();
        std::uint64_t refused = 0, lit = 0;
        for (int x = 0; x < 60; x++)
            for (int y = 0; y < 40; y++)
            {
                const PixelSampler sequence(x, y, 0);
                const SequencePoint point = sequence(0);
                const GlassSample sample = camera.Draw(FilmPointAt(x + point.pixelX, y + point.pixelY, 60, 40), point.lensU, point.lensV,
                                                       sequence.Hash(0));
                refused += sample.weight > 0.0 ? sample.refused : 0;
                lit += sample.weight > 0.0;
            }
        EXPECT_LT(double(refused), 0.25 * double(lit)) << named.name;
    }
}

TEST(GlassCamera, IsAsBrightInItsMiddleAndSymmetric)
{
    const GlassCamera camera = Camera(kDoubleGauss).Made();
    EXPECT_EQ(camera.Brightness({0.0, 0.0}), 1.0);
    EXPECT_EQ(Camera(kDoubleGauss).Tilt(8.0).Made(Aperture::Disc(), 1.0).Brightness({0.0, 0.0}), 1.0);
    for (const FilmPoint& film : {FilmPoint{0.3, 0.2}, FilmPoint{0.45, 0.4}})
        for (const double right : {1.0, -1.0})
            for (const double up : {1.0, -1.0})
                EXPECT_NEAR(camera.Brightness({right * film.x, up * film.y}), camera.Brightness(film), 2e-4);
    const GlassCamera stopped = Camera(kDoubleGauss).FStop(11.0).Made();
    for (const FilmPoint& film : {FilmPoint{0.5, 0.5}, FilmPoint{-0.21, 0.4}})
        EXPECT_EQ(stopped.Brightness(film), 1.0);
}

TEST(GlassCamera, HasNoRings)
{
    const GlassCamera camera = Camera(kDoubleGauss).Made();
    const double step = 0.002;
    double before = camera.Brightness({0.0, 0.0}), last = camera.Brightness({step, 0.6 * step});
    for (double x = 2.0 * step; x < 0.5; x += step)
    {
        const double now = camera.Brightness({x, 0.6 * x});
        EXPECT_LT(std::fabs(now - 2.0 * last + before), 2e-3) << x;
        before = last;
        last = now;
    }
}

TEST(GlassCamera, IsTheSameEveryTime)
{
    const GlassCamera first = Camera(kDoubleGauss).Tilt(3.0).Made(), second = Camera(kDoubleGauss).Tilt(3.0).Made();
    const GlassSample a = first.Draw({0.4, 0.3}, 0.95, 0.02, 7), b = second.Draw({0.4, 0.3}, 0.95, 0.02, 7);
    EXPECT_EQ(a.ray.origin.x, b.ray.origin.x);
    EXPECT_EQ(a.ray.direction.y, b.ray.direction.y);
    EXPECT_EQ(a.refused, b.refused);
}

TEST(GlassCamera, ScalesWithTheScene)
{
    Camera small(kDoubleGauss), large(kDoubleGauss);
    large.given.sceneUnit = 0.001;
    large.given.focalPoint = 1000.0 * small.given.focalPoint;
    const GlassSample a = small.Made().Draw({0.2, 0.1}, 0.4, 0.6, 1), b = large.Made().Draw({0.2, 0.1}, 0.4, 0.6, 1);
    EXPECT_NEAR(Length(b.ray.origin - 1000.0 * a.ray.origin), 0.0, 1e-7);
    EXPECT_NEAR(Length(Normalized(b.ray.direction) - Normalized(a.ray.direction)), 0.0, 1e-12);
}

TEST(GlassCamera, RefusesABlockedCentre)
{
    const auto message = [](const Camera& camera)
    {
        try
        {
            camera.Made();
        }
        catch (const std::exception& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_NE(message(Camera(kDoubleGauss).FStop(1.4)).find("open to f/2.01"), std::string::npos);
    EXPECT_EQ(message(Camera(kDoubleGauss).FStop(2.018)), "");
    EXPECT_NE(message(Camera(kDoubleGauss).Shift(80.0, 0.0)).find("image circle"), std::string::npos);
    EXPECT_NE(message(Camera(kDoubleGauss).Tilt(60.0)), "");
    Camera buried("50 5 1.5 20\n-50 2 1 20\n0 60 0 5\n60 3 1.5 20\n0 0 1 20\n");
    EXPECT_NE(message(buried).find("within the glass"), std::string::npos) << message(buried);
}

TEST(FieldAberrations, MatchAThinLens)
{
    const GlassLens lens(ReadPrescription(kThin));
    const double f = lens.Cardinal().focalLength, height = 1.0, n = 1.5;
    const auto field = FieldAberrationsOf(lens, f, height);
    ASSERT_TRUE(field.has_value());
    EXPECT_NEAR(field->distortion, 0.0, 1e-6);
    EXPECT_NEAR(field->sagittal, 0.5 * height * height * (1.0 + 1.0 / n) / f, 1e-5);
    EXPECT_NEAR(field->tangential, 0.5 * height * height * (3.0 + 1.0 / n) / f, 1e-5);
    EXPECT_FALSE(FieldAberrationsOf(GlassLens(ReadPrescription(kDoubleGauss)), 50.0, 200.0).has_value());
}

} // namespace
} // namespace tilt_lens
