// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The aperture's maps: where points land, that equal areas stay equal, that strata stay whole.
// Seeds are fixed; a chi-square test fails a perfect map with probability 1e-5.

#include "tilt_lens/aperture.h"

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

namespace tilt_lens
{

std::ostream& operator<<(std::ostream& out, const AperturePoint& p)
{
    return out << "(" << p.a << ", " << p.b << ")";
}

namespace
{

const double nearlyOne = std::nextafter(1.0, 0.0);

double Square(double x)
{
    return x * x;
}

/// Probability that points drawn with these bin probabilities fit the counts no better.
double ChiSquareP(const std::vector<double>& count, const std::vector<double>& probability)
{
    double total = 0, chi = 0;
    int used = 0;
    for (double c : count)
        total += c;
    for (std::size_t i = 0; i < count.size(); ++i)
    {
        const double expected = probability[i] * total;
        if (expected == 0)
        {
            EXPECT_EQ(count[i], 0) << "bin " << i << " should be empty";
            continue;
        }
        chi += Square(count[i] - expected) / expected;
        ++used;
    }
    if (used == 1)
        return 1;  // no point fell outside the only bin
    const boost::math::chi_squared law(used - 1);
    return boost::math::cdf(complement(law, chi));
}

// ---- disc and polygons ------------------------------------------------------------------------

struct Outline
{
    int blades;  ///< 0: the disc
    double angle;

    Aperture Make() const
    {
        return blades == 0 ? Aperture::Disc() : Aperture::Polygon(blades, angle);
    }

    double Area() const
    {
        return blades == 0 ? M_PI : blades / 2.0 * std::sin(2 * M_PI / blades);
    }

