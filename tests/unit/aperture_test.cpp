// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Fixed seeds; the chi-square tests fail for a perfect map with probability 1e-5.

#include "tilt_lens/camera/aperture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "statistics.h"

namespace tilt_lens
{

std::ostream& operator<<(std::ostream& out, const AperturePoint& p)
{
    return out << "(" << p.a << ", " << p.b << ")";
}

namespace
{

const double nearlyOne = std::nextafter(1.0, 0.0);

struct Outline
{
    int blades;
    double angle;
    double curvature = 0;

    Aperture Make() const { return blades == 0 ? Aperture::Disc() : Aperture::Polygon(blades, angle, curvature); }

    double Area() const
    {
        if (blades == 0)
            return M_PI;
        const double spread = std::asin(curvature * std::sin(M_PI / blades));
        const double segment = curvature == 0 ? 0 : (spread - std::sin(2 * spread) / 2) / Square(curvature);
        return blades * (std::sin(2 * M_PI / blades) / 2 + segment);
    }

    double Tolerance() const { return curvature == 0 ? 1e-12 : 2e-5; }

    double Size(const AperturePoint& p) const
    {
        if (blades == 0)
            return std::hypot(p.a, p.b);
        // the blade nearest to the point's direction bounds it
        const double turns = (std::atan2(p.b, p.a) - angle) / (2 * M_PI);
        const double normal = angle + (2 * std::floor(turns * blades) + 1) * M_PI / blades;
        const double ahead = p.a * std::cos(normal) + p.b * std::sin(normal);
        return curvature == 0 ? ahead / std::cos(M_PI / blades) : OnArc(p, ahead);
    }

