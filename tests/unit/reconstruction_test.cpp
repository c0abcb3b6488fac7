// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/reconstruction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "picture_edges.h"

namespace tilt_lens
{
namespace
{

constexpr int kSide = int(Settings::blockSide);

struct Pixel
{
    Radiance mean{};
    double noise = 0.0;
};

Pixel Noisy(double truth, double variance, std::mt19937& random)
{
    std::normal_distribution<double> normal(0.0, std::sqrt(variance));
    const double error = 0.5 * (normal(random) + normal(random));
    Pixel pixel;
    for (int c = 0; c < 3; c++)
        pixel.mean[c] = truth + error;
    pixel.noise = 3 * 0.5 * variance;
    return pixel;
}

PaddedBlock Make(const std::function<Pixel(int, int)>& pixel, const PictureEdges& edges = kFarEdges)
{
    std::array<BlockStatistics, 9> blocks;
    std::array<const BlockStatistics*, 9> places;
    for (int i = 0; i < 9; i++)
    {
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++)
            {
                const Pixel p = pixel(x + (i % 3 - 1) * kSide, y + (i / 3 - 1) * kSide);
                blocks[i].Set(x, y, p.mean, p.noise, 0.0, 2);
            }
        places[i] = &blocks[i];
    }
    return PaddedBlock(places, edges);
}

struct Errors
{
    double before = 0.0, after = 0.0, noise = 0.0, claimed = 0.0, bound = 0.0;
};

Errors ErrorsOf(const std::function<double(int, int)>& truth, double variance)
{
    std::mt19937 random(7);
    Errors errors;
    for (int picture = 0; picture < 200; picture++)
    {
        const PaddedBlock around = Make([&](int x, int y) { return Noisy(truth(x, y), variance, random); });
        const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
        double noise = 0.0, risk = 0.0;
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++)
            {
                const int i = y * kSide + x, at = PaddedBlock::At(x, y);
                errors.before += std::pow(around.Mean(0)[at] - truth(x, y), 2);
                errors.after += std::pow(rebuilt.mean[0][i] - truth(x, y), 2);
                noise += rebuilt.residualVarianceRatio[i] * around.Noise()[at] / 3.0;
                risk += rebuilt.risk * around.Noise()[at] / 3.0;
                errors.bound += rebuilt.residualVarianceBound[i] * around.Noise()[at] / 3.0;
            }
        errors.noise += noise;
        errors.claimed += std::max(noise, risk);  // as in the summary of this picture
    }
    return errors;
}

TEST(Reconstruction, LeavesPixelsWithoutNoiseAlone)
{
    std::mt19937 random(3);
    const auto picture = [&](int x, int y) { return Noisy(0.01 * x * x + 0.1 * y, 0.0, random); };
    const PaddedBlock around = Make(picture);
    const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
    for (int y = 0; y < kSide; y++)
        for (int x = 0; x < kSide; x++)
            EXPECT_NEAR(rebuilt.mean[0][y * kSide + x], picture(x, y).mean[0], 1e-6);
}

TEST(Reconstruction, RemovesNoiseOfSmoothAreasAndReportsTheRest)
{
    for (const double variance : {1e-6, 1e-3})
        for (const double slope : {0.0, 0.2 * std::sqrt(variance)})
        {
            const Errors e = ErrorsOf([&](int x, int y) { return 0.5 + slope * (x - y); }, variance);
            EXPECT_LT(e.after, 0.25 * e.before) << variance << ", " << slope;
            EXPECT_GT(e.claimed, 0.8 * e.after) << variance << ", " << slope;
            // too little by a fifth, because the weights depend on the noise; in large pictures the risk seldom makes up for it
            EXPECT_GT(e.noise, 0.75 * e.after) << variance << ", " << slope;
            EXPECT_LT(e.claimed, 1.2 * e.after) << variance << ", " << slope;
            EXPECT_GT(e.bound, e.claimed) << variance << ", " << slope;
            EXPECT_LT(e.bound, 0.5 * e.before) << variance << ", " << slope;
        }
}

