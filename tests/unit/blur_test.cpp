// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Compares blur with light through the ends of the lens diameter parallel to the film.

#include "tilt_lens/camera/ray.h"

#include <limits>

#include <gtest/gtest.h>

#include "random_cameras.h"

namespace tilt_lens
{
namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();
const FocusFamily kFamilies[] = {FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane, FocusFamily::FocalPoints};

template<typename Check>
void ForManyPixels(Check check)
{
    Random random(23);
    for (int i = 0; i < 4000 && !testing::Test::HasFailure(); i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, kFamilies[i % 4], i % 8 < 4, lens);
        const double x = random(-0.5, 0.5), y = random(-0.5, 0.5);
        SCOPED_TRACE(testing::Message() << request << "\nfilm point " << x << ", " << y);
        check(lens, MakeRay(lens, x, y, 0.0, 0.0).direction, random);
    }
}

Vec3 SharedDiameter(const Lens& lens)
{
    const Vec3 across = Cross(lens.normal, lens.axis);
    return Length(across) > 1e-9 ? Normalized(across) : lens.axisRight;
}

Vec3 FramePoint(const Lens& lens, const Vec3& chief, double T, const Vec3& lensPoint)
{
    const Vec3 path = chief - lensPoint / T;
    return path + Dot(lens.focus, path) / (1.0 - Dot(lens.focus, lensPoint)) * lensPoint;
}

TEST(Blur, IsTheDistanceOfTheOutermostRaysOnTheFilm)
{
    ForManyPixels([](const Lens& lens, const Vec3& chief, Random& random)
    {
        const double width = 640.0, focus = 1.0 / Length(lens.focus), T = random.Power(-1.5, 2.0) * focus / Length(chief);
        const Vec3 end = 0.5 * lens.diameter * SharedDiameter(lens);
        for (const double at : {T, kInfinity})
        {
            const Vec3 apart = FramePoint(lens, chief, at, end) - FramePoint(lens, chief, at, -1.0 * end);
            const double pixels = Length(apart) * width / Length(lens.right);
            const double blur = BlurDiameter(lens, chief, at, width);
            const double rounding = 1e-15 * Length(chief) * width / Length(lens.right);
            EXPECT_NEAR(std::fabs(blur), pixels, 1e-12 * pixels + 4.0 * rounding) << "at " << at;
        }
    });
}

TEST(Blur, IsPositiveBeforeThePlaneOfSharpFocus)
{
    ForManyPixels([](const Lens& lens, const Vec3& chief, Random& random)
    {
        const double w = Dot(lens.focus, chief);
        const double T = random.Power(-2.0, 2.0) * 1.0 / std::max(std::fabs(w), 1e-6);
        const bool before = Dot(lens.focus, T * chief) < 1.0;
        EXPECT_EQ(BlurDiameter(lens, chief, T, 100.0) > 0.0, before) << "T = " << T << ", w = " << w;
    });
}

TEST(Blur, AgreesWithBlurVergence)
{
    ForManyPixels([](const Lens& lens, const Vec3& chief, Random& random)
    {
        const double T = random.Power(-3.0, 3.0);
        EXPECT_DOUBLE_EQ(BlurDiameter(lens, chief, T, 320.0), BlurVergence(lens, chief, T) * lens.diameter * 320.0 / Length(lens.right));
    });
}

TEST(Blur, PinholeHasNone)
{
    Random random(3);
    Lens lens;
    SolvableRequest(random, FocusFamily::LensTurn, false, lens);
    lens.diameter = 0.0;
    for (const double T : {1e-6, 1.0, kInfinity})
        EXPECT_EQ(BlurDiameter(lens, lens.direction, T, 640.0), 0.0);
}

TEST(PlaneOfBlur, ContainsThePointsOfThatBlur)
{
    ForManyPixels([](const Lens& lens, const Vec3& chief, Random& random)
    {
        const double width = 800.0, pixels = random(-20.0, 20.0);
        const Vec3 k = PlaneOfBlur(lens, pixels, width);
        const double T = 1.0 / Dot(k, chief);
        const double size = BlurPerVergence(lens, width) * (Length(k) + Length(lens.focus)) * Length(chief);
        EXPECT_NEAR(BlurDiameter(lens, chief, T, width), pixels, 1e-12 * size) << "T = " << T;
    });
}

TEST(PlaneOfBlur, ZeroIsThePlaneOfSharpFocus)
{
    ForManyPixels([](const Lens& lens, const Vec3&, Random&) { EXPECT_EQ(Length(PlaneOfBlur(lens, 0.0, 640.0) - lens.focus), 0.0); });
}

TEST(PlaneOfBlur, MeetInTheHingeLine)
{
    ForManyPixels([](const Lens& lens, const Vec3&, Random& random)
    {
        const Vec3 apart = PlaneOfBlur(lens, random(1.0, 9.0), 500.0) - lens.focus;
        EXPECT_GT(Dot(apart, lens.axis), 0.0);
        EXPECT_LT(Length(Cross(apart, lens.axis)), 1e-14 * (Length(apart) + Length(lens.focus)));
    });
}

} // namespace
} // namespace tilt_lens