    double OnArc(const AperturePoint& p, double ahead) const
    {
        const double radius = 1 / curvature, half = std::sin(M_PI / blades);
        const double behind = std::sqrt(radius * radius - half * half) - std::cos(M_PI / blades);
        const double along = behind * ahead, square = p.a * p.a + p.b * p.b;
        const double root = std::sqrt(along * along + square * (radius * radius - behind * behind));
        return (along + root) / (radius * radius - behind * behind);
    }
};

std::ostream& operator<<(std::ostream& out, const Outline& o)
{
    return out << o.blades << " blades turned by " << o.angle << ", curvature " << o.curvature;
}

class ApertureOutline : public testing::TestWithParam<Outline>
{
};

INSTANTIATE_TEST_SUITE_P(All, ApertureOutline,
                         testing::Values(Outline{0, 0}, Outline{3, 0}, Outline{3, 1.3}, Outline{4, M_PI / 4}, Outline{5, -0.7},
                                         Outline{6, 0}, Outline{7, 100}, Outline{8, 0.2}, Outline{60, 0}, Outline{3, 0.3, 1},
                                         Outline{3, 0, 0.4}, Outline{5, 2, 0.05}, Outline{7, -1, 0.7}, Outline{9, 0, 1e-9},
                                         Outline{1000, 0, 0.5}));

TEST_P(ApertureOutline, MapsTheSquareIntoTheOutlineAndItsRimOntoTheEdge)
{
    const Aperture aperture = GetParam().Make();
    const int n = 256;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
        {
            const double u = std::min(double(i) / n, nearlyOne), v = std::min(double(j) / n, nearlyOne);
            const AperturePoint p = aperture(u, v);
            const double square = std::max(std::fabs(2 * u - 1), std::fabs(2 * v - 1));
            ASSERT_NEAR(GetParam().Size(p), square, GetParam().Tolerance()) << "(u, v) = (" << u << ", " << v << ") went to " << p;
        }
}

TEST_P(ApertureOutline, TheMapPreservesAreaEverywhere)
{
    const Aperture aperture = GetParam().Make();
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1 - 1e-6);
    const double h = 1e-7;
    int creases = 0;
    for (int i = 0; i < 100000; ++i)
    {
        const double u = unit(random), v = unit(random);
        const AperturePoint p = aperture(u, v), q = aperture(u + h, v), r = aperture(u, v + h);
        const double jacobian = ((q.a - p.a) * (r.b - p.b) - (q.b - p.b) * (r.a - p.a)) / (h * h);
        // difference quotients fail across a crease
        if (std::fabs(jacobian - GetParam().Area()) > 1e-4)
            ++creases;
    }
    EXPECT_LE(creases, GetParam().curvature == 0 ? 10 : 40) << "of 100000 places";
}

TEST_P(ApertureOutline, RandomPointsFillItUniformly)
{
    const int rings = 8, sectors = GetParam().blades == 0 ? 12 : std::min(GetParam().blades, 30);
    const int edges = GetParam().blades == 0 ? 12 : GetParam().blades;
    const Aperture aperture = GetParam().Make();
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<double> count(rings * sectors), probability(rings * sectors);
    for (int e = 0; e < edges; ++e)
        for (int r = 0; r < rings; ++r)
            probability[r * sectors + e % sectors] += 1.0 / (rings * edges);
    for (int i = 0; i < 200000; ++i)
    {
        const AperturePoint p = aperture(unit(random), unit(random));
        const double turns = (std::atan2(p.b, p.a) - GetParam().angle) / (2 * M_PI);
        const int edge = int((turns - std::floor(turns)) * edges) % edges;
        const int ring = std::min(int(Square(GetParam().Size(p)) * rings), rings - 1);
        ++count[ring * sectors + edge % sectors];
    }
    EXPECT_GT(ChiSquareP(count, probability), 1e-5);
}

TEST_P(ApertureOutline, NeighboursStayNeighbours)
{
    const Aperture aperture = GetParam().Make();
    const int n = 1000;
    const double greatest = 6.0 / n;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
        {
            const double u = (i + 0.5) / n, v = (j + 0.5) / n;
            const AperturePoint p = aperture(u, v);
            const AperturePoint q = aperture(std::min(u + 1.0 / n, nearlyOne), v);
            const AperturePoint r = aperture(u, std::min(v + 1.0 / n, nearlyOne));
            ASSERT_LT(std::hypot(q.a - p.a, q.b - p.b), greatest) << "u " << u << ", v " << v;
            ASSERT_LT(std::hypot(r.a - p.a, r.b - p.b), greatest) << "u " << u << ", v " << v;
        }
}

TEST_P(ApertureOutline, DensityIsTheInverseAreaInsideAndZeroOutside)
{
    const Aperture aperture = GetParam().Make();
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> side(-1, 1);
    const double tolerance = GetParam().Tolerance();
    for (int i = 0; i < 20000; ++i)
    {
        const AperturePoint p{side(random), side(random)};
        const double size = GetParam().Size(p);
        if (size < 1 - tolerance)
        {
            ASSERT_NEAR(aperture.Density(p) * GetParam().Area(), 1, 2 * tolerance + 1e-12) << p;
        }
        else if (size > 1 + tolerance)
        {
            ASSERT_EQ(aperture.Density(p), 0) << p;
        }
    }
}

TEST(ApertureSqueezed, NarrowsWidthOrHeight)
{
    const Aperture shape = Aperture::Polygon(5, 0.3, 0.5);
    for (const double ratio : {0.4, 1.0, 2.5})
    {
        const double width = std::min(1.0, 1 / ratio), height = std::min(1.0, ratio);
        const Aperture oval = Aperture::Squeezed(shape, ratio);
        for (int i = 0; i < 1000; ++i)
        {
            const double u = (i + 0.5) / 1000, v = std::fmod(0.618 * i, 1.0);
            const AperturePoint p = shape(u, v), q = oval(u, v);
            ASSERT_EQ(q.a, width * p.a);
            ASSERT_EQ(q.b, height * p.b);
            ASSERT_NEAR(oval.Density(q) * width * height, shape.Density(p), 1e-12);
        }
        EXPECT_EQ(oval.Density({1.01 * width, 0}), 0);
        EXPECT_EQ(oval.Density({0, 1.01 * height}), 0);
        EXPECT_EQ(oval.BoundingRadius(), 1);
    }
    for (const double ratio : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(Aperture::Squeezed(shape, ratio), std::invalid_argument) << ratio;
}

TEST(ApertureGraded, FollowsItsBrightnessLaw)
{
    for (const double amount : {-0.75, -0.2, 0.4, 0.8})
        for (const Outline& outline : {Outline{0, 0}, Outline{5, 0.3}, Outline{3, 1, 0.6}})
        {
            const Aperture aperture = Aperture::Graded(outline.Make(), amount);
            const double n = std::fabs(amount) / (1 - std::fabs(amount));
            const auto law = [&](double size) { return (n + 1) * (amount > 0 ? std::pow(size, 2 * n) : std::pow(1 - size * size, n)); };
            const int count = 90000;
            int within[3] = {};
            for (int i = 0; i < count; ++i)
            {
                const AperturePoint p = aperture((i + 0.5) / count, std::fmod(0.6180339887498949 * i, 1.0));
                const double size = outline.Size(p);
                ASSERT_LT(size, 1 + outline.Tolerance());
                for (int k = 0; k < 3; ++k)
                    within[k] += size < 0.25 * (k + 1);
                // the law is steep at the rim
                const double least = law(std::max(0.0, size - outline.Tolerance()));
                const double most = law(std::min(1.0, size + outline.Tolerance()));
                const double brightness = aperture.Density(p) * outline.Area();
                if (size < 1 - 2 * outline.Tolerance())  // rounding decides at the rim
                {
                    ASSERT_GE(brightness, std::min(least, most) - 1e-3 * (n + 1)) << p;
                    ASSERT_LE(brightness, std::max(least, most) + 1e-3 * (n + 1)) << p;
                }
            }
            for (int k = 0; k < 3; ++k)
            {
                const double square = std::pow(0.25 * (k + 1), 2);
                const double light = amount > 0 ? std::pow(square, n + 1) : 1 - std::pow(1 - square, n + 1);
                EXPECT_NEAR(within[k] / double(count), light, 1e-3) << amount << ": " << outline;
            }
        }
}

TEST(ApertureGraded, RefusesOtherShapesAndAmounts)
{
    for (double amount : {-1.0, 1.0, std::nan("")})
        EXPECT_THROW(Aperture::Graded(Aperture::Disc(), amount), std::invalid_argument) << amount;
    EXPECT_THROW(Aperture::Graded(Aperture::Picture([](double, double) { return 1.0; }), 0.5), std::invalid_argument);
}

TEST(ApertureDisc, DirectionsAreKept)
{
    const Aperture disc = Aperture::Disc();
    EXPECT_NEAR(disc(nearlyOne, 0.5).a, 1, 1e-12);
    EXPECT_NEAR(disc(0, 0.5).a, -1, 1e-12);
    EXPECT_NEAR(disc(0.5, nearlyOne).b, 1, 1e-12);
    EXPECT_NEAR(disc(0.5, 0).b, -1, 1e-12);
    EXPECT_NEAR(disc(0, 0).a, -std::sqrt(0.5), 1e-12);
    EXPECT_EQ(disc(0.5, 0.5).a, 0);
    EXPECT_EQ(disc(0.5, 0.5).b, 0);
}

TEST(AperturePolygon, HasItsCornersOnTheUnitCircle)
{
    // corners: the outermost of 4 x 10^4 points per side
    for (const Outline& outline : {Outline{3, 0.4}, Outline{5, -2}, Outline{Aperture::maxBlades, 0.001}})
    {
        const Aperture aperture = outline.Make();
        double farthest = 0, direction = 0;
        for (int i = 0; i < 40000; ++i)
            for (const AperturePoint& p :
                 {aperture(i / 4e4, 0), aperture(i / 4e4, nearlyOne), aperture(0, i / 4e4), aperture(nearlyOne, i / 4e4)})
                if (std::hypot(p.a, p.b) > farthest)
                {
                    farthest = std::hypot(p.a, p.b);
                    direction = std::atan2(p.b, p.a);
                }
        EXPECT_NEAR(farthest, 1, 1e-4) << outline;
        const double corner = (direction - outline.angle) / (2 * M_PI) * outline.blades;
        EXPECT_NEAR(corner, std::round(corner), 1e-4 * outline.blades) << outline;
    }
}

TEST(AperturePolygon, TurnsFromRightToUp)
{
    const Aperture triangle = Aperture::Polygon(3, M_PI / 2);
    double top = -2, bottom = 2;
    for (int i = 0; i < 1000; ++i)
        for (double rim : {0.0, nearlyOne})
            for (const AperturePoint& p : {triangle(i / 1000.0, rim), triangle(rim, i / 1000.0)})
            {
                top = std::max(top, p.b);
                bottom = std::min(bottom, p.b);
            }
    EXPECT_NEAR(top, 1, 0.01);
    EXPECT_NEAR(bottom, -0.5, 1e-12);
}

TEST(AperturePolygon, RefusesImpossibleDiaphragms)
{
    for (int blades : {-1, 0, 1, 2, Aperture::maxBlades + 1, std::numeric_limits<int>::max()})
        EXPECT_THROW(Aperture::Polygon(blades, 0), std::invalid_argument) << blades;
    for (double angle : {std::numeric_limits<double>::infinity(), std::nan("")})
        EXPECT_THROW(Aperture::Polygon(6, angle), std::invalid_argument) << angle;
    for (double curvature : {-0.1, 1.1, std::nan("")})
        EXPECT_THROW(Aperture::Polygon(6, 0, curvature), std::invalid_argument) << curvature;
    try
    {
        Aperture::Polygon(2, 0);
    }
    catch (const std::invalid_argument& error)
    {
        const std::string text = error.what();
        EXPECT_NE(text.find("Found: 2."), std::string::npos) << text;
        EXPECT_NE(text.find("Allowed: 3 to 1000."), std::string::npos) << text;
    }
}

} // namespace
} // namespace tilt_lens
