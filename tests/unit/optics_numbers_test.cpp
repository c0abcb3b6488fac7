// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{
namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();

void ExpectSame(const Vec3& a, const Vec3& b)
{
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.z, b.z);
}

TEST(Signs, TiltLeansTheTopTowardTheScene)
{
    Request request = PlainRequest();
    request.given.tilt = 8.0;
    const Lens lens = Solved(request);
    EXPECT_GT(lens.lensY.z, 0.0);
    EXPECT_EQ(lens.lensX.z, 0.0);
    EXPECT_GT(Dot(lens.focus, {0, -1, 0}), 0.0) << "the hinge line is not below";
    EXPECT_NEAR(TiltOf(lens), 8.0, 1e-13);
    EXPECT_EQ(SwingOf(lens), 0.0);
}

TEST(Signs, SwingTurnsTheRightHandSideTowardTheScene)
{
    Request request = PlainRequest();
    request.given.swing = 8.0;
    const Lens lens = Solved(request);
    EXPECT_GT(lens.lensX.z, 0.0);
    EXPECT_EQ(lens.lensY.z, 0.0);
    EXPECT_GT(Dot(lens.focus, {-1, 0, 0}), 0.0) << "the hinge line is not to the left";
    EXPECT_NEAR(SwingOf(lens), 8.0, 1e-13);
    EXPECT_EQ(TiltOf(lens), 0.0);
}

TEST(Signs, FocusTurnsLeanTopAndRightAwayFromTheCamera)
{
    Request request = PlainRequest();
    request.given.family = FocusFamily::FocusTurn;
    request.given.focusTilt = 30.0;
    const Lens top = Solved(request);
    EXPECT_NEAR(Dot(top.focus, {0, 1, 5 + std::tan(30 * kDegree)}), 1.0, 1e-14);
    EXPECT_GT(TiltOf(top), 0.0);
    request.given.focusTilt = 0.0;
    request.given.focusSwing = 30.0;
    const Lens right = Solved(request);
    EXPECT_NEAR(Dot(right.focus, {1, 0, 5 + std::tan(30 * kDegree)}), 1.0, 1e-14);
    EXPECT_GT(SwingOf(right), 0.0);
}

TEST(Signs, FollowTheCamerasOwnRight)
{
    Random random(5);
    for (int i = 0; i < 500; i++)
    {
        Request request = PlainRequest();
        request.given.tilt = random(-20, 20);
        request.given.swing = random(-20, 20);
        request.given.shiftRight = random(-9, 9);
        request.given.focalPoint.x = random(-1, 1);
        const Lens left = Solved(request);
        request.camera.right = -request.camera.right;
        request.given.focalPoint.x *= -1;
        SCOPED_TRACE(testing::Message() << request);
        const Lens mirrored = Solved(request);
        const auto mirror = [](const Vec3& v) { return Vec3{-v.x, v.y, v.z}; };
        ExpectSame(mirrored.normal, mirror(left.normal));
        ExpectSame(mirrored.focus, mirror(left.focus));
        ExpectSame(mirrored.direction, mirror(left.direction));
        ExpectSame(mirrored.lensX, mirror(left.lensX));
        ExpectSame(mirrored.lensY, mirror(left.lensY));
    }
}

TEST(Shift, MovesTheFrameByExactPixelsOnly)
{
    const double width = 320, height = 240;
    for (const double tilt : {0.0, 7.0})
        for (const int pixels : {-40, 1, 7})
        {
            Request request = PlainRequest();
            request.given.tilt = tilt;
            const Lens plain = Solved(request);
            request.given.shiftRight = request.given.filmWidth / width * pixels;
            request.given.shiftUp = -2 * request.given.shiftRight;
            const Lens shifted = Solved(request);
            for (const double x : {-0.5, 0.1})
            {
                const LensRay a = MakeRay(shifted, x, 0.25, 0.6, -0.3);
                const LensRay b = MakeRay(plain, x + pixels / width, 0.25 - 2 * pixels / height, 0.6, -0.3);
                EXPECT_LT(Length(a.direction - b.direction), 1e-15) << "tilt " << tilt << ", pixels " << pixels;
                ExpectSame(a.origin, b.origin);
            }
            ExpectSame(shifted.normal, plain.normal);
            ExpectSame(shifted.focus, plain.focus);
            ExpectSame(shifted.lensX, plain.lensX);
            ExpectSame(shifted.lensY, plain.lensY);
            EXPECT_EQ(shifted.focalLength, plain.focalLength);
            EXPECT_EQ(shifted.filmDistance, plain.filmDistance);
        }
}

