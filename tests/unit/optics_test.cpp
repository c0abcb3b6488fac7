// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Checks textbook laws; repeats no formula of the library.

#include "tilt_lens/camera/optics.h"

#include <tuple>

#include <gtest/gtest.h>

#include "random_cameras.h"

namespace tilt_lens
{
namespace
{

const int kRequests = 1000;

Vec3 CameraPart(const Lens& lens, const Vec3& v)
{
    return {Dot(v, lens.axisRight), Dot(v, lens.axisUp), Dot(v, lens.axis)};
}

double AngleBetween(const Vec3& a, const Vec3& b)
{
    return std::atan2(Length(Cross(a, b)), Dot(a, b));
}

class EveryFamily : public testing::TestWithParam<std::tuple<FocusFamily, bool>>
{
  protected:
    template<typename Check>
    void ForMany(Check check)
    {
        Random random(1);
        for (int i = 0; i < kRequests; i++)
        {
            Lens lens;
            const Request request = SolvableRequest(random, std::get<0>(GetParam()), std::get<1>(GetParam()), lens);
            SCOPED_TRACE(testing::Message() << request);
            check(request, lens);
            if (HasFailure())
                return;
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Optics, EveryFamily,
                         testing::Combine(testing::Values(FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane,
                                                          FocusFamily::FocalPoints),
                                          testing::Bool()));

TEST_P(EveryFamily, AxesAndNormalAreUnitVectors)
{
    ForMany([](const Request& request, const Lens& lens)
    {
        const double tolerance = 1e-15;
        EXPECT_NEAR(Length(lens.axisRight), 1.0, tolerance);
        EXPECT_NEAR(Length(lens.axisUp), 1.0, tolerance);
        EXPECT_NEAR(Length(lens.axis), 1.0, tolerance);
        EXPECT_NEAR(Length(lens.normal), 1.0, tolerance);
        EXPECT_NEAR(Dot(lens.axisRight, lens.axisUp), 0.0, tolerance);
        EXPECT_NEAR(Dot(lens.axisRight, lens.axis), 0.0, tolerance);
        EXPECT_NEAR(Dot(lens.axisUp, lens.axis), 0.0, tolerance);
        EXPECT_GT(Dot(lens.axisRight, request.camera.right), 0.0);
        EXPECT_GT(Dot(lens.axisUp, request.camera.up), 0.0);
        EXPECT_GT(Dot(lens.axis, request.camera.direction), 0.0);
        EXPECT_GT(Dot(lens.normal, lens.axis), 0.0);
    });
}

TEST_P(EveryFamily, LengthsAndFrameAreAsStated)
{
    ForMany([](const Request& request, const Lens& lens)
    {
        const Statement& s = request.given;
        const double film = s.filmWidth / s.sceneUnit, width = Length(request.camera.right);
        if (s.focalLength)
        {
            EXPECT_DOUBLE_EQ(lens.focalLength, *s.focalLength / s.sceneUnit);
        }
        else
        {
            EXPECT_NEAR(Dot(lens.direction, lens.axis), Dot(request.camera.direction, lens.axis), 1e-15 * width * 8);
        }
        EXPECT_NEAR(Dot(lens.direction, lens.axis) / width * film / lens.filmDistance, 1.0, 4e-15);
        const Vec3 moved = CameraPart(lens, lens.direction - request.camera.direction) * (film / width * s.sceneUnit);
        EXPECT_NEAR(moved.x, s.shiftRight, 1e-14 * s.filmWidth);
        EXPECT_NEAR(moved.y, s.shiftUp, 1e-14 * s.filmWidth);
        EXPECT_EQ(Length(lens.right - request.camera.right), 0.0);
        EXPECT_EQ(Length(lens.up - request.camera.up), 0.0);
        EXPECT_DOUBLE_EQ(lens.millimetre, 1.0 / s.sceneUnit);
        EXPECT_DOUBLE_EQ(lens.diameter, s.fStop ? lens.focalLength / *s.fStop : s.aperture / 2);
    });
}

TEST_P(EveryFamily, FocusIsAsStated)
{
    ForMany([](const Request& request, const Lens& lens)
    {
        const Statement& s = request.given;
        const auto sharp = [&](const Vec3& world) { return Dot(lens.focus, world - request.camera.location); };
        const double tolerance = 1e-12;
        const Vec3 n = CameraPart(lens, lens.focus);
        switch (s.family)
        {
            case FocusFamily::LensTurn:
                EXPECT_NEAR(sharp(s.focalPoint), 1.0, tolerance);
                EXPECT_NEAR(TiltOf(lens), s.tilt, tolerance);
                EXPECT_NEAR(SwingOf(lens), s.swing, tolerance);
                break;
            case FocusFamily::FocusTurn:
                EXPECT_NEAR(sharp(s.focalPoint), 1.0, tolerance);
                EXPECT_NEAR(-n.y / n.z, std::tan(s.focusTilt * kDegree), tolerance);
                EXPECT_NEAR(-n.x / n.z, std::tan(s.focusSwing * kDegree), tolerance);
                break;
            case FocusFamily::FocalPlane:
                EXPECT_NEAR(sharp(s.planeDistance / Length(s.planeNormal) * s.planeNormal), 1.0,
                            tolerance * (1.0 + 20.0 * Length(lens.focus)));
                EXPECT_LT(Length(Cross(Normalized(lens.focus), Normalized(s.planeNormal))), tolerance);
                break;
            case FocusFamily::FocalPoints:
                for (const Vec3& point : s.points)
                    EXPECT_NEAR(sharp(point), 1.0, tolerance * (1.0 + 20.0 * Length(lens.focus)));
                break;
            case FocusFamily::SharpPoints: break;
        }
    });
}

TEST_P(EveryFamily, ThinLensEquationHoldsAlongTheLensNormal)
{
    Random random(2);
    ForMany([&](const Request&, const Lens& lens)
    {
        const Vec3 chief = lens.direction + random(-0.5, 0.5) * lens.right + random(-0.5, 0.5) * lens.up;
        const double objectVergence = Dot(lens.focus, chief) / Dot(lens.normal, chief);
        const Vec3 film = -lens.filmDistance / Dot(chief, lens.axis) * chief;
        const double imageVergence = -1.0 / Dot(lens.normal, film);
        EXPECT_NEAR((objectVergence + imageVergence) * lens.focalLength, 1.0, 1e-13);
    });
}

TEST_P(EveryFamily, LensFilmAndFocusShareALine)
{
    Random random(3);
    ForMany([&](const Request&, const Lens& lens)
    {
            // the line of film and lens: z = -s, t.X = 0
        const Vec3 t = CameraPart(lens, lens.normal), k = CameraPart(lens, lens.focus);
        const double across = std::hypot(t.x, t.y), s = lens.filmDistance;
        if (across < 1e-3)
            return;
        const double out = s * t.z / (across * across);
        for (const double along : {-1.0, 0.0, 1.0})
        {
            const Vec3 point{out * t.x - along * s * t.y / across, out * t.y + along * s * t.x / across, -s};
            EXPECT_NEAR(Dot(t, point) / Length(point), 0.0, 1e-14);
            EXPECT_NEAR(Dot(k, point), 1.0, 4e-15 * (Length(k) + 1.0 / lens.focalLength) * Length(point));
        }
    });
}

TEST_P(EveryFamily, ObeysTheHingeRule)
{
    ForMany([](const Request& request, const Lens& lens)
    {
        const double turn = AngleBetween(lens.normal, lens.axis);
        EXPECT_NEAR(HingeDistanceOf(lens) * std::sin(turn) / lens.focalLength, 1.0, 4e-15 / std::sin(turn));
        // the hinge line lies in the plane of sharp focus and in the plane through the lens parallel to the film
        const Vec3 t = CameraPart(lens, lens.normal), k = CameraPart(lens, lens.focus);
        const double across = std::hypot(t.x, t.y);
        const Vec3 foot{HingeDistanceOf(lens) * t.x / across, HingeDistanceOf(lens) * t.y / across, 0.0};
        EXPECT_NEAR(Dot(k, foot), 1.0, 1e-12);
        if (request.given.family == FocusFamily::LensTurn)
        {
            EXPECT_LT(foot.y * request.given.tilt, 0.0);
            EXPECT_LT(foot.x * request.given.swing, 0.0);
        }
    });
}

TEST_P(EveryFamily, LensCoordinatesSpanTheTurnedDisc)
{
    ForMany([](const Request&, const Lens& lens)
    {
        const double radius = lens.diameter / 2, tolerance = 4e-15;
        EXPECT_NEAR(Length(lens.lensX) / radius, 1.0, tolerance);
        EXPECT_NEAR(Length(lens.lensY) / radius, 1.0, tolerance);
        EXPECT_NEAR(Dot(lens.lensX, lens.lensY) / (radius * radius), 0.0, tolerance);
        EXPECT_NEAR(Dot(lens.lensX, lens.normal) / radius, 0.0, tolerance);
        EXPECT_NEAR(Dot(lens.lensY, lens.normal) / radius, 0.0, tolerance);
        // the smallest rotation keeps the line common to film and lens
        const Vec3 t = CameraPart(lens, lens.normal), x = CameraPart(lens, lens.lensX), y = CameraPart(lens, lens.lensY);
        EXPECT_NEAR((-t.y * x.x + t.x * x.y) / radius, -t.y, tolerance);
        EXPECT_NEAR((-t.y * y.x + t.x * y.y) / radius, t.x, tolerance);
        EXPECT_GT(x.x, 0.0);
        EXPECT_GT(y.y, 0.0);
    });
}

TEST_P(EveryFamily, ScaleMovesLengthsOnly)
{
    for (const double factor : {0x1p-30, 0x1p-7, 0x1p30})
        ForMany([&](const Request& request, const Lens& lens)
        {
            Request scaled = request;
            CameraFrame& c = scaled.camera;
            Statement& s = scaled.given;
            c = {factor * c.location, factor * c.direction, factor * c.right, factor * c.up};
            for (Vec3* point : {&s.focalPoint, &s.points[0], &s.points[1], &s.points[2]})
                *point = factor * *point;
            s.planeDistance *= factor;
            s.scale *= factor;
            const Lens same = Solved(scaled);
            EXPECT_EQ(same.focalLength, factor * lens.focalLength);
            EXPECT_EQ(same.filmDistance, factor * lens.filmDistance);
            EXPECT_EQ(same.diameter, factor * lens.diameter);
            EXPECT_EQ(Length(same.normal - lens.normal), 0.0);
            EXPECT_EQ(Length(factor * same.focus - lens.focus), 0.0);
            EXPECT_EQ(Length(same.direction - factor * lens.direction), 0.0);
            EXPECT_EQ(Length(same.lensX - factor * lens.lensX), 0.0);
        });
}

TEST_P(EveryFamily, WorksFarFromTheOrigin)
{
    ForMany([](const Request& request, const Lens& lens)
    {
        Request near = request, far = request;
        const auto grid = [&](const Vec3& v)
        {
            const Vec3 d = (v - request.camera.location) * 0x1p20;
            return Vec3{std::round(d.x), std::round(d.y), std::round(d.z)} * 0x1p-20;
        };
        const Vec3 place{1e7, -1e7, 3e6};
        near.camera.location = {0, 0, 0};
        far.camera.location = place;
        near.given.focalPoint = grid(request.given.focalPoint);
        far.given.focalPoint = place + near.given.focalPoint;
        for (int i = 0; i < 3; i++)
        {
            near.given.points[i] = grid(request.given.points[i]);
            far.given.points[i] = place + near.given.points[i];
        }
        // normal and distance lose the digits of the distance from the origin
        const Vec3 unit = Normalized(request.given.planeNormal);
        near.given.planeDistance = Dot(unit, near.given.focalPoint);
        far.given.planeDistance = near.given.planeDistance + Dot(unit, place);
        if (Length(near.given.focalPoint) < 1.0)
            return;
        const Lens a = Solved(near), b = Solved(far);
        const double tolerance = request.given.family == FocusFamily::FocalPlane ? 1e-7 * Length(lens.focus) : 0.0;
        EXPECT_LE(Length(b.focus - a.focus), tolerance * Length(a.focus));
        EXPECT_LE(Length(b.normal - a.normal), tolerance);
        EXPECT_NEAR(b.focalLength, a.focalLength, tolerance * a.focalLength);
    });
}

double PaperLensAngle(double filmDistance, double focusAngle, double distance)
{
    return std::atan(filmDistance * std::tan(focusAngle) / (distance + filmDistance));
}

TEST(PaperEquation, HoldsInBothDirections)
{
    Random random(4);
    for (int i = 0; i < kRequests; i++)
    {
        Lens lens;
        Request request = RandomRequest(random, FocusFamily::FocusTurn, random.Coin());
        const double distance = Dot(request.given.focalPoint - request.camera.location, AxisOf(request.camera));
        if (request.given.focalLength)
            request.given.focalLength = std::min(*request.given.focalLength, 0.1 * distance * request.given.sceneUnit);
        request.given.focalPoint = request.camera.location + distance * AxisOf(request.camera);
        request.given.focusSwing = 0.0;
        SCOPED_TRACE(testing::Message() << request);
        lens = Solved(request);
        const double angle = request.given.focusTilt * kDegree, s = lens.filmDistance;
        const double turn = PaperLensAngle(s, angle, distance);
        ASSERT_NEAR(TiltOf(lens) * kDegree, turn, 1e-15 * (1 + 20.0 / distance));
        ASSERT_NEAR(FocusAngleOf(lens) * kDegree, std::fabs(angle), 4e-15);

        request.given.family = FocusFamily::LensTurn;
        request.given.tilt = turn / kDegree;
        request.given.swing = 0.0;
        const Lens back = Solved(request);
        const Vec3 n = CameraPart(back, back.focus);
        const double slope = (s + distance) / s;
        ASSERT_NEAR(std::atan2(-n.y, n.z), angle, 1e-15 * (2.0 + slope * std::fabs(turn) + 20.0 / distance));
        ASSERT_NEAR(back.focalLength / lens.focalLength, 1.0, 1e-13);
    }
}

} // namespace
} // namespace tilt_lens
