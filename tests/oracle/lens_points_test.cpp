// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lens_points.h"

namespace
{

using witness::LensPoint;
using witness::LensPoints;

TEST(LensPoints, EachCoordinateIsStratified)
{
    const int count = 256;
    const std::vector<LensPoint> points = LensPoints(count, 7, 0, 0.0);
    std::vector<int> x(count), y(count), area(count);
    for (const LensPoint& point : points)
    {
        ++x[static_cast<int>((point.jitterX + 0.5) * count)];
        ++y[static_cast<int>((point.jitterY + 0.5) * count)];
        ++area[static_cast<int>((point.a * point.a + point.b * point.b) * count)];
    }
    for (const std::vector<int>* strata : {&x, &y, &area})
        EXPECT_EQ(*std::max_element(strata->begin(), strata->end()), 1);
}

TEST(LensPoints, SeedsAreDifferentAndRepeatable)
{
    const std::vector<LensPoint> a = LensPoints(64, 1, 0, 0.0), b = LensPoints(64, 2, 0, 0.0), again = LensPoints(64, 1, 0, 0.0);
    int equal = 0;
    for (int i = 0; i < 64; ++i)
    {
        equal += a[i].jitterX == b[i].jitterX ? 1 : 0;
        EXPECT_EQ(a[i].a, again[i].a) << i;
    }
    EXPECT_EQ(equal, 0);
}

TEST(LensPoints, DiscHasTheMomentsOfADisc)
{
    double a = 0.0, b = 0.0, aa = 0.0, ab = 0.0;
    const int count = 4096;
    for (const LensPoint& point : LensPoints(count, 3, 0, 0.0))
    {
        a += point.a / count;
        b += point.b / count;
        aa += point.a * point.a / count;
        ab += point.a * point.b / count;
    }
    EXPECT_NEAR(a, 0.0, 1e-3);
    EXPECT_NEAR(b, 0.0, 1e-3);
    EXPECT_NEAR(aa, 0.25, 1e-3);
    EXPECT_NEAR(ab, 0.0, 1e-3);
}

/// Second moment of a regular N-gon on the unit circle: (1 + 2 cos^2(pi/N)) / 12 per axis.
TEST(LensPoints, PolygonIsFilledEvenly)
{
    const double pi = std::acos(-1.0);
    for (const int blades : {3, 5, 6, 9})
    {
        const int count = 4096;
        double a = 0.0, aa = 0.0, bb = 0.0, outermost = 0.0;
        for (const LensPoint& point : LensPoints(count, 3, blades, 20.0))
        {
            a += point.a / count;
            aa += point.a * point.a / count;
            bb += point.b * point.b / count;
            for (int edge = 0; edge < blades; ++edge)
            {
                const double normal = 20.0 * pi / 180.0 + (2 * edge + 1) * pi / blades;
                outermost = std::max(outermost, point.a * std::cos(normal) + point.b * std::sin(normal));
            }
        }
        const double cosine = std::cos(pi / blades), moment = (1.0 + 2.0 * cosine * cosine) / 12.0;
        EXPECT_NEAR(a, 0.0, 2e-3) << blades;
        EXPECT_NEAR(aa, moment, 2e-3) << blades;
        EXPECT_NEAR(bb, moment, 2e-3) << blades;
        EXPECT_LE(outermost, cosine + 1e-12) << blades;
        EXPECT_GT(outermost, 0.99 * cosine) << blades;
    }
}

} // namespace
