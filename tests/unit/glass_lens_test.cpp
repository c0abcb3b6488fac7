// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"
#include "double_gauss_rows.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

PrescriptionRow Row(double radius, double thickness, double index, double diameter)
{
    PrescriptionRow row;
    row.radius = radius;
    row.thickness = thickness;
    row.index = index;
    row.diameter = diameter;
    return row;
}

/// `stopBefore`: mm from the stop to the lens.
Prescription Singlet(double first, double second, double thickness, double index, double stopBefore = 1.0, double diameter = 20.0)
{
    Prescription lens;
    lens.rows = {Row(0.0, stopBefore, 1.0, 8.0), Row(first, thickness, index, diameter), Row(second, 0.0, 1.0, diameter)};
    return lens;
}

Prescription DoubleGauss()
{
    return ReadPrescription(kDoubleGauss);
}

Prescription Aspheric()
{
    Prescription lens = Singlet(30.0, -45.0, 6.0, 1.6, 2.0, 16.0);
    lens.rows[1].conic = -0.7;
    lens.rows[2].aspheric = {2e-5, -3e-8};
    return lens;
}

Vec3 Towards(const Vec3& from, const Vec3& to)
{
    return Normalized(to - from);
}

Vec3 At(const GlassRay& ray, double z)
{
    return ray.origin + ((z - ray.origin.z) / ray.direction.z) * ray.direction;
}

TEST(CardinalPoints, MatchAThickLens)
{
    const double a = 40.0, b = -60.0, d = 7.0, n = 1.55;
    const CardinalPoints points = GlassLens(Singlet(a, b, d, n)).Cardinal();
    const double f = 1.0 / ((n - 1.0) * (1.0 / a - 1.0 / b + (n - 1.0) * d / (n * a * b)));
    const double front = -f * (n - 1.0) * d / (n * b), rear = -f * (n - 1.0) * d / (n * a);
    EXPECT_NEAR(points.focalLength, f, 1e-12 * f);
    EXPECT_NEAR(points.frontVertex - 1.0, front, 1e-12);
    EXPECT_NEAR(points.separation, d + rear - front, 1e-12);
    EXPECT_NEAR(points.backFocus, f + rear, 1e-12);
}

TEST(CardinalPoints, MatchAThinLensAndABall)
{
    const CardinalPoints thin = GlassLens(Singlet(50.0, -50.0, 1e-9, 1.5)).Cardinal();
    EXPECT_NEAR(thin.focalLength, 50.0, 1e-8);
    EXPECT_NEAR(thin.separation, 0.0, 1e-8);
    const CardinalPoints ball = GlassLens(Singlet(10.0, -10.0, 20.0, 1.5)).Cardinal();
    EXPECT_NEAR(ball.focalLength, 1.5 * 10.0 / (2.0 * 0.5), 1e-12);
    EXPECT_NEAR(ball.separation, 0.0, 1e-12);
    EXPECT_NEAR(ball.frontVertex, 11.0, 1e-12);
}

TEST(CardinalPoints, PupilsAreImagesOfTheStop)
{
    const GlassLens lens(Singlet(50.0, -50.0, 1e-9, 1.5, 20.0));
    const CardinalPoints& points = lens.Cardinal();
    EXPECT_NEAR(points.entrancePupil, 20.0, 1e-6);
    EXPECT_NEAR(points.entranceRadius, 1.0, 1e-12);
    EXPECT_NEAR(points.fNumber, 50.0 / 8.0, 1e-8);
    EXPECT_NEAR(1.0 / points.exitPupil, 1.0 / 20.0 - 1.0 / 50.0, 1e-8);  // 1/image = 1/f - 1/object
    EXPECT_NEAR(points.exitMagnification, 50.0 / 30.0, 1e-8);
    // a stop in the front focal point makes a lens telecentric
    EXPECT_GT(std::fabs(GlassLens(Singlet(50.0, -50.0, 1e-9, 1.5, 50.0)).Cardinal().exitPupil), 1e6);
}

TEST(CardinalPoints, NarrowestRimLimitsTheFNumber)
{
    Prescription lens = Singlet(50.0, -50.0, 1e-9, 1.5);
    lens.rows[1].diameter = 5.0;
    EXPECT_NEAR(GlassLens(lens).Cardinal().fNumber, 10.0, 1e-8);
}

TEST(CardinalPoints, RefusesALensThatDoesNotCollect)
{
    EXPECT_THROW(GlassLens(Singlet(-50.0, 50.0, 2.0, 1.5)), PrescriptionError);
    EXPECT_THROW(GlassLens(Singlet(0.0, 0.0, 2.0, 1.5)), PrescriptionError);
}

