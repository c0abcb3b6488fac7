// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// AVX2 noise equals POV-Ray's functions bit for bit.

#include "speedups/lattice_noise.h"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace speedups
{
namespace
{

using Point = std::array<double, 3>;

class LatticeNoiseTest : public testing::Test
{
  protected:
    LatticeNoiseTest()
    {
        std::mt19937 random(3);
        for (unsigned short& hash : hashes)
            hash = random() % 4096;
        for (double& number : numbers)
            number = std::uniform_real_distribution<double>(-1.0, 1.0)(random);
        noise.SetTables(hashes, numbers, 2);
    }

    void SetUp() override
    {
        if (!noise.Ready())
            GTEST_SKIP() << "This processor has no AVX2.";
    }

    double Corner(const Point& point, int component, bool farX, bool farY, bool farZ) const
    {
        const bool isFar[] = {farX, farY, farZ};
        double offset[3], weight[3];
        int lattice[3];
        for (int axis = 0; axis < 3; axis++)
        {
            const double at = point[axis];
            const int whole = int(at >= 0.0 ? at : at - (1.0 - 1e-10));
            const double part = at - whole, smooth = part * part * (3.0 - 2.0 * part);
            lattice[axis] = ((whole + 10000) & 0xFFF) + isFar[axis];
            offset[axis] = isFar[axis] ? part - 1.0 : part;
            weight[axis] = isFar[axis] ? smooth : 1.0 - smooth;
        }
        const int hash = hashes[hashes[hashes[lattice[0]] ^ lattice[1]] ^ lattice[2]] & 0xFF;
        const double* const from = numbers + 2 * (hash + 4 * component);
        const double blended = from[0] * 0.5 + from[2] * offset[0] + from[4] * offset[1] + from[6] * offset[2];
        return weight[0] * weight[1] * weight[2] * blended;
    }

    double Expected(const Point& point, bool wide) const
    {
        double sum = Corner(point, 0, false, false, false);
        for (int i = 1; i < 8; i++)
            sum += Corner(point, 0, i & 1, i & 2, i & 4);
        sum = wide ? (sum + 1.05242) * 0.48985582 : sum + 0.5;
        return sum < 0.0 ? 0.0 : sum > 1.0 ? 1.0 : sum;
    }

    double ExpectedComponent(const Point& point, int component) const
    {
        double sum = Corner(point, component, false, false, false);
        for (const int i : {1, 3, 2, 6, 7, 5, 4})
            sum += Corner(point, component, i & 1, i & 2, i & 4);
        return sum;
    }

    void ExpectSame(double expected, double found, const Point& point) const
    {
        const bool same = std::memcmp(&expected, &found, sizeof found) == 0 || (std::isnan(expected) && std::isnan(found));
        EXPECT_TRUE(same) << found << " instead of " << expected << " at " << point[0] << ", " << point[1] << ", " << point[2];
    }

    void ExpectSameAt(const Point& point)
    {
        for (const bool wide : {false, true})
            ExpectSame(Expected(point, wide), noise.At(point.data(), wide), point);
        Point vector = point;
        noise.VectorAt(vector.data(), vector.data());
        for (int component = 0; component < 3; component++)
            ExpectSame(ExpectedComponent(point, component), vector[component], point);
    }

    unsigned short hashes[LatticeNoise::kHashes];
    double numbers[2 * LatticeNoise::kNumbers];
    LatticeNoise noise;
};

TEST_F(LatticeNoiseTest, EqualsPovRaysNoiseAtAnyPoint)
{
    std::mt19937 random(4);
    for (const double size : {1e-12, 0.3, 1.0, 10.0, 1e4, 1e8})
        for (int i = 0; i < 20000; i++)
        {
            std::uniform_real_distribution<double> along(-size, size);
            ExpectSameAt({along(random), along(random), along(random)});
        }
}

TEST_F(LatticeNoiseTest, EqualsPovRaysNoiseAtCornersFacesAndExtremes)
{
    const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
    const double infinite = std::numeric_limits<double>::infinity();
    const double all[] = {0.0,           -0.0,  1.0,         -1.0,   2.0,   -10000.0, -10001.0,  4095.0,      4096.0,
                          0.5,           -0.5,  1.0 - 1e-11, -1e-11, -1e-9, 1e-10,    tiny,      -tiny,       2147473647.0,
                          -2147483648.0, 1e300, -1e300,      huge,   -huge, infinite, -infinite, std::nan("")};
    for (const double x : all)
        for (const double y : all)
            for (const double z : all)
                ExpectSameAt({x, y, z});
}

} // namespace
} // namespace speedups
