// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/optics.h"

#include <gtest/gtest.h>

#include "random_cameras.h"

namespace tilt_lens
{
namespace
{

const double kFocalLength = 50.0;  // mm; a scene unit of PlainRequest() is a metre

Request Turned(double tilt, double swing)
{
    Request request = PlainRequest();
    request.given.focalLength = kFocalLength;
    request.given.tilt = tilt;
    request.given.swing = swing;
    return request;
}

/// By 1/object + 1/image = 1/f along the lens normal.
double ImageDistance(const Lens& lens, const Vec3& point)
{
    return Dot(point, lens.axis) * lens.focalLength / (Dot(point, lens.normal) - lens.focalLength);
}

void ExpectPlaneOnFilm(const Lens& lens)
{
    const Vec3 nearest = lens.focus / Dot(lens.focus, lens.focus);
    const Vec3 a = Normalized(Cross(lens.focus, std::fabs(lens.focus.x) < std::fabs(lens.focus.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 b = Normalized(Cross(lens.focus, a));
    for (const double x : {-1.0, 0.3, 2.0})
        for (const double y : {-0.7, 0.2, 3.0})
            EXPECT_NEAR(ImageDistance(lens, nearest + x * a + y * b) / lens.filmDistance, 1.0, 1e-9) << x << ' ' << y;
}

TEST(FilmDistance, PlacesTheFilmAndFocusesOnIt)
{
    for (const double film : {50.5, 51.2, 60.0, 120.0})
        for (const double tilt : {0.0, 5.0, -20.0})
            for (const double swing : {0.0, 3.0})
            {
                Request request = Turned(tilt, swing);
                request.given.filmDistance = film;
                const Lens lens = Solved(request);
                EXPECT_NEAR(lens.filmDistance / lens.millimetre, film, 1e-12 * film);
                EXPECT_NEAR(TiltOf(lens), tilt, 1e-12);
                EXPECT_NEAR(SwingOf(lens), swing, 1e-12);
                ExpectPlaneOnFilm(lens);
            }
}

TEST(FilmDistance, FocalLengthFocusesAtInfinity)
{
    Request request = Turned(0.0, 0.0);
    request.given.filmDistance = kFocalLength;
    EXPECT_NEAR(Length(Solved(request).focus), 0.0, 1e-12);
}

TEST(FocusScale, IsTheDistanceFromFilmToSubjectOfAnUntiltedLens)
{
    for (const double scale : {0.2, 0.3, 2.0, 1e6})
    {
        Request request = Turned(0.0, 0.0);
        request.given.focusScale = scale;
        const Lens lens = Solved(request);
        EXPECT_NEAR((AxisFocusOf(lens) + lens.filmDistance) / scale, 1.0, 1e-9) << scale;
        EXPECT_LE(lens.filmDistance, AxisFocusOf(lens) * (1 + 1e-6)) << "the larger of the two images";
    }
}

TEST(FocusScale, TheTiltMovesNeitherFilmNorFrame)
{
    Request straight = Turned(0.0, 0.0), tilted = Turned(5.0, -2.0);
    straight.given.focusScale = tilted.given.focusScale = 2.0;
    const Lens a = Solved(straight), b = Solved(tilted);
    EXPECT_DOUBLE_EQ(a.filmDistance, b.filmDistance);
    EXPECT_DOUBLE_EQ(a.diameter, b.diameter);
    EXPECT_DOUBLE_EQ(Length(a.right) / Dot(a.direction, a.axis), Length(b.right) / Dot(b.direction, b.axis));
    ExpectPlaneOnFilm(b);
}

TEST(FocusScale, WithAnAngleOfViewTheFocalLengthFollows)
{
    Request request = PlainRequest();
    request.given.tilt = 4.0;
    request.given.focusScale = 2.0;
    const Lens tilted = Solved(request);
    request.given.tilt = 0.0;
    const Lens straight = Solved(request);
    EXPECT_DOUBLE_EQ(tilted.focalLength, straight.focalLength);
    EXPECT_NEAR(AxisFocusOf(straight) + straight.filmDistance, 2.0, 1e-12);
    ExpectPlaneOnFilm(tilted);
}

TEST(FocusScale, GrowsWithTheCamera)
{
    Request request = Turned(5.0, 0.0);
    request.given.focusScale = 2.0;
    const Lens once = Solved(request);
    request.given.scale = 3.0;
    const Lens thrice = Solved(request);
    EXPECT_NEAR(thrice.filmDistance / once.filmDistance, 3.0, 1e-12);
    EXPECT_NEAR(Length(thrice.focus) * 3.0 / Length(once.focus), 1.0, 1e-12);
}

TEST(FocusScale, NearerThanFourFocalLengthsIsRefused)
{
    Request request = Turned(0.0, 0.0);
    request.given.focusScale = 0.2;
    EXPECT_NO_THROW(Solved(request));
    request.given.focusScale = 0.1999;
    EXPECT_THROW(Solved(request), OpticsError);
}

} // namespace
} // namespace tilt_lens
