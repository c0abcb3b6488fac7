// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/lens_camera/lens_camera.h"

namespace tilt_lens
{
namespace
{

/// 36 by 24 mm, 50 mm, f/2, focus at 2000; 1 unit is 1 mm.
Statement Block(const Character& character, double tilt = 0.0, double shiftRight = 0.0, double shiftUp = 0.0)
{
    Statement given;
    given.focalLength = 50.0;
    given.sceneUnit = 1.0;
    given.tilt = tilt;
    given.swing = -0.5 * tilt;
    given.shiftRight = shiftRight;
    given.shiftUp = shiftUp;
    given.focalPoint = {0.0, 0.0, 2000.0};
    given.fStop = 2.0;
    given.character = character;
    return given;
}

Lens Made(const Statement& given)
{
    return Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given);
}

Character Distorted(double k1, double k2 = 0.0, double near = 0.0)
{
    Character character;
    character.distortion1 = k1;
    character.distortion2 = k2;
    character.distortionNear = near;
    return character;
}

Character Curved(double millimetres)
{
    Character character;
    character.fieldCurvature = millimetres;
    return character;
}

template<typename Check>
void ForManyPoints(const Check& check)
{
    Random random(5);
    for (const double k1 : {-0.05, 0.08, 0.3})
        for (const double k2 : {-0.01, 0.0, 0.05})
            for (const double tilt : {0.0, 8.0})
                for (const double shift : {0.0, 9.0})
                    for (const double curvature : {-0.4, 0.0, 0.7})
                    {
                        Character character = Distorted(k1, k2, k1 > 0.0 && curvature > 0.0 ? 0.5 : 0.0);
                        character.fieldCurvature = curvature;
                        const Lens lens = Made(Block(character, tilt, shift, -0.5 * shift));
                        for (int i = 0; i < 20; i++)
                            check(lens, FilmPoint{random(-0.5, 0.5), random(-0.5, 0.5)});
                    }
}

TEST(Distortion, IsThePolynomialAboutTheAxisOfAShiftedFrame)
{
    for (const double shift : {0.0, 7.0})
    {
        const Lens lens = Made(Block(Distorted(0.1, -0.02), 0.0, shift, 0.0));
        for (const FilmPoint& picture : {FilmPoint{0.5, 0.5}, FilmPoint{-0.3, 0.1}, FilmPoint{0.0, -0.5}})
        {
            const double x = 2.0 * picture.x + shift / 18.0, y = 2.0 * picture.y * 24.0 / 36.0;
            const double r2 = x * x + y * y, factor = 1.0 + 0.1 * r2 - 0.02 * r2 * r2;
            const FilmPoint ideal = IdealFilmPoint(lens, picture);
            EXPECT_NEAR(ideal.x, 0.5 * (x * factor - shift / 18.0), 1e-14);
            EXPECT_NEAR(ideal.y, 0.5 * y * factor * 36.0 / 24.0, 1e-14);
        }
    }
}

TEST(Distortion, TurnsWithTheLens)
{
    const Lens lens = Made(Block(Distorted(0.1, -0.02), 10.0, 5.0, 3.0));
    const double halfWidth = 18.0 / (lens.filmDistance / lens.millimetre);
    for (const FilmPoint& picture : {FilmPoint{0.5, 0.5}, FilmPoint{-0.3, 0.1}, FilmPoint{0.0, -0.5}})
    {
        const Vec3 seen = lens.direction + picture.x * lens.right + picture.y * lens.up;
        const Vec3 shown = MakeRay(lens, picture.x, picture.y, 0.0, 0.0).direction;
        const auto tangent = [&](const Vec3& v) { return Length(Cross(v, lens.normal)) / Dot(v, lens.normal); };
        const double r = tangent(seen) / halfWidth;
        EXPECT_NEAR(tangent(shown) / halfWidth, r * (1.0 + 0.1 * r * r - 0.02 * r * r * r * r), 1e-13);
        EXPECT_NEAR(Dot(Cross(Normalized(seen), Normalized(shown)), lens.normal), 0.0, 1e-15);
    }
}

TEST(Distortion, ChangesWithTheDistanceOfTheFocus)
{
    Statement given = Block(Distorted(0.1, -0.02, 0.4), 10.0, 5.0, 3.0);
    given.focalPoint = {0.0, 0.0, 400.0};
    const Lens lens = Made(given);
    const double halfWidth = 18.0 / lens.filmDistance;
    const auto tangent = [&](const Vec3& v) { return Length(Cross(v, lens.normal)) / Dot(v, lens.normal); };
    double least = HUGE_VAL, most = 0.0;
    for (const FilmPoint& picture : {FilmPoint{0.5, 0.5}, FilmPoint{-0.3, 0.1}, FilmPoint{0.0, -0.5}})
    {
        const Vec3 seen = IdealChiefRay(lens, picture);
        const double v = lens.filmDistance * Dot(seen, lens.normal) / Dot(seen, lens.axis), nearness = 50.0 * (1.0 / 50.0 - 1.0 / v);
        const double r = tangent(seen) / halfWidth, factor = 0.1 + 0.4 * nearness;
        const Vec3 shown = ChiefRay(lens, picture);
        EXPECT_NEAR(tangent(shown) / halfWidth, r * (1.0 + factor * r * r - 0.02 * r * r * r * r), 1e-13);
        EXPECT_NEAR(Dot(Cross(Normalized(seen), Normalized(shown)), lens.normal), 0.0, 1e-15);
        least = std::min(least, nearness);
        most = std::max(most, nearness);
    }
    EXPECT_GT(most, 1.4 * least);
    // focus at 400 mm adds 0.4/8
    given = Block(Distorted(0.1, -0.02, 0.4));
    given.focalPoint = {0.0, 0.0, 400.0};
    Statement constant = given;
    constant.character = Distorted(0.15, -0.02);
    EXPECT_NEAR(IdealFilmPoint(Made(given), {0.4, -0.3}).x, IdealFilmPoint(Made(constant), {0.4, -0.3}).x, 1e-14);
}

TEST(Distortion, HasAnExactInverse)
{
    ForManyPoints([](const Lens& lens, const FilmPoint& picture)
    {
        const std::optional<FilmPoint> back = PictureFilmPoint(lens, IdealFilmPoint(lens, picture));
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->x, picture.x, 1e-13);
        EXPECT_NEAR(back->y, picture.y, 1e-13);
    });
}

