// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "brightness.h"

namespace
{

using paper::Point;
using witness::Picture;

template<typename Value>
Picture Make(int width, int height, Value value)
{
    Picture picture{width, height, {}};
    for (int row = 0; row < height; ++row)
        for (int column = 0; column < width; ++column)
            picture.values.insert(picture.values.end(), 3, value(column, row));
    return picture;
}

TEST(Profile, ReadsLevelsOfAnSrgbFile)
{
    // 0.5 linear is 187.5 in sRGB (IEC 61966-2-1)
    const auto levels = paper::Profile(Make(4, 4, [](int, int) { return 0.5; }), {0, 0}, {4, 4}, 5);
    for (const double level : levels)
        EXPECT_NEAR(level, 187.5, 0.1);
}

TEST(Profile, MixesBetweenTheMiddlesOfPixels)
{
    const Picture picture = Make(2, 2, [](int column, int) { return column ? 1.0 : 0.0; });
    const auto levels = paper::Profile(picture, {0.5, 1}, {1.5, 1}, 5);
    for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(levels[i], 255.0 * i / 4, 1e-9);
}

TEST(Profile, RefusesALineOutsideThePicture)
{
    const Picture picture = Make(4, 4, [](int, int) { return 0.5; });
    EXPECT_THROW(paper::Profile(picture, {-1, 0}, {2, 2}, 5), std::invalid_argument);
    EXPECT_THROW(paper::Profile(picture, {0, 0}, {2, 4.1}, 5), std::invalid_argument);
    EXPECT_THROW(paper::Profile(picture, {0, 0}, {2, 2}, 1), std::invalid_argument);
}

TEST(Profile, AveragesAbsoluteDifferences)
{
    EXPECT_DOUBLE_EQ(paper::AverageDifference({1, 2, 3}, {2, 2, 1}), 1.0);
    EXPECT_THROW(paper::AverageDifference({1}, {1, 2}), std::invalid_argument);
}

TEST(Moments, MatchARectangle)
{
    // 5 by 3 pixels have the variances (n^2 - 1)/12
    const Picture picture = Make(20, 20, [](int x, int y) { return x >= 4 && x < 9 && y >= 7 && y < 10 ? 0.25 : 0.0; });
    const paper::Moments m = paper::MomentsIn(picture, 2, 2, 15, 15);
    EXPECT_NEAR(m.centroid.x, 6.5, 1e-12);
    EXPECT_NEAR(m.centroid.y, 8.5, 1e-12);
    EXPECT_NEAR(m.xx, 2.0, 1e-12);
    EXPECT_NEAR(m.yy, 8.0 / 12, 1e-12);
    EXPECT_NEAR(m.xy, 0.0, 1e-12);
    EXPECT_THROW(paper::MomentsIn(picture, 12, 12, 4, 4), std::invalid_argument);
    EXPECT_THROW(paper::MomentsIn(picture, 12, 12, 10, 4), std::invalid_argument);
}

TEST(Edges, FindFractionsOfAPixel)
{
    const Picture picture = Make(10, 1, [](int x, int) { return x == 2 ? 0.2 : x > 2 && x < 7 ? 0.8 : x == 7 ? 0.4 : 0.0; });
    const paper::Edges edges = paper::EdgesIn(picture, 0, 4);
    EXPECT_NEAR(edges.left, 2.75, 1e-12);
    EXPECT_NEAR(edges.right, 7.5, 1e-12);
}

} // namespace