TEST(Shift, AddsToThatOfAShearedDirection)
{
    for (const bool focalLength : {false, true})
    {
        Request request = PlainRequest();
        request.given.tilt = 7.0;
        if (focalLength)
            request.given.focalLength = 50.0;
        Request sheared = request;
        request.given.shiftRight = 5.0;
        request.given.shiftUp = -9.0;
        sheared.camera.direction = {5.0 / 36 * 1.6, -9.0 / 36 * 1.6, 1.6};
        const Lens a = Solved(request), b = Solved(sheared);
        EXPECT_LT(Length(a.direction - b.direction), 1e-15) << request << '\n' << sheared;
        ExpectSame(a.focus, b.focus);
        ExpectSame(a.normal, b.normal);
    }
}

TEST(Tilt, MovesNoChiefRay)
{
    Request request = PlainRequest();
    request.given.shiftUp = 4.0;
    const Lens straight = Solved(request);
    request.given.tilt = 12.0;
    request.given.swing = -5.0;
    const Lens turned = Solved(request);
    ExpectSame(turned.direction, straight.direction);
    ExpectSame(turned.right, straight.right);
    ExpectSame(turned.up, straight.up);
}

TEST(PhysicalUnits, NormalLensGivesTheTextbooksNumbers)
{
    Request request = PlainRequest();
    request.given.focalLength = 50.0;
    for (const double unit : {1000.0, 1.0, 25.4})
    {
        request.given.sceneUnit = unit;
        request.given.focalPoint = {0, 0, 1e9};
        const Lens far = Solved(request);
        EXPECT_NEAR(2 * std::atan2(0.5 * Length(far.right), Dot(far.direction, far.axis)) / kDegree, 39.5978, 1e-4);
        EXPECT_NEAR(far.diameter * unit, 25.0, 1e-12);
        request.given.focalPoint = {0, 0, 1000.0 / unit}; // one metre: 1/s = 1/50 - 1/1000
        EXPECT_NEAR(Solved(request).filmDistance * unit, 1000.0 / 19.0, 1e-11);
        request.given.focalPoint = {0, 0, 100.0 / unit}; // twice the focal length: life size
        EXPECT_NEAR(Solved(request).filmDistance * unit, 100.0, 1e-11);
    }
}

TEST(PhysicalUnits, ApertureIsTwiceTheDiameterAndScalesWithTheCamera)
{
    Request request = PlainRequest();
    request.given.fStop.reset();
    request.given.aperture = 0.4;
    EXPECT_DOUBLE_EQ(Solved(request).diameter, 0.2);
    EXPECT_DOUBLE_EQ(Length(Solved(request).lensX), 0.1);
    request.given.scale = 3.0;
    EXPECT_DOUBLE_EQ(Solved(request).diameter, 0.6);
    request.given.aperture = 0.0;
    EXPECT_EQ(Solved(request).diameter, 0.0);
    EXPECT_EQ(Length(MakeRay(Solved(request), 0.2, 0.3, 0.7, 0.7).origin), 0.0);
}

/// Longest extent, pixels, of an axial point's blur.
double BlurInPixels(const Lens& lens, double distance, double width)
{
    const Vec3 shared = Dot(lens.normal, lens.axis) < 1 - 1e-12 ? Normalized(Cross(lens.axis, lens.normal)) : lens.axisRight;
    const Vec3 chief = Dot(lens.direction, lens.axis) * lens.axis;
    const Vec3 rim = lens.diameter / 2 * shared;
    const Vec3 path = (distance * lens.axis - rim) * (Length(chief) / distance);
    const Vec3 frame = path + Dot(lens.focus, path) / (1.0 - Dot(lens.focus, rim)) * rim;
    // rounding leaves `shared` a component along the axis
    return 2 * std::fabs(Dot(frame - chief, shared)) * width / Length(lens.right);
}