TEST(GlassLens, ApproachesTheParaxialLimit)
{
    for (const Prescription& prescription : {DoubleGauss(), Aspheric(), Singlet(40.0, -60.0, 7.0, 1.55)})
    {
        const GlassLens lens(prescription);
        const CardinalPoints& points = lens.Cardinal();
        const double film = -points.separation - points.focalLength, height = 1e-3;
        StopPoint stop;
        GlassRay ray{{0.0, 0.0, film}, Towards({0.0, 0.0, film}, {height, 0.0, -points.separation})};
        ASSERT_EQ(lens.Trace(ray, stop), Passage::Passed);
        EXPECT_NEAR(ray.direction.x, 0.0, 1e-6 * height / points.focalLength);
        EXPECT_NEAR(ray.origin.x, height, 1e-6 * height);
        ray = {{height, 0.0, film}, Towards({height, 0.0, film}, {0.0, 0.0, -points.separation})};
        const Vec3 before = ray.direction;
        ASSERT_EQ(lens.Trace(ray, stop), Passage::Passed);
        EXPECT_NEAR(ray.direction.x, before.x, 1e-6 * std::fabs(before.x));
        EXPECT_NEAR(At(ray, 0.0).x, 0.0, 1e-6 * height);
        ray = {{height, 0.0, film}, Towards({height, 0.0, film}, {0.0, 0.0, points.exitPupil})};
        if (ray.direction.z < 0.0)
            ray.direction = -ray.direction;
        ASSERT_EQ(lens.Trace(ray, stop), Passage::Passed);
        EXPECT_NEAR(stop.a, 0.0, 1e-6 * height);
        EXPECT_NEAR(At(ray, points.entrancePupil).x, 0.0, 1e-6 * height);
    }
}

TEST(GlassLens, HyperboloidFocusesParallelLight)
{
    // conic constant -n^2
    const double n = 1.5;
    Prescription prescription = Singlet(0.0, -30.0, 8.0, n, 1.0, 50.0);
    prescription.rows[0].diameter = 60.0;
    prescription.rows[2].conic = -n * n;
    const GlassLens lens(prescription);
    const Vec3 focus{0.0, 0.0, -lens.Cardinal().separation - lens.Cardinal().focalLength};
    EXPECT_NEAR(lens.Cardinal().focalLength, 60.0, 1e-12);
    for (const double height : {0.1, 5.0, 15.0, 24.0})
    {
        GlassRay ray{{height, 0.3 * height, 100.0}, {0.0, 0.0, -1.0}};
        StopPoint stop;
        ASSERT_EQ(lens.TraceFromScene(ray, stop, false), Passage::Passed);
        EXPECT_NEAR(At(ray, focus.z).x, 0.0, 1e-11);
        EXPECT_NEAR(At(ray, focus.z).y, 0.0, 1e-11);
    }
}

TEST(GlassLens, SphereHasAplanaticPoints)
{
    // rays aimed n R behind the centre meet R/n behind it
    const double n = 1.6, R = 20.0;
    Prescription prescription;
    prescription.rows = {Row(0.0, 1.0, 1.0, 200.0), Row(R, 50.0, n, 40.0), Row(0.0, 0.0, 1.0, 200.0)};
    const GlassLens lens(prescription);
    const double centre = lens.Cardinal().frontVertex - 1.0 - R;
    for (const double angle : {0.05, 0.2, 0.4})
    {
        const Vec3 aim{0.0, 0.0, centre - n * R}, direction{-std::sin(angle), 0.0, -std::cos(angle)};
        GlassRay ray{aim - 100.0 * direction, direction};
        StopPoint stop;
        ASSERT_EQ(lens.TraceFromScene(ray, stop, false), Passage::Passed);
        const double planeZ = lens.Cardinal().rearVertex, sine = -ray.direction.x / n;
        const double x = ray.origin.x + (centre - R / n - planeZ) * (sine / std::sqrt(1.0 - sine * sine));
        EXPECT_NEAR(x, 0.0, 1e-11) << angle;
    }
}