TEST(Distortion, ShowsNoPointBeyondTheFold)
{
    const double fold = std::sqrt(1.0 / 0.3);
    EXPECT_NEAR(FoldOf(-0.1, 0.0), fold * fold, 1e-13);
    EXPECT_TRUE(std::isinf(FoldOf(0.1, 0.0)));
    EXPECT_TRUE(std::isinf(FoldOf(0.0, 0.0)));
    EXPECT_TRUE(std::isinf(FoldOf(-0.1, 0.1)));
    // 1 - 4 c r^3 is 0 at (4 c)^(-1/3); 1 - 4 r^3 + 3 r^4 = (1 - r)^2 (1 + 2 r + 3 r^2) touches 0 at 1
    EXPECT_NEAR(FoldOf(0.0, 0.0, -0.02), std::pow(0.08, -2.0 / 3.0), 1e-12);
    EXPECT_TRUE(std::isinf(FoldOf(0.0, 0.0, 0.02)));
    EXPECT_TRUE(std::isinf(FoldOf(0.0, 0.601, -1.0)));
    const double before = std::sqrt(FoldOf(0.0, 0.599, -1.0));
    EXPECT_LT(before, 1.0);
    EXPECT_NEAR(1.0 - 4.0 * std::pow(before, 3) + 2.995 * std::pow(before, 4), 0.0, 1e-14);
    const Lens lens = Made(Block(Distorted(-0.1)));
    EXPECT_TRUE(PictureFilmPoint(lens, {0.5 * 0.666 * fold, 0.0}));
    EXPECT_FALSE(PictureFilmPoint(lens, {0.5 * 0.667 * fold, 0.0}));
}

TEST(Distortion, StretchesByTheInverseOfItsDerivatives)
{
    const Lens lens = Made(Block(Distorted(0.2, -0.03), 0.0, 6.0, 0.0));
    for (const double x : {-0.5, 0.0, 0.5})
    {
        const double r = std::fabs(2.0 * x + 6.0 / 18.0), r2 = r * r;
        const double tangential = 1.0 + 0.2 * r2 - 0.03 * r2 * r2, radial = 1.0 + 0.6 * r2 - 0.15 * r2 * r2;
        EXPECT_NEAR(PictureStretch(lens, {x, 0.0}), 1.0 / std::min(tangential, radial), 1e-8) << x;
    }
    EXPECT_EQ(PictureStretch(Made(Block({})), {0.5, 0.5}), 1.0);
}