TEST(SharpRange, EndsAtTheGivenBlur)
{
    Random random(6);
    int infinite = 0;
    for (int i = 0; i < 2000; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, i % 2 ? FocusFamily::LensTurn : FocusFamily::FocusTurn, i % 4 < 2, lens);
        SCOPED_TRACE(testing::Message() << request);
        const double width = 640, pixels = random(0.5, 3.0);
        const SharpRange range = SharpRangeOf(lens, width, pixels);
        if (!std::isfinite(range.near))
            continue;
        // rounding of the film's distance over the blur's radius
        const double radius = pixels / 2 * Length(lens.right) / width;
        const double rounding = 4 * std::numeric_limits<double>::epsilon() * Dot(lens.direction, lens.axis) / radius;
        ASSERT_NEAR(BlurInPixels(lens, range.near, width) / pixels, 1.0, rounding);
        ASSERT_GT(BlurInPixels(lens, range.near * 0.9, width), pixels);
        if (std::isfinite(range.far))
        {
            ASSERT_NEAR(BlurInPixels(lens, range.far, width) / pixels, 1.0, rounding);
            ASSERT_LT(BlurInPixels(lens, 0.5 * (range.near + range.far), width), pixels);
        }
        else
        {
            infinite++;
            ASSERT_LE(BlurInPixels(lens, 1e9 * range.near, width), pixels * (1 + 1e-6));
        }
    }
    EXPECT_GT(infinite, 50);
}

TEST(SharpRange, HyperfocalDistanceIsTheTextbooks)
{
    // f^2 / (N c) + f: 50 mm, f/2, c = 36 mm / 1200
    Request request = PlainRequest();
    request.given.focalLength = 50.0;
    const double hyperfocal = 2500.0 / (2.0 * 0.03) + 50.0;
    request.given.focalPoint = {0, 0, hyperfocal / 1000.0 * 1.0001};
    const SharpRange range = SharpRangeOf(Solved(request), 1200, 1.0);
    EXPECT_NEAR(range.near, hyperfocal / 2000.0, 0.01);
    EXPECT_EQ(range.far, kInfinity);
    request.given.focalPoint.z = hyperfocal / 1000.0 * 0.99;
    EXPECT_GT(SharpRangeOf(Solved(request), 1200, 1.0).far, 1000.0);
    EXPECT_LT(SharpRangeOf(Solved(request), 1200, 1.0).far, kInfinity);
}

TEST(Numbers, ParallelLensReadsParallelForAnyOrientation)
{
    Random random(7);
    for (int i = 0; i < 1000; i++)
    {
        Request request;
        request.camera = RandomFrame(random);
        request.given.focalPoint = request.camera.location + random.Power(0, 4) * AxisOf(request.camera);
        SCOPED_TRACE(testing::Message() << request);
        const Lens lens = Solved(request);
        ASSERT_EQ(HingeDistanceOf(lens), kInfinity);
        ASSERT_EQ(TiltOf(lens), 0.0);
        ASSERT_EQ(SwingOf(lens), 0.0);
        ASSERT_EQ(FocusAngleOf(lens), 0.0);
        ASSERT_TRUE(Warnings(lens, request.given).empty()) << Warnings(lens, request.given)[0];
    }
}

TEST(Numbers, PlaneAlongTheAxisDoesNotCrossIt)
{
    Random random(8);
    for (int i = 0; i < 1000; i++)
    {
        Request request;
        request.camera = RandomFrame(random);
        request.camera.location = {0, 0, 0};
        request.given.family = FocusFamily::FocalPlane;
        request.given.planeNormal = Normalized(Cross(AxisOf(request.camera), random.Direction()));
        request.given.planeDistance = 2.0;
        SCOPED_TRACE(testing::Message() << request);
        const Lens lens = Solved(request);
        ASSERT_EQ(AxisFocusOf(lens), kInfinity);
        ASSERT_NEAR(FocusAngleOf(lens), 90.0, 1e-13);
        ASSERT_NEAR(HingeDistanceOf(lens), 2.0, 1e-13);
    }
}

} // namespace
} // namespace tilt_lens