    /// 0 in the middle, 1 on the boundary: the size of the scaled outline through p. Edge by edge,
    /// from the distances of the edges, not from the map's corners.
    double Size(const AperturePoint& p) const
    {
        if (blades == 0)
            return std::hypot(p.a, p.b);
        double size = 0;
        for (int i = 0; i < blades; ++i)
        {
            const double normal = angle + (2 * i + 1) * M_PI / blades;
            size = std::max(size, (p.a * std::cos(normal) + p.b * std::sin(normal)) /
                                      std::cos(M_PI / blades));
        }
        return size;
    }
};

std::ostream& operator<<(std::ostream& out, const Outline& o)
{
    return out << o.blades << " blades turned by " << o.angle;
}

class ApertureOutline : public testing::TestWithParam<Outline>
{
};

INSTANTIATE_TEST_SUITE_P(All, ApertureOutline,
                         testing::Values(Outline{0, 0}, Outline{3, 0}, Outline{3, 1.3},
                                         Outline{4, M_PI / 4}, Outline{5, -0.7}, Outline{6, 0},
                                         Outline{7, 100}, Outline{8, 0.2}, Outline{60, 0}));

TEST_P(ApertureOutline, PointsLieInsideAndTheSquaresRimOnTheBoundary)
{
    const Aperture aperture = GetParam().Make();
    const int n = 256;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
        {
            const double u = std::min(double(i) / n, nearlyOne), v = std::min(double(j) / n, nearlyOne);
            const AperturePoint p = aperture(u, v);
            const double square = std::max(std::fabs(2 * u - 1), std::fabs(2 * v - 1));
            ASSERT_NEAR(GetParam().Size(p), square, 1e-12)
                << "(u, v) = (" << u << ", " << v << ") went to " << p;
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
        // A difference across a crease between two smooth parts is neither part's derivative.
        if (std::fabs(jacobian - GetParam().Area()) > 1e-4)
            ++creases;
    }
    EXPECT_LE(creases, 10) << "of 100000 places";
}

TEST_P(ApertureOutline, RandomPointsFillItUniformly)
{
    // Bins: rings of equal area times sectors, whose areas are those of the polygon's own edges.
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
    // Continuity makes the image of every stratum one piece; a bijection keeps them apart.
    const Aperture aperture = GetParam().Make();
    const int n = 1000;
    const double greatest = 6.0 / n;  // the map stretches by less than 6
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
    // The rim's points at the corners' angles: the outermost of 4 x 10^4 on every side of the square.
    for (const Outline& outline : {Outline{3, 0.4}, Outline{5, -2}, Outline{Aperture::maxBlades, 0.001}})
    {
        const Aperture aperture = outline.Make();
        double farthest = 0, direction = 0;
        for (int i = 0; i < 40000; ++i)
            for (const AperturePoint& p : {aperture(i / 4e4, 0), aperture(i / 4e4, nearlyOne),
                                           aperture(0, i / 4e4), aperture(nearlyOne, i / 4e4)})
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
    // A triangle turned by 90 degrees points up: a corner at (0, 1), an edge at b = -1/2.
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

// ---- pictures ---------------------------------------------------------------------------------

/// A weight function; bins of 1/16 of the lens are compared with its integral over them.
struct Picture
{
    const char* name;
    std::function<double(double u, double v)> weight;
    double tolerance;  ///< of a bin's probability, relative: what 256 cells cannot resolve at an edge
};

std::ostream& operator<<(std::ostream& out, const Picture& p)
{
    return out << p.name;
}

class AperturePicture : public testing::TestWithParam<Picture>
{
};

bool Between(double low, double x, double high)
{
    return low <= x && x < high;
}

const double notANumber = std::nan("");

INSTANTIATE_TEST_SUITE_P(
    All, AperturePicture,
    testing::Values(
        Picture{"constant", [](double, double) { return 3.0; }, 0},
        Picture{"half lit", [](double u, double) { return u < 0.5 ? 0.0 : 1.0; }, 0},
        Picture{"upper quarter lit", [](double, double v) { return v < 0.25 ? 1.0 : 0.0; }, 0},
        Picture{"gradient", [](double u, double v) { return u + 3 * v * v; }, 0},
        Picture{"ring",
                [](double u, double v)
                { return Between(0.3, std::hypot(u - 0.5, v - 0.5), 0.45) ? 1.0 : 0.0; }, 0.01},
        Picture{"single lit cell",
                [](double u, double v)
                { return u >= 37 / 256. && u < 38 / 256. && v >= 201 / 256. && v < 202 / 256.; }, 0},
        Picture{"last cell",
                [](double u, double v) { return u > 255 / 256. && v > 255 / 256. ? 1e-30 : 0.0; }, 0},
        Picture{"two distant spots of 1 and 3",
                [](double u, double v)
                {
                    return (Between(0.125, u, 0.25) && Between(0.5, v, 0.625)) +
                           3.0 * (Between(0.75, u, 0.875) && Between(0, v, 0.125));
                }, 0},
        Picture{"NaN, infinite and negative outside a square",
                [](double u, double v)
                {
                    if (Between(0.25, u, 0.75) && Between(0.25, v, 0.5))
                        return 1.0;
                    return u < 0.25 ? notANumber : u > 0.75 ? -5.0 : v < 0.25 ? HUGE_VAL : -HUGE_VAL;
                }, 0},
        Picture{"enormous weights", [](double u, double) { return u < 0.5 ? 1e308 : 1.7e308; }, 0}));

TEST_P(AperturePicture, RandomPointsFollowTheWeights)
{
    const int bins = 16, fine = 1024, n = 200000;
    const auto& weight = GetParam().weight;
    std::vector<double> probability(bins * bins), count(bins * bins);
    double total = 0;
    for (int i = 0; i < fine; ++i)
        for (int j = 0; j < fine; ++j)
        {
            const double w = weight((i + 0.5) / fine, (j + 0.5) / fine);
            if (!std::isfinite(w) || w <= 0)
                continue;
            const double scaled = w * 1e-8;  // the enormous ones must not overflow
            probability[i * bins / fine * bins + j * bins / fine] += scaled;
            total += scaled;
        }
    for (double& p : probability)
        p /= total;

    const Aperture aperture = Aperture::Picture(weight);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < n; ++i)
    {
        const AperturePoint p = aperture(unit(random), unit(random));
        const double u = (p.a + 1) / 2, v = (1 - p.b) / 2;
        ASSERT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1) << p;
        ++count[std::min(int(u * bins), bins - 1) * bins + std::min(int(v * bins), bins - 1)];
    }
    if (GetParam().tolerance == 0)
        EXPECT_GT(ChiSquareP(count, probability), 1e-5);
    else
        for (std::size_t i = 0; i < count.size(); ++i)
        {
            const double chance = 5 * std::sqrt(n * probability[i]) + 5;
            EXPECT_NEAR(count[i], n * probability[i],
                        chance + GetParam().tolerance * n * probability[i]) << "bin " << i;
        }
}

TEST_P(AperturePicture, RisesWithUAndFallsWithV)
{
    const Aperture aperture = Aperture::Picture(GetParam().weight);
    const int n = 2000;
    for (int i = 0; i < n; ++i)
        for (double other : {0.0, 0.123, 0.5, nearlyOne})
        {
            const double now = double(i) / n, next = std::min((i + 1.0) / n, nearlyOne);
            ASSERT_LT(aperture(now, other).a, aperture(next, other).a) << now << ", " << other;
            ASSERT_GT(aperture(other, now).b, aperture(other, next).b) << other << ", " << now;
        }
}

TEST(AperturePictureOrientation, LiesOverTheLensAsPovRaysBokehDoes)
{
    // Lit where u is large and v small: right and, since v grows downward, up.
    const Aperture corner =
        Aperture::Picture([](double u, double v) { return u > 0.75 && v < 0.25 ? 1.0 : 0.0; });
    for (double u : {0.0, 0.5, nearlyOne})
        for (double v : {0.0, 0.5, nearlyOne})
        {
            const AperturePoint p = corner(u, v);
            EXPECT_TRUE(p.a >= 0.5 && p.a <= 1 && p.b >= 0.5 && p.b <= 1)
                << "(u, v) = (" << u << ", " << v << ") went to " << p;
        }
}

TEST(AperturePictureOrientation, AConstantPictureIsTheSquareItself)
{
    const Aperture square = Aperture::Picture([](double, double) { return 1.0; });
    for (double u : {0.0, 0.1, 0.5, 0.77, nearlyOne})
        for (double v : {0.0, 0.1, 0.5, 0.77, nearlyOne})
        {
            EXPECT_NEAR(square(u, v).a, 2 * u - 1, 1e-6) << u << ", " << v;
            EXPECT_NEAR(square(u, v).b, 1 - 2 * v, 1e-6) << u << ", " << v;
        }
}

TEST(AperturePictureCell, ASingleLitCellIsFilledEvenly)
{
    const auto lit = [](double u, double v)
    { return u >= 37 / 256. && u < 38 / 256. && v >= 201 / 256. && v < 202 / 256. ? 0.25 : 0.0; };
    const Aperture aperture = Aperture::Picture(lit);
    for (double u : {0.0, 0.25, 0.5, nearlyOne})
        for (double v : {0.0, 0.25, 0.5, nearlyOne})
        {
            EXPECT_NEAR((aperture(u, v).a + 1) / 2, (37 + u) / 256, 1e-12) << u << ", " << v;
            EXPECT_NEAR((1 - aperture(u, v).b) / 2, (201 + v) / 256, 1e-12) << u << ", " << v;
        }
}

TEST(AperturePictureError, BlackPicturesAreRefused)
{
    for (double w : {0.0, -1.0, std::nan(""), HUGE_VAL})
        try
        {
            Aperture::Picture([w](double, double) { return w; });
            ADD_FAILURE() << "weight " << w << " made an opening";
        }
        catch (const std::invalid_argument& error)
        {
            const std::string text = error.what();
            for (const char* part : {"lets no light through", "Found: ", "Allowed: ", "Use a pigment"})
                EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
        }
}

TEST(ApertureCopy, CopiesOutliveTheOriginal)
{
    Aperture copy = Aperture::Disc();
    {
        const Aperture original = Aperture::Picture([](double u, double) { return u; });
        copy = original;
        EXPECT_EQ(copy(0.3, 0.6).a, original(0.3, 0.6).a);
    }
    EXPECT_NEAR((copy(0.25, 0.5).a + 1) / 2, 0.5, 1e-3);  // square root of u
}

} // namespace
} // namespace tilt_lens