TEST(GlassLens, FollowsSnellsLawAtAnAsphere)
{
    Prescription prescription;
    prescription.rows = {Row(0.0, 5.0, 1.0, 60.0), Row(25.0, 400.0, 1.7, 20.0), Row(0.0, 0.0, 1.0, 500.0)};
    prescription.rows[1].conic = -1.3;
    prescription.rows[1].aspheric = {3e-5, -4e-8, 1e-11};
    const GlassLens lens(prescription);
    const double vertex = lens.Cardinal().frontVertex - 5.0;
    const auto sag = [](double h)
    {
        const double square = h * h, c = 1.0 / 25.0;
        return c * square / (1.0 + std::sqrt(1.0 + 0.3 * c * c * square)) + 3e-5 * std::pow(h, 4) - 4e-8 * std::pow(h, 6) +
               1e-11 * std::pow(h, 8);
    };
    const double x = 7.0, y = -4.0, h = std::hypot(x, y), step = 1e-4;
    const double slope = (sag(h + step) - sag(h - step)) / (2.0 * step);
    const Vec3 point{x, y, vertex - sag(h)}, normal = Normalized(Vec3{slope * x / h, slope * y / h, 1.0});
    const Vec3 in = Normalized(Vec3{-0.2, 0.1, -1.0});
    const double ratio = 1.0 / 1.7, cosine = -Dot(in, normal);
    Vec3 expected = ratio * in + (ratio * cosine - std::sqrt(1.0 - ratio * ratio * (1.0 - cosine * cosine))) * normal;
    expected.x *= 1.7;
    expected.y *= 1.7;
    expected.z = -std::sqrt(1.0 - expected.x * expected.x - expected.y * expected.y);
    GlassRay ray{point - 30.0 * in, in};
    StopPoint stop;
    ASSERT_EQ(lens.TraceFromScene(ray, stop, false), Passage::Passed);
    EXPECT_NEAR(ray.direction.x, expected.x, 1e-9);
    EXPECT_NEAR(ray.direction.y, expected.y, 1e-9);
}

TEST(GlassLens, RaysAreReversible)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    for (const Prescription& prescription : {DoubleGauss(), Aspheric()})
    {
        const GlassLens lens(prescription);
        const double film = -lens.Cardinal().separation - 1.1 * lens.Cardinal().focalLength;
        int passed = 0;
        for (int i = 0; i < 2000; i++)
        {
            const Vec3 from{15.0 * part(random), 10.0 * part(random), film};
            GlassRay ray{from, Towards(from, {12.0 * part(random), 12.0 * part(random), lens.Cardinal().rearVertex})};
            const Vec3 direction = ray.direction;
            StopPoint stop, back;
            if (lens.Trace(ray, stop) != Passage::Passed)
                continue;
            passed++;
            EXPECT_NEAR(Length(ray.direction), 1.0, 1e-14);
            ray = {ray.origin + 20.0 * ray.direction, -ray.direction};
            ASSERT_EQ(lens.TraceFromScene(ray, back), Passage::Passed);
            EXPECT_NEAR(back.a, stop.a, 1e-11);
            EXPECT_NEAR(back.b, stop.b, 1e-11);
            EXPECT_NEAR(Length(ray.direction + direction), 0.0, 1e-11);
            EXPECT_NEAR(Length(At(ray, film) - from), 0.0, 1e-9);
        }
        EXPECT_GT(passed, 100);
    }
}

/// @param more  added to the index of each glass
Prescription WithGlassOf(Prescription prescription, double more)
{
    for (PrescriptionRow& row : prescription.rows)
        if (row.index != 1.0)
            row.index += more;
    return prescription;
}

TEST(GlassLens, TracesFourSideBySideAsOneByOne)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    for (const Prescription& prescription : {DoubleGauss(), Aspheric(), Singlet(20.0, -20.0, 18.0, 1.9, 1.0, 38.0)})
    {
        const GlassLens lens(prescription);
        std::array<GlassLens, 4> colours{lens, lens, lens, lens};
        for (int i = 0; i < 4; i++)
            colours[i].TakeIndices(WithGlassOf(prescription, 0.02 * i));
        const double film = -lens.Cardinal().separation - 1.1 * lens.Cardinal().focalLength;
        int passed = 0, ended = 0;
        for (int group = 0; group < 1000; group++)
        {
            FourGlassRays four;
            FourStopPoints stops;
            GlassRay rays[4];
            for (int i = 0; i < 4; i++)
            {
                const Vec3 from{15.0 * part(random), 10.0 * part(random), film};
                rays[i] = {from, Towards(from, {12.0 * part(random), 12.0 * part(random), lens.Cardinal().rearVertex})};
                four.origin[0][i] = from.x, four.origin[1][i] = from.y, four.origin[2][i] = from.z;
                const Vec3& direction = rays[i].direction;
                four.direction[0][i] = direction.x, four.direction[1][i] = direction.y, four.direction[2][i] = direction.z;
            }
            const bool coloured = group % 2 == 1;
            const unsigned int passes = coloured ? GlassLens::Trace({&colours[0], &colours[1], &colours[2], &colours[3]}, four, stops)
                                                 : lens.Trace(four, stops);
            for (int i = 0; i < 4; i++)
            {
                StopPoint stop;
                const bool expected = (coloured ? colours[i] : lens).Trace(rays[i], stop) == Passage::Passed;
                ASSERT_EQ((passes >> i & 1u) != 0, expected);
                (expected ? passed : ended)++;
                if (!expected)
                    continue;
                EXPECT_EQ(four.origin[0][i], rays[i].origin.x);
                EXPECT_EQ(four.origin[1][i], rays[i].origin.y);
                EXPECT_EQ(four.origin[2][i], rays[i].origin.z);
                EXPECT_EQ(four.direction[0][i], rays[i].direction.x);
                EXPECT_EQ(four.direction[1][i], rays[i].direction.y);
                EXPECT_EQ(four.direction[2][i], rays[i].direction.z);
                EXPECT_EQ(stops.a[i], stop.a);
                EXPECT_EQ(stops.b[i], stop.b);
            }
        }
        EXPECT_GT(passed, 100);
        EXPECT_GT(ended, 100);
    }
}