// Waves of 100 to 6 pixels, a tenth to ten deviations of the noise.
TEST(Reconstruction, ReportsRemainingNoiseAndBias)
{
    double least = 1.0, greatest = 0.0;
    for (const double length : {100.0, 40.0, 15.0, 6.0})
        for (const double height : {0.1, 1.0, 10.0})
        {
            const double variance = 1e-4, amplitude = height * std::sqrt(variance);
            const auto waves = [&](int x, int y)
            { return 0.5 + amplitude * std::sin(6.2832 * x / length) * std::sin(6.2832 * y / length); };
            const Errors e = ErrorsOf(waves, variance);
            EXPECT_GT(e.bound, 0.75 * e.after) << length << ", " << height;
            EXPECT_LT(e.bound, 2.2 * e.after) << length << ", " << height;
            // too little by up to a third, because the weights depend on the noise
            EXPECT_GT(e.claimed, 0.6 * e.after) << length << ", " << height;
            EXPECT_LT(e.claimed, 1.2 * e.after) << length << ", " << height;
            least = std::min(least, e.after / e.before);
            greatest = std::max(greatest, e.after / e.before);
        }
    EXPECT_LT(least, 1.0 / Settings().greatestRisk) << "the least risk that counts";
    EXPECT_GT(greatest, 0.5);
}

TEST(Reconstruction, KeepsEdgesAboveTheNoise)
{
    const auto edge = [](int x, int y) { return x + 0.4 * y > 5.0 ? 0.9 : 0.1; };
    const Errors e = ErrorsOf(edge, 1e-3);
    EXPECT_LT(e.after, 0.6 * e.before);
}

TEST(Reconstruction, KeepsDetailThatResemblesNoise)
{
    const auto detail = [](int x, int y) { return (x + y) % 2 ? 0.53 : 0.5; };
    const Errors e = ErrorsOf(detail, 1e-3);
    EXPECT_LT(e.after, e.before);
    const auto strong = [](int x, int y) { return (x + y) % 2 ? 0.6 : 0.5; };
    const Errors s = ErrorsOf(strong, 1e-4);
    EXPECT_LT(s.after, 1.00001 * s.before);  // blurring filters keep a trace of weight
}

TEST(Reconstruction, MirrorsBlocksForUnknownNeighbours)
{
    for (int known = 0; known < 256; known++)
    {
        std::array<BlockStatistics, 9> blocks;
        std::array<const BlockStatistics*, 9> places{};
        for (int i = 0; i < 9; i++)
        {
            for (int y = 0; y < kSide; y++)
                for (int x = 0; x < kSide; x++)
                    blocks[i].Set(x, y, {1000.0 * i + 10.0 * y + x, 0.0, 0.0, 0.0, 0.0}, 0.0, 0.0, 2);
            if (i == 4 || known >> (i < 4 ? i : i - 1) & 1)
                places[i] = &blocks[i];
        }
        const PaddedBlock around(places, kFarEdges);
        for (int y = -PaddedBlock::kBorder; y < kSide + PaddedBlock::kBorder; y++)
            for (int x = -PaddedBlock::kBorder; x < kSide + PaddedBlock::kBorder; x++)
            {
                const auto blockOf = [](int at) { return at < 0 ? 0 : at < kSide ? 1 : 2; };
                const auto mirror = [](int& at) { at = at < 0 ? -1 - at : at < kSide ? at : 2 * kSide - 1 - at; };
                int u = x, v = y;
                if (!places[3 * blockOf(v) + blockOf(u)])
                {
                    const bool sameRow = places[3 * blockOf(v) + 1], sameColumn = places[3 + blockOf(u)];
                    if (sameRow || !sameColumn)
                        mirror(u);
                    if (!sameRow)
                        mirror(v);
                }
                const int block = 3 * blockOf(v) + blockOf(u);
                const double expected = 1000.0 * block + 10.0 * ((v + kSide) % kSide) + (u + kSide) % kSide;
                ASSERT_EQ(around.Mean(0)[PaddedBlock::At(x, y)], expected) << known << ": " << x << ", " << y;
            }
    }
}