TEST(Distortion, BlurIsTheSizeOfTheDiscInThePicture)
{
    Statement given = Block(Distorted(0.2, -0.03), 0.0, 6.0, -4.0);
    given.fStop = 200.0;
    const Lens lens = Made(given);
    const double width = 1000.0;
    for (const FilmPoint& picture : {FilmPoint{0.5, 0.5}, FilmPoint{-0.4, 0.2}, FilmPoint{0.0, 0.0}})
        for (const double T : {900.0, 5000.0})
        {
            const Vec3 chief = ChiefRay(lens, picture), point = (T / Dot(lens.direction, lens.axis)) * chief;
            double longest = 0.0;
            for (int i = 0; i < 180; i++)
            {
                const double turn = M_PI * i / 180.0;
                const Vec3 l = std::cos(turn) * lens.lensX + std::sin(turn) * lens.lensY;
                const FilmPoint p = *PictureFilmPoint(lens, *IdealFilmPointOf(lens, *ChiefThrough(lens, point, l)));
                const FilmPoint q = *PictureFilmPoint(lens, *IdealFilmPointOf(lens, *ChiefThrough(lens, point, -l)));
                longest = std::max(longest, width * std::hypot(p.x - q.x, (p.y - q.y) * 24.0 / 36.0));
            }
            EXPECT_NEAR(std::fabs(BlurDiameter(lens, chief, T / Dot(lens.direction, lens.axis), width)) / longest, 1.0, 2e-3);
        }
}

TEST(Character, PointOnARayIsShownAtTheRaysFilmPoint)
{
    Random random(9);
    ForManyPoints([&](const Lens& lens, const FilmPoint& picture)
    {
        const double turn = random(0.0, 6.0), radius = random(0.0, 1.0);
        const LensRay ray = MakeRay(lens, picture.x, picture.y, radius * std::cos(turn), radius * std::sin(turn));
        const Vec3 point = ray.origin + random.Power(1.0, 4.0) / Length(ray.direction) * ray.direction;
        const std::optional<Vec3> chief = ChiefThrough(lens, point, ray.origin);
        ASSERT_TRUE(chief);
        const std::optional<FilmPoint> found = PictureFilmPoint(lens, *IdealFilmPointOf(lens, *chief));
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->x, picture.x, 1e-11);
        EXPECT_NEAR(found->y, picture.y, 1e-11);
    });
}

TEST(Character, AllRaysOfAFilmPointMeetOnTheSurfaceOfSharpFocus)
{
    ForManyPoints([](const Lens& lens, const FilmPoint& picture)
    {
        const LensRay chief = MakeRay(lens, picture.x, picture.y, 0.0, 0.0);
        const Vec3 focus = chief.direction / chief.w;
        const double along = Dot(focus, lens.normal);
        const Vec3 across = focus - along * lens.normal;
        EXPECT_NEAR(Dot(lens.focus, focus) + lens.fieldCurvature * Dot(across, across) / along, 1.0, 1e-13);
        for (const double turn : {0.0, 2.0, 4.0})
        {
            const LensRay ray = MakeRay(lens, picture.x, picture.y, std::cos(turn), std::sin(turn));
            EXPECT_LT(Length(ray.origin + ray.direction / ray.w - focus), 1e-12 * Length(focus));
        }
        EXPECT_NEAR(BlurDiameter(lens, chief.direction, 1.0 / chief.w, 1000.0), 0.0, 1e-10);
        EXPECT_NEAR(VergenceOfBlur(lens, chief.direction, 0.0, 1000.0), chief.w, 1e-14 * Length(lens.focus) * Length(chief.direction));
        const double blurred = VergenceOfBlur(lens, chief.direction, 7.0, 1000.0);
        EXPECT_NEAR(BlurDiameter(lens, chief.direction, 1.0 / blurred, 1000.0), 7.0, 1e-9);
    });
}

TEST(FieldCurvature, IsTheSagOfTheImage)
{
    const double s = 50.0 * 2000.0 / 1950.0, sag = 0.01;  // squares of sag/s are negligible
    const Lens lens = Made(Block(Curved(sag)));
    const double atSide = 1.0 / MakeRay(lens, 0.5, 0.0, 0.0, 0.0).w * Dot(lens.direction, lens.axis);
    EXPECT_NEAR(1.0 / atSide, 1.0 / 50.0 - 1.0 / (s + sag), 1e-9);
    EXPECT_LT(atSide, 2000.0) << "an image before the film is that of something nearer";
    const LensRay middle = MakeRay(lens, 0.0, 0.0, 0.3, 0.4);
    EXPECT_NEAR(Dot(lens.direction, lens.axis) / middle.w, 2000.0, 1e-9);
}

TEST(FieldCurvature, BendsWithTheLensAndStaysOnItsAxis)
{
    const Lens flat = Made(Block({}, 6.0)), bent = Made(Block(Curved(0.5), 6.0));
    EXPECT_NEAR(FieldVergence(bent, bent.normal), 0.0, 1e-30);
    EXPECT_DOUBLE_EQ(Dot(flat.focus, flat.normal), FocusVergence(bent, bent.normal));
    EXPECT_GT(FieldVergence(bent, bent.axis), 0.0);
}

