// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The reconstruction: what has no noise stays, noise goes, edges remain, and it says what is left.

#include "tilt_lens/reconstruction.h"

#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

constexpr int kFrom = -Surroundings::kBorder, kTo = int(kCell) + Surroundings::kBorder;

/// A grey pixel at (x, y) with Gaussian noise of the given variance, as its samples would tell.
Estimate Noisy(double truth, double variance, std::mt19937& random)
{
    std::normal_distribution<double> normal(0.0, std::sqrt(variance / 2.0));
    const double a = normal(random) * std::sqrt(2.0), b = normal(random) * std::sqrt(2.0);
    Estimate e;
    e.samples = 16.0f;
    for (int c = 0; c < 3; c++)
    {
        e.mean[c] = truth + 0.5 * (a + b);
        e.halves[c] = a - b;
        e.variance[c] = 0.5 * variance;
    }
    return e;
}

Surroundings Make(const std::function<Estimate(int, int)>& pixel)
{
    Surroundings around;
    for (int y = kFrom; y < kTo; y++)
        for (int x = kFrom; x < kTo; x++)
            around.Set(x, y, pixel(x, y));
    return around;
}

struct Errors
{
    double before = 0.0, after = 0.0, claimed = 0.0;
};

/// Mean square errors over the cells of many pictures of noise over `truth`.
Errors ErrorsOf(const std::function<double(int, int)>& truth, double variance)
{
    std::mt19937 random(7);
    Errors errors;
    for (int picture = 0; picture < 200; picture++)
    {
        const Surroundings around = Make([&](int x, int y) { return Noisy(truth(x, y), variance, random); });
        const Rebuilt rebuilt = Rebuild(around, true);
        for (int y = 0; y < int(kCell); y++)
            for (int x = 0; x < int(kCell); x++)
            {
                const int i = y * kCell + x, at = (y - kFrom) * Surroundings::kSide + x - kFrom;
                errors.before += std::pow(around.Means()[0][at] - truth(x, y), 2);
                errors.after += std::pow(rebuilt.mean[0][i] - truth(x, y), 2);
                errors.claimed += rebuilt.remains[i] * around.Noise()[at] / 3.0;
            }
    }
    return errors;
}

TEST(Reconstruction, LeavesPixelsWithoutNoiseAlone)
{
    std::mt19937 random(3);
    const auto picture = [&](int x, int y) { return Noisy(0.01 * x * x + 0.1 * y, 0.0, random); };
    const Surroundings around = Make(picture);
    const Rebuilt rebuilt = Rebuild(around, true);
    for (int y = 0; y < int(kCell); y++)
        for (int x = 0; x < int(kCell); x++)
            EXPECT_NEAR(rebuilt.mean[0][y * kCell + x], picture(x, y).mean[0], 1e-6);
}

TEST(Reconstruction, TakesNoiseOffWhatIsSmoothAndSaysWhatIsLeft)
{
    for (const double variance : {1e-6, 1e-3})
        for (const double slope : {0.0, 0.2 * std::sqrt(variance)})
        {
            const Errors e = ErrorsOf([&](int x, int y) { return 0.5 + slope * (x - y); }, variance);
            EXPECT_LT(e.after, 0.25 * e.before) << variance << ", " << slope;
            EXPECT_GT(e.claimed, 0.5 * e.after) << variance << ", " << slope;
            EXPECT_LT(e.claimed, 0.5 * e.before) << variance << ", " << slope;
        }
}

TEST(Reconstruction, KeepsEdgesThatStandOutOfTheNoise)
{
    const auto edge = [](int x, int y) { return x + 0.4 * y > 5.0 ? 0.9 : 0.1; };
    const Errors e = ErrorsOf(edge, 1e-3);
    EXPECT_LT(e.after, 0.5 * e.before);
}

TEST(Reconstruction, DoesNoHarmToDetailThatItCannotTellFromNoise)
{
    const auto detail = [](int x, int y) { return (x + y) % 2 ? 0.53 : 0.5; };
    const Errors e = ErrorsOf(detail, 1e-3);
    EXPECT_LT(e.after, e.before);
    const auto strong = [](int x, int y) { return (x + y) % 2 ? 0.6 : 0.5; };
    const Errors s = ErrorsOf(strong, 1e-4);
    EXPECT_LT(s.after, s.before);
}

TEST(Reconstruction, LooksAtNothingOutsideThePicture)
{
    std::mt19937 random(5);
    const Surroundings around = Make([&](int x, int y)
    {
        return x < 0 || y < 0 ? Estimate() : Noisy(0.5, 1e-3, random);
    });
    const Rebuilt rebuilt = Rebuild(around, true);
    for (const float mean : rebuilt.mean[0])
        EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1e-3));
}

TEST(Reconstruction, TransparencyGoesWithTheColours)
{
    std::mt19937 random(6);
    const Surroundings around = Make([&](int x, int)
    {
        Estimate e = Noisy(0.5, 1e-3, random);
        e.mean[4] = x < 4 ? 1.0f : 0.0f;  // an outline that only transparency shows
        return e;
    });
    const Rebuilt rebuilt = Rebuild(around, true);
    for (int y = 0; y < int(kCell); y++)
        for (int x = 0; x < int(kCell); x++)
            EXPECT_NEAR(rebuilt.mean[4][y * kCell + x], x < 4 ? 1.0 : 0.0, 1e-4);
}

TEST(Reconstruction, WhatIsLeftOfFewNoisyPixelsIsNotKnown)
{
    const auto remains = [](int side)
    {
        std::mt19937 random(9);
        return Rebuild(Make([&](int x, int y)
        {
            const bool noisy = x >= 1 && x < 1 + side && y >= 2 && y < 2 + side;
            return noisy ? Noisy(0.5, 1e-3, random) : Noisy(0.5, 0.0, random);
        }), true).remains[4 * int(kCell) + 3];
    };
    EXPECT_EQ(remains(0), 1.0f);
    EXPECT_EQ(remains(1), 1.0f);
    EXPECT_LT(remains(5), 0.6f);
}

TEST(Reconstruction, NothingIsTooBrightForIt)
{
    for (const float bright : {1e18f, 1e25f, 3e38f, HUGE_VALF})
    {
        std::mt19937 random(8);
        const Surroundings around = Make([&](int x, int y)
        {
            Estimate e = Noisy(0.5, 1e-3, random);
            if (x == 2 && y == 3)
            {
                e.mean.fill(bright);
                e.halves[0] = -bright;
                e.variance[1] = 0.001f * bright * bright;  // from 1e21 on more than a float holds
            }
            return e;
        });
        const Rebuilt rebuilt = Rebuild(around, true);
        for (int i = 0; i < int(kCell * kCell); i++)
        {
            EXPECT_GT(rebuilt.remains[i], 0.0f) << bright << ", pixel " << i;
            EXPECT_LE(rebuilt.remains[i], 1.0f) << bright << ", pixel " << i;
            const bool beside = i != 3 * int(kCell) + 2;
            if (bright < HUGE_VALF && beside)
            {
                EXPECT_TRUE(IsLight(rebuilt.MeanOf(i))) << bright << ", pixel " << i;
                EXPECT_LT(rebuilt.mean[0][i], 1.0f) << bright << ", pixel " << i;
            }
            EXPECT_TRUE(bright < HUGE_VALF || beside || !IsLight(rebuilt.MeanOf(i))) << "pixel " << i;
        }
    }
}

} // namespace
} // namespace tilt_lens