TEST(Reconstruction, RepeatsPixelsBeyondThePicturesEdge)
{
    BlockStatistics block;
    for (int y = 0; y < 3; y++)
        for (int x = 0; x < 5; x++)
            block.Set(x, y, {10.0 * y + x, 0.0, 0.0, 0.0, 0.0}, 10.0 * y + x, 0.0, 2);
    block.RepeatEdges(5, 3);
    for (int y = 0; y < kSide; y++)
        for (int x = 0; x < kSide; x++)
            for (const BlockPlane* plane : {&block.Mean(0), &block.Noise()})
                EXPECT_EQ((*plane)[y * kSide + x], 10.0f * std::min(y, 2) + std::min(x, 4));
}

TEST(Reconstruction, ThePictureIsMirroredAtItsEdges)
{
    constexpr PictureEdges edges{0, -20, 20, 12};
    const PaddedBlock around = Make([](int x, int y) { return Pixel{{10.0 + x + 100.0 * y}, 20.0 + x + 100.0 * y}; }, edges);
    for (int y = -PaddedBlock::kBorder; y < 12 + PaddedBlock::kBorder; y++)
        for (int x = -PaddedBlock::kBorder; x < kSide + PaddedBlock::kBorder; x++)
        {
            const int u = x < 0 ? -1 - x : x < 20 ? x : 39 - x, v = y < 12 ? y : 23 - y, at = PaddedBlock::At(x, y);
            ASSERT_EQ(around.Mean(0)[at], 10.0f + u + 100.0f * v) << x << ", " << y;
            ASSERT_EQ(around.Noise()[at], 20.0f + u + 100.0f * v) << x << ", " << y;
        }
}

/// However many pixels of the last block are in the picture.
TEST(Reconstruction, LeavesLittleMoreNoiseAtThePicturesEdges)
{
    std::mt19937 random(11);
    for (const int height : {2, 5, 12, kSide})
    {
        double edge = 0.0, before = 0.0;
        for (int picture = 0; picture < 200; picture++)
        {
            const PictureEdges edges{-kSide, -kSide, 2 * kSide, height};
            const PaddedBlock around = Make([&](int, int) { return Noisy(0.5, 0.01, random); }, edges);
            const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
            for (int x = 0; x < kSide; x++)
            {
                edge += std::pow(rebuilt.mean[0][(height - 1) * kSide + x] - 0.5, 2);
                before += std::pow(around.Mean(0)[PaddedBlock::At(x, height - 1)] - 0.5, 2);
            }
        }
        EXPECT_LT(edge, 0.25 * before) << height;
    }
}

TEST(Reconstruction, LampsLeaveDarkPixelsBesideThemUnharmed)
{
    for (const double lamp : {10.0, 1e3, 1e6})
        for (const double dark : {0.0, 0.5})
        {
            std::mt19937 random(4);
            const PaddedBlock around = Make([&](int x, int y)
            {
                const bool lit = x >= 3 && x < 5 && y >= 2 && y < 5;
                return lit ? Noisy(lamp, 0.01 * lamp * lamp, random) : Noisy(dark, 1e-3 * dark, random);
            });
            const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
            for (int y = 0; y < kSide; y++)
                for (int x = 0; x < kSide; x++)
                {
                    const bool lit = x >= 3 && x < 5 && y >= 2 && y < 5;
                    const double error = std::abs(rebuilt.mean[0][y * kSide + x] - (lit ? lamp : dark));
                    EXPECT_LT(error, lit ? 0.3 * lamp : 0.1 * dark + 1e-6) << lamp << ", " << dark << ": " << x << ", " << y;
                }
        }
}

TEST(Reconstruction, TransparencyIsFilteredWithTheColours)
{
    std::mt19937 random(6);
    const PaddedBlock around = Make([&](int x, int)
    {
        Pixel e = Noisy(0.5, 1e-3, random);
        e.mean[4] = x < 4 ? 1.0f : 0.0f;
        return e;
    });
    const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
    for (int y = 0; y < kSide; y++)
        for (int x = 0; x < kSide; x++)
            EXPECT_NEAR(rebuilt.mean[4][y * kSide + x], x < 4 ? 1.0 : 0.0, 0.05 * std::sqrt(0.5e-3));
}

