// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/focus_aids.h"

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{
namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();

double Light(double shown)
{
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

double Luminance(const Rgb& c)
{
    return 0.2126 * Light(c.red) + 0.7152 * Light(c.green) + 0.0722 * Light(c.blue);
}

double Difference(const Rgb& a, const Rgb& b)
{
    return std::max({std::fabs(a.red - b.red), std::fabs(a.green - b.green), std::fabs(a.blue - b.blue)});
}

TEST(FocusMap, PositionGrowsWithBlurUpToTheLimit)
{
    EXPECT_EQ(FocusMapPosition(0.0), 0.0);
    EXPECT_EQ(FocusMapPosition(64.0), 1.0);
    EXPECT_EQ(FocusMapPosition(-1e9), -1.0);
    EXPECT_EQ(FocusMapPosition(kInfinity), 1.0);
    for (double blur = 0.01; blur < 60.0; blur *= 1.5)
    {
        EXPECT_GT(FocusMapPosition(1.5 * blur), FocusMapPosition(blur));
        EXPECT_EQ(FocusMapPosition(-blur), -FocusMapPosition(blur));
    }
}

TEST(FocusMap, DarkensWithBlur)
{
    for (const double side : {-1.0, 1.0})
    {
        double before = Luminance(FocusMapColour(0.0));
        EXPECT_GT(before, 0.9);
        for (double blur = 0.1; blur < 64.0; blur *= 1.2)
        {
            const double now = Luminance(FocusMapColour(side * blur));
            EXPECT_LT(now, before) << side * blur;
            before = now;
        }
        EXPECT_LT(before, 0.1);
    }
}

/// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", 2009.
Rgb Seen(const Rgb& c, const double (&m)[3][3])
{
    const double in[3] = {Light(c.red), Light(c.green), Light(c.blue)};
    double out[3];
    for (int i = 0; i < 3; i++)
        out[i] = m[i][0] * in[0] + m[i][1] * in[1] + m[i][2] * in[2];
    return {out[0], out[1], out[2]};
}

TEST(FocusMap, BothSidesDifferForTheColourBlind)
{
    const double protanopia[3][3] = {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}};
    const double deuteranopia[3][3] = {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}};
    const double tritanopia[3][3] = {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}};
    for (const auto& kind : {&protanopia, &deuteranopia, &tritanopia})
        for (const double blur : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0})
            EXPECT_GT(Difference(Seen(FocusMapColour(blur), *kind), Seen(FocusMapColour(-blur), *kind)), 0.1) << blur;
}

TEST(FocusMap, ScaleShowsTheMapsColoursInOrder)
{
    const int width = 640, height = 480;
    const FocusMapScale scale(width, height);
    int row = height, left = 0, right = 0;
    for (int y = 0; y < height; y++)
    {
        int first = -1, last = -1;
        for (int x = 0; x < width; x++)
        {
            const std::optional<Rgb> c = scale.At(x, y);
            if (c && Difference(*c, FocusMapColour(-64.0)) < 0.02 && first < 0)
                first = x;
            if (c && Difference(*c, FocusMapColour(64.0)) < 0.02)
                last = x;
        }
        if (first >= 0 && last > first)
            row = y, left = first, right = last;
    }
    ASSERT_LT(row, height) << "no bar";
    ASSERT_GT(right - left, width / 2);
    for (const double blur : {-60.0, -10.0, -1.0, 0.0, 1.0, 10.0, 60.0})
    {
        const int x = left + int(std::lround(0.5 * (FocusMapPosition(blur) + 1.0) * (right - left)));
        EXPECT_LT(Difference(*scale.At(x, row), FocusMapColour(blur)), 0.03) << blur;
    }
}

TEST(FocusMap, ScaleLiesAtTheBottomAndInsideThePicture)
{
    for (const auto& size : {std::pair<int, int>{64, 40}, {160, 120}, {320, 240}, {1280, 720}, {4096, 2160}, {2000, 50}})
    {
        const FocusMapScale scale(size.first, size.second);
        int pixels = 0, ink = 0;
        for (int y = 0; y < size.second; y++)
            for (int x = 0; x < size.first; x++)
                if (const std::optional<Rgb> c = scale.At(x, y))
                {
                    pixels++;
                    ink += c->red == 1.0 && c->blue == 1.0;
                    EXPECT_GT(y, size.second / 4) << size.first << " x " << size.second;
                }
        EXPECT_GT(pixels, 0) << size.first << " x " << size.second;
        EXPECT_GT(ink, 30) << "numbers";
        EXPECT_FALSE(scale.At(-1, 3) || scale.At(size.first, size.second - 5) || scale.At(5, size.second));
    }
}

TEST(FocusMap, SmallPicturesHaveNoScale)
{
    for (const auto& size : {std::pair<int, int>{63, 48}, {64, 39}, {8, 6}, {1, 1}})
        for (int y = 0; y < size.second; y++)
            for (int x = 0; x < size.first; x++)
                EXPECT_FALSE(FocusMapScale(size.first, size.second).At(x, y));
}

TEST(FocusPlanes, AreOrderedByDepthFromTheNearLimit)
{
    Random random(8);
    int seen = 0;
    for (int i = 0; i < 300; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, i % 2 ? FocusFamily::LensTurn : FocusFamily::FocusTurn, i % 4 < 2, lens);
        SCOPED_TRACE(testing::Message() << request);
        const int width = 320, height = 240, x = int(random(0, width)), y = int(random(0, height));
        const FocusPlanes planes(lens, width, height);
        const Vec3 chief = MakeRay(lens, (x + 0.5) / width - 0.5, 0.5 - (y + 0.5) / height, 0.0, 0.0).direction;
        std::map<double, double> inFront;
        for (const double pixels : {1.0, 0.0, -1.0})
        {
            const double vergence = Dot(lens.focus, chief) + pixels / BlurPerVergence(lens, width);
            if (vergence > 0.0)
                inFront[1.0 / vergence] = pixels;
        }
        EXPECT_EQ(planes.Before(x, y, kInfinity).size(), inFront.size());
        size_t passed = 0;
        for (const auto& surface : inFront)
        {
            EXPECT_EQ(planes.Before(x, y, surface.first * (1.0 - 1e-9)).size(), passed) << surface.second;
            EXPECT_EQ(planes.Before(x, y, surface.first * (1.0 + 1e-9)).size(), ++passed) << surface.second;
        }
        seen += passed == 3;
    }
    EXPECT_GT(seen, 100);
}

TEST(FocusPlanes, GridHasRoundSpacingAndLines)
{
    Request request = PlainRequest();
    request.given.family = FocusFamily::FocalPlane;
    request.given.planeNormal = {0, 1, 0};
    request.given.planeDistance = -1.0;
    const Lens lens = Solved(request);
    const FocusPlanes planes(lens, 320, 240);
    const double digits = planes.GridSpacing() / std::pow(10.0, std::floor(std::log10(planes.GridSpacing()) + 1e-9));
    EXPECT_TRUE(std::fabs(digits - 1) < 1e-9 || std::fabs(digits - 2) < 1e-9 || std::fabs(digits - 5) < 1e-9) << digits;
    int lines = 0, surface = 0;
    for (int y = 120; y < 240; y++)
        for (int x = 0; x < 320; x++)
            for (const Veil& veil : planes.Before(x, y, kInfinity))
                if (veil.colour.red == veil.colour.blue)
                    surface++, lines += veil.opacity > 0.5;
    EXPECT_GT(lines, surface / 100);
    EXPECT_LT(lines, surface / 2);
}

} // namespace
} // namespace tilt_lens
