// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Fixed seeds; the chi-square tests fail for a perfect map with probability 1e-5.

#include "tilt_lens/camera/aperture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "statistics.h"

namespace tilt_lens
{
namespace
{

const double nearlyOne = std::nextafter(1.0, 0.0);

struct Picture
{
    const char* name;
    std::function<double(double u, double v)> weight;
    double tolerance;  ///< relative: cells do not resolve edges
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
    testing::Values(Picture{"constant", [](double, double) { return 3.0; }, 0},
                    Picture{"half lit", [](double u, double) { return u < 0.5 ? 0.0 : 1.0; }, 0},
                    Picture{"upper quarter lit", [](double, double v) { return v < 0.25 ? 1.0 : 0.0; }, 0},
                    Picture{"gradient", [](double u, double v) { return u + 3 * v * v; }, 0},
                    Picture{"ring", [](double u, double v) { return Between(0.3, std::hypot(u - 0.5, v - 0.5), 0.45) ? 1.0 : 0.0; }, 0.01},
                    Picture{"single lit cell",
                            [](double u, double v) { return u >= 37 / 256. && u < 38 / 256. && v >= 201 / 256. && v < 202 / 256.; }, 0},
                    Picture{"last cell", [](double u, double v) { return u > 255 / 256. && v > 255 / 256. ? 1e-30 : 0.0; }, 0},
                    Picture{"two distant spots of 1 and 3", [](double u, double v)
{ return (Between(0.125, u, 0.25) && Between(0.5, v, 0.625)) + 3.0 * (Between(0.75, u, 0.875) && Between(0, v, 0.125)); }, 0},
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
            const double scaled = w * 1e-8;
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
        ASSERT_TRUE(u >= 0 && u <= 1 && v >= 0 && v <= 1) << u << ", " << v;
        ++count[std::min(int(u * bins), bins - 1) * bins + std::min(int(v * bins), bins - 1)];
    }
    if (GetParam().tolerance == 0)
        EXPECT_GT(ChiSquareP(count, probability), 1e-5);
    else
        for (std::size_t i = 0; i < count.size(); ++i)
        {
            const double chance = 5 * std::sqrt(n * probability[i]) + 5;
            EXPECT_NEAR(count[i], n * probability[i], chance + GetParam().tolerance * n * probability[i]) << "bin " << i;
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

TEST(AperturePictureOrientation, MatchesPovRaysBokeh)
{
    const Aperture corner = Aperture::Picture([](double u, double v) { return u > 0.75 && v < 0.25 ? 1.0 : 0.0; });
    for (double u : {0.0, 0.5, nearlyOne})
        for (double v : {0.0, 0.5, nearlyOne})
        {
            const AperturePoint p = corner(u, v);
            EXPECT_TRUE(p.a >= 0.5 && p.a <= 1 && p.b >= 0.5 && p.b <= 1)
                << "(u, v) = (" << u << ", " << v << ") went to (" << p.a << ", " << p.b << ")";
        }
}

TEST(AperturePictureOrientation, ConstantWeightIsTheIdentity)
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
    const auto lit = [](double u, double v) { return u >= 37 / 256. && u < 38 / 256. && v >= 201 / 256. && v < 202 / 256. ? 0.25 : 0.0; };
    const Aperture aperture = Aperture::Picture(lit);
    for (double u : {0.0, 0.25, 0.5, nearlyOne})
        for (double v : {0.0, 0.25, 0.5, nearlyOne})
        {
            EXPECT_NEAR((aperture(u, v).a + 1) / 2, (37 + u) / 256, 1e-12) << u << ", " << v;
            EXPECT_NEAR((1 - aperture(u, v).b) / 2, (201 + v) / 256, 1e-12) << u << ", " << v;
        }
}

TEST(AperturePictureCell, CellWithAnEdgeCountsItsLitPart)
{
    const Aperture aperture = Aperture::Picture([](double u, double v)
    { return Between(80, v * 256, 81) && (Between(20, u * 256, 21) || Between(200, u * 256, 200.75)); });
    EXPECT_NEAR(aperture(1 / 1.75 - 1e-6, 0.5).a, 2 * 21 / 256. - 1, 1e-6);
    EXPECT_NEAR(aperture(1 / 1.75 + 1e-6, 0.5).a, 2 * 200 / 256. - 1, 1e-6);
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
    EXPECT_NEAR((copy(0.25, 0.5).a + 1) / 2, 0.5, 1e-3);
}

} // namespace
} // namespace tilt_lens