TEST(Reconstruction, KeepsColoursAndTransparencyInRange)
{
    std::mt19937 random(11);
    int touched = 0;
    for (int picture = 0; picture < 50; picture++)
    {
        const PaddedBlock around = Make([&](int x, int y)
        {
            Pixel pixel = Noisy(0.5 * std::max(0, x - 3), 1e-2, random);
            for (double& mean : pixel.mean)
                mean = std::max(0.0, mean);
            pixel.mean[4] = std::min(1.0, 0.25 * std::max(0, y + 1));
            return pixel;
        });
        const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
        for (int i = 0; i < kSide * kSide; i++)
        {
            EXPECT_GE(rebuilt.mean[0][i], 0.0f) << i;
            EXPECT_GE(rebuilt.mean[4][i], 0.0f) << i;
            EXPECT_LE(rebuilt.mean[4][i], 1.0f) << i;
            touched += rebuilt.mean[0][i] == 0.0f || rebuilt.mean[4][i] == 1.0f;
        }
    }
    EXPECT_GT(touched, 100) << "there was nothing to hold back";
}

TEST(Reconstruction, ReportsMoreVarianceBesideAnEdge)
{
    constexpr int column = 8;
    constexpr double variance = 1e-4;
    std::mt19937 random(9);
    struct Left
    {
        double claimed = 0.0, measured = 0.0;  ///< share of the noise
    };
    const auto leftBeside = [&](double step)
    {
        Left left;
        for (int picture = 0; picture < 64; picture++)
        {
            const auto edge = [&](int x, int) { return Noisy(x < column ? 0.2 : 0.2 + step, variance, random); };
            const ReconstructedBlock rebuilt = Reconstruct(Make(edge), Settings());
            for (int i = column; i < kSide * kSide; i += kSide)
            {
                left.claimed += rebuilt.residualVarianceRatio[i] / (64 * kSide);
                left.measured += Square(rebuilt.mean[0][i] - 0.2 - step) / (0.5 * variance) / (64 * kSide);
            }
        }
        return left;
    };
    const Left even = leftBeside(0.0), edge = leftBeside(0.5);
    EXPECT_LT(even.claimed, 0.2);
    EXPECT_GT(edge.claimed, 1.5 * even.claimed) << "filters across the edge have no weight";
    EXPECT_GT(edge.measured, 1.5 * even.measured);
    EXPECT_GT(edge.claimed, 0.8 * edge.measured);
    EXPECT_GT(even.claimed, 0.8 * even.measured);
}

TEST(Reconstruction, AcceptsAnyBrightness)
{
    for (const float bright : {1e18f, 1e25f, 3e38f, HUGE_VALF})
    {
        std::mt19937 random(8);
        const PaddedBlock around = Make([&](int x, int y)
        {
            Pixel e = Noisy(0.5, 1e-3, random);
            if (x == 2 && y == 3)
            {
                e.mean.fill(bright);
                e.noise = 0.001f * bright * bright;  // not a finite float from 1e21 on
            }
            return e;
        });
        const ReconstructedBlock rebuilt = Reconstruct(around, Settings());
        for (int i = 0; i < int(Settings::blockSide * Settings::blockSide); i++)
        {
            EXPECT_GT(rebuilt.residualVarianceRatio[i], 0.0f) << bright << ", pixel " << i;
            EXPECT_LE(rebuilt.residualVarianceRatio[i], 1.0001f * rebuilt.residualVarianceBound[i]) << bright << ", pixel " << i;
            EXPECT_LE(rebuilt.residualVarianceBound[i], 1.0f) << bright << ", pixel " << i;
            const bool beside = i != 3 * kSide + 2;
            if (bright < HUGE_VALF && beside)
            {
                EXPECT_TRUE(IsFinite(rebuilt.MeanOf(i))) << bright << ", pixel " << i;
                EXPECT_LT(rebuilt.mean[0][i], 1.0f) << bright << ", pixel " << i;
            }
            EXPECT_TRUE(bright < HUGE_VALF || beside || !IsFinite(rebuilt.MeanOf(i))) << "pixel " << i;
        }
    }
}

}  // namespace
}  // namespace tilt_lens
