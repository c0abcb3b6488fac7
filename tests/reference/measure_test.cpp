// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "measure.h"

namespace
{

using namespace witness;

Picture Grey(int width, int height, double value)
{
    return {width, height, std::vector<double>(static_cast<std::size_t>(width) * height * 3, value)};
}

Picture Noisy(int width, int height, double deviation, unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> noise(0.5, deviation);
    Picture picture = Grey(width, height, 0.0);
    for (double& value : picture.values)
        value = noise(generator);
    return picture;
}

Reference NoisyReference(double deviation)
{
    std::vector<Picture> batches;
    for (unsigned seed = 100; seed < 116; ++seed)
        batches.push_back(Noisy(64, 48, deviation, seed));
    return Average(batches);
}

TEST(Measure, ReportsPlainFigures)
{
    const Picture reference = Grey(16, 8, 0.25);
    Picture picture = reference;
    picture.values[(3 * 16 + 5) * 3 + 1] += 0.5;
    const Figures figures = Measure(picture, reference);
    EXPECT_DOUBLE_EQ(figures.rootMeanSquare, std::sqrt(0.25 / (16 * 8 * 3)));
    EXPECT_DOUBLE_EQ(figures.signedMean, 0.5 / (16 * 8 * 3));
    EXPECT_DOUBLE_EQ(figures.largest, 0.5);
    EXPECT_DOUBLE_EQ(figures.largestLocalMean, 0.5 / 64);
    EXPECT_EQ(figures.different, 1u);
    ASSERT_EQ(figures.worst.size(), 1u);
    EXPECT_EQ(figures.worst[0].x, 5);
    EXPECT_EQ(figures.worst[0].y, 3);
}

TEST(Measure, FiniteMeansFinite)
{
    Picture picture = Grey(4, 4, 1.0);
    EXPECT_TRUE(IsFinite(picture));
    picture.values[7] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(IsFinite(picture));
    picture.values[7] = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(IsFinite(picture));
}

TEST(Measure, LimitsFollowSidak)
{
    EXPECT_NEAR(SidakLimit(0.05, 1.0), 1.959964, 1e-5);
    EXPECT_NEAR(SidakLimit(0.01, 1.0), 2.575829, 1e-5);
    // 1 - (1 - 0.05)^(1/1000) = 5.12920e-5, two-sided
    EXPECT_NEAR(std::erfc(SidakLimit(0.05, 1000.0) / std::sqrt(2.0)), -std::expm1(std::log1p(-0.05) / 1000.0), 1e-12);
}

TEST(Measure, AverageGivesTheStandardErrorOfTheMean)
{
    const Reference reference = NoisyReference(0.02);
    double squares = 0.0;
    for (const double error : reference.error.values)
        squares += error * error;
    EXPECT_NEAR(std::sqrt(squares / reference.error.Size()), 0.02 / std::sqrt(16.0), 2e-4);
    EXPECT_EQ(reference.batches, 16);
}

ZTestSettings Floor(double floor)
{
    ZTestSettings settings;
    settings.floor = floor;
    return settings;
}

TEST(ZTest, MoreOfTheSameNoisePasses)
{
    const Reference reference = NoisyReference(0.01);
    for (unsigned seed = 1; seed <= 20; ++seed)
    {
        const ZTest test = TestNoisy(Noisy(64, 48, 0.01, seed), reference, Floor(0.005));
        EXPECT_TRUE(test.passed) << seed << ": " << test.passing << ' ' << test.largestBox;
    }
}

TEST(ZTest, ABiasUnderTheNoiseFails)
{
    const Reference reference = NoisyReference(0.01);
    Picture picture = Noisy(64, 48, 0.01, 1);
    for (int y = 16; y < 24; ++y)
        for (int x = 32; x < 40; ++x)
            picture.values[(y * 64 + x) * 3] += 0.01;  // one standard deviation, in one box and channel
    const ZTest test = TestNoisy(picture, reference, Floor(0.005));
    EXPECT_GE(test.passing, 0.9975);
    EXPECT_FALSE(test.passed);
}

TEST(ZTest, AFewWrongPixelsFail)
{
    const Reference reference = NoisyReference(0.01);
    Picture picture = Noisy(64, 48, 0.01, 1);
    for (int i = 0; i < 10; ++i)
        picture.values[i * 999] += i % 2 == 0 ? 0.5 : -0.5;
    const ZTest test = TestNoisy(picture, reference, Floor(0.005));
    EXPECT_LT(test.passing, 0.9975);
    EXPECT_FALSE(test.passed);
}

TEST(PictureFile, ReferenceSurvivesItsFile)
{
    const Reference written = NoisyReference(0.01);
    const std::string path = (std::filesystem::path(testing::TempDir()) / "reference.exr").string();
    WriteReference(path, written);
    const Reference read = ReadReference(path);
    ASSERT_TRUE(read.mean.SameSize(written.mean));
    EXPECT_EQ(read.batches, 16);
    for (std::size_t i = 0; i < written.mean.Size(); ++i)
    {
        EXPECT_NEAR(read.mean.values[i], written.mean.values[i], 1e-7);
        EXPECT_NEAR(read.error.values[i], written.error.values[i], 1e-3 * written.error.values[i] + 1e-7);
    }
    std::filesystem::remove(path);
}

} // namespace