TEST(LateralColour, MovesTheImagesOfTheSpectrumsEndsApart)
{
    Character character;
    character.lateralColour = 0.36;
    const Lens lens = Made(Block(character));
    EXPECT_TRUE(LensCamera(Shared(lens), Aperture::Disc(), character).HasColours());
    const auto seen = [&](double hue) { return IdealFilmPointOf(lens, MakeColourRay(lens, 0.5, 0.0, 0.0, 0.0, hue).direction)->x; };
    EXPECT_NEAR(seen(1.0), 0.5 / 1.01, 1e-14);
    EXPECT_NEAR(seen(0.0), 0.5, 1e-14);
    EXPECT_NEAR(seen(-1.0), 0.5 / 0.99, 1e-14);
    EXPECT_EQ(Length(MakeColourRay(lens, 0.3, 0.2, 0.1, 0.4, 0.0).direction - MakeRay(lens, 0.3, 0.2, 0.1, 0.4).direction), 0.0);
}

TEST(LateralColour, IsAboutTheAxisOfATurnedLens)
{
    Character character = Distorted(0.1);
    character.lateralColour = 0.36;
    const Lens lens = Made(Block(character, 10.0, 5.0, 3.0));
    const Vec3 red = MakeColourRay(lens, 0.5, -0.3, 0.0, 0.0, 1.0).direction, green = MakeRay(lens, 0.5, -0.3, 0.0, 0.0).direction;
    const auto tangent = [&](const Vec3& v) { return Length(Cross(v, lens.normal)) / Dot(v, lens.normal); };
    EXPECT_NEAR(tangent(green) / tangent(red), 1.01, 1e-13);
    EXPECT_NEAR(Dot(Cross(Normalized(red), Normalized(green)), lens.normal), 0.0, 1e-15);
}

TEST(AxialColour, MovesTheFocusOfTheSpectrumsEndsApart)
{
    Character character;
    character.axialColour = 0.02;
    const Lens lens = Made(Block(character));
    const double s = 50.0 * 2000.0 / 1950.0;
    for (const double hue : {-1.0, 0.0, 0.5, 1.0})
    {
        const LensRay ray = MakeColourRay(lens, 0.2, 0.1, 0.6, 0.3, hue);
        const double distance = Dot(lens.direction, lens.axis) / ray.w;
        EXPECT_NEAR(1.0 / distance, 1.0 / 50.0 - 1.0 / (s - 0.01 * hue), 2e-9) << hue;
        const Vec3 focus = MakeColourRay(lens, 0.2, 0.1, 0.0, 0.0, hue).direction / ray.w;
        EXPECT_LT(Length(ray.origin + ray.direction / ray.w - focus), 1e-12 * Length(focus));
    }
}

TEST(Character, DefaultIsTheIdealLens)
{
    const Lens lens = Made(Block({}, 8.0, 3.0, 2.0));
    EXPECT_FALSE(lens.distorts);
    EXPECT_EQ(lens.fieldCurvature, 0.0);
    const FilmPoint film{0.3, -0.2};
    EXPECT_EQ(PictureFilmPoint(lens, film)->x, film.x);
}

std::string ErrorOf(const Statement& given)
{
    try
    {
        Made(given);
    }
    catch (const OpticsError& error)
    {
        return error.what();
    }
    return "";
}

TEST(Character, RefusesImpossibleValues)
{
    EXPECT_NE(ErrorOf(Block(Distorted(-0.5))).find("folds the picture: beyond 0.816497 half widths"), std::string::npos);
    EXPECT_EQ(ErrorOf(Block(Distorted(-0.1))), "");
    EXPECT_NE(ErrorOf(Block(Distorted(-0.1), 0.0, 20.0)).find("frame reaches to 2.2"), std::string::npos);
    EXPECT_NE(ErrorOf(Block(Distorted(0.1), 30.0, -300.0)).find("reaches behind the turned lens"), std::string::npos);
    EXPECT_NE(ErrorOf(Block(Curved(0.1), 30.0, -300.0)).find("reaches behind the turned lens"), std::string::npos);
    Character wide;
    wide.lateralColour = 9.1;
    EXPECT_NE(ErrorOf(Block(wide)).find("lateral_colour 9.1 moves the colours"), std::string::npos);
    Character narrow;
    narrow.opticalVignetting = 0.5;
    narrow.rimStop = 4.0;
    EXPECT_NE(ErrorOf(Block(narrow)).find("rim of f/4, which is narrower than the aperture of f/2"), std::string::npos);
}

} // namespace
} // namespace tilt_lens