TEST(GlassLens, ReportsTheFateOfARay)
{
    const GlassLens lens(Singlet(20.0, -20.0, 18.0, 1.9, 1.0, 38.0));
    const double rear = lens.Cardinal().rearVertex;
    StopPoint stop;
    GlassRay ray{{0.0, 0.0, rear - 10.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(lens.Trace(ray, stop), Passage::Passed);
    EXPECT_EQ(stop.a, 0.0);
    ray = {{30.0, 0.0, rear - 10.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(lens.Trace(ray, stop), Passage::Missed);
    ray = {{19.5, 0.0, rear - 10.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(lens.Trace(ray, stop), Passage::Rim);
    ray = {{0.0, 0.0, rear - 10.0}, Normalized(Vec3{0.8, 0.0, 1.0})};
    EXPECT_EQ(lens.Trace(ray, stop), Passage::Stopped);
    EXPECT_GT(stop.a, 1.0);
    Prescription flat;
    flat.rows = {Row(0.0, 30.0, 1.8, 100.0), Row(-20.0, 1.0, 1.0, 38.0), Row(0.0, 0.0, 1.0, 38.0)};
    flat.stop = 2;
    const GlassLens plane(flat);
    ray = {{18.9, 0.0, plane.Cardinal().rearVertex - 1.0}, {0.0, 0.0, 1.0}};
    EXPECT_EQ(plane.Trace(ray, stop), Passage::Reflected);
}

TEST(GlassLens, StopsDown)
{
    GlassLens lens(DoubleGauss());
    EXPECT_NEAR(lens.Cardinal().focalLength, 50.0, 0.5);
    EXPECT_NEAR(lens.Cardinal().fNumber, 2.0, 0.02);
    for (const double fNumber : {8.0, 2.8, 2.1})
    {
        lens.StopDown(fNumber);
        double widest = 0.0;
        for (double height = 0.0; height < 13.0; height += 1e-3)
        {
            GlassRay ray{{height, 0.0, 100.0}, {0.0, 0.0, -1.0}};
            StopPoint stop;
            if (lens.TraceFromScene(ray, stop) == Passage::Passed)
                widest = height;
        }
        EXPECT_NEAR(widest, 0.5 * lens.Cardinal().focalLength / fNumber, 1.1e-3) << fNumber;
    }
    lens.StopDown(1.5);
    EXPECT_EQ(lens.StopRadius(), 0.5 * 17.1);
}

TEST(GlassLens, FrontBoxContainsTheFirstSurface)
{
    const GlassLens lens(DoubleGauss());
    const GlassLens::Front box = lens.FrontBox();
    EXPECT_EQ(box.radius, 12.6);
    for (int i = -20; i <= 20; i++)
    {
        const double film = -lens.Cardinal().separation - lens.Cardinal().focalLength;
        const Vec3 from{0.5 * i, 0.0, film};
        GlassRay ray{from, Towards(from, {0.6 * i, 0.0, lens.Cardinal().rearVertex})};
        StopPoint stop;
        if (lens.Trace(ray, stop) != Passage::Passed)
            continue;
        EXPECT_LE(std::hypot(ray.origin.x, ray.origin.y), box.radius);
        EXPECT_GE(ray.origin.z, box.low);
        EXPECT_LE(ray.origin.z, box.high);
    }
}

} // namespace
} // namespace tilt_lens
