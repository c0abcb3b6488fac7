// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sharpness.h"

namespace
{

using paper::Point;
using witness::Picture;

/// A turned checker board: each pixel is the mean over its square and a disc, by random points.
Picture Checkers(double diameter, int finer = 1)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> even(-0.5, 0.5);
    Picture picture{60 * finer, 50 * finer, {}};
    for (int row = 0; row < picture.height; ++row)
        for (int column = 0; column < picture.width; ++column)
        {
            const int count = 300;
            int bright = 0;
            for (int i = 0; i < count; ++i)
            {
                double u, v;
                do
                {
                    u = even(random);
                    v = even(random);
                }
                while (std::hypot(u, v) > 0.5);
                const double x = (column + 0.5 + even(random)) / finer + diameter * u,
                             y = (row + 0.5 + even(random)) / finer + diameter * v;
                const double a = 0.17 * x + 0.06 * y, b = 0.17 * y - 0.06 * x;
                bright += static_cast<int>(std::floor(a) + std::floor(b)) & 1;
            }
            picture.values.insert(picture.values.end(), 3, 0.9 * bright / count);
        }
    return picture;
}

TEST(Blur, IsRecovered)
{
    const Picture sharp = Checkers(0.0);
    for (const double diameter : {1.5, 3.0, 5.0, 9.0})
    {
        const paper::Blur blur = paper::BlurBetween(sharp, Checkers(diameter), {15, 15, 30, 20}, 20.0);
        // a pixel's own variance is at most 1/12, a disc's d^2/16
        EXPECT_NEAR(blur.diameter * blur.diameter, diameter * diameter, 16.0 / 12);
        EXPECT_LT(blur.residual, 0.1);
    }
}

TEST(Blur, IsMorePreciseOnAFinerGrid)
{
    const Picture sharp = Checkers(0.0, 3);
    for (const double diameter : {1.5, 3.0})
        EXPECT_NEAR(paper::BlurBetween(sharp, Checkers(diameter), {15, 15, 30, 20}, 9.0).diameter, diameter, 0.1);
}

TEST(Blur, SharpPictureHasLessThanAPixel)
{
    EXPECT_LT(paper::BlurBetween(Checkers(0.0), Checkers(0.0), {15, 15, 30, 20}, 20.0).diameter, 0.3);
}

TEST(Blur, RefusesUnmeasurablePictures)
{
    const Picture sharp = Checkers(0.0), grey{60, 50, std::vector<double>(60 * 50 * 3, 0.5)};
    EXPECT_THROW(paper::BlurBetween(sharp, sharp, {50, 0, 20, 20}, 9.0), std::invalid_argument);
    EXPECT_THROW(paper::BlurBetween(grey, sharp, {15, 15, 9, 9}, 9.0), std::invalid_argument);
    EXPECT_THROW(paper::BlurBetween(Picture{2, 2, std::vector<double>(12)}, sharp, {0, 0, 2, 2}, 9.0), std::invalid_argument);
}

TEST(Steepness, MatchesAStep)
{
    // ten columns around a step average 255/10 levels per pixel
    Picture picture{20, 9, {}};
    for (int i = 0; i < 20 * 9; ++i)
        picture.values.insert(picture.values.end(), 3, i % 20 < 10 ? 0.0 : 1.0);
    EXPECT_NEAR(paper::MeanSteepness(picture, {5, 4.5}, {15, 4.5}, 1.0), 25.5, 1e-9);
    EXPECT_THROW(paper::MeanSteepness(picture, {5, 4.5}, {5, 4.5}, 1.0), std::invalid_argument);
    EXPECT_THROW(paper::MeanSteepness(picture, {5, -20}, {15, -20}, 1.0), std::invalid_argument);
}

} // namespace
