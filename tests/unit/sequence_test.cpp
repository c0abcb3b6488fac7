// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Fixed seeds and bounds of stated significance.

#include "tilt_lens/samples/sequence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <vector>

#include <gtest/gtest.h>

#include "statistics.h"

namespace tilt_lens
{
namespace
{

constexpr int dimensions = 4;
using Point = std::array<double, dimensions>;  // lens u, lens v, pixel x, pixel y

Point AsPoint(const SequencePoint& s)
{
    return {s.lensU, s.lensV, s.pixelX, s.pixelY};
}

struct Pixel
{
    std::uint32_t x, y, seed;
};

std::ostream& operator<<(std::ostream& out, const Pixel& p)
{
    return out << "pixel (" << p.x << ", " << p.y << "), seed " << p.seed;
}

const Pixel somePixels[] = {{0, 0, 0},
                            {1, 0, 0},
                            {0, 1, 0},
                            {0, 0, 1},
                            {1919, 1079, 7},
                            {640, 480, 1},
                            {65535, 3, 255},
                            {17, 4000000000u, 9},
                            {4294967295u, 4294967295u, 4294967295u}};

std::vector<Point> Block(const Pixel& p, std::uint32_t first, int count)
{
    const PixelSampler sampler(p.x, p.y, p.seed);
    std::vector<Point> points;
    for (int i = 0; i < count; ++i)
        points.push_back(AsPoint(sampler(first + static_cast<std::uint32_t>(i))));
    return points;
}

/// Box side along d: 2^-split[d].
void ExpectStratified(const std::vector<Point>& points, const std::array<int, dimensions>& split, int expected)
{
    std::vector<int> count(std::size_t{1} << (split[0] + split[1] + split[2] + split[3]));
    for (const Point& p : points)
    {
        std::size_t interval = 0;
        for (int d = 0; d < dimensions; ++d)
            interval = (interval << split[d]) + static_cast<std::size_t>(std::ldexp(p[d], split[d]));
        ++count[interval];
    }
    const auto wrong = std::find_if(count.begin(), count.end(), [&](int c) { return c != expected; });
    EXPECT_EQ(wrong, count.end()) << "interval " << wrong - count.begin() << " has " << *wrong << " points, not " << expected << "; 2^("
                                  << split[0] << ", " << split[1] << ", " << split[2] << ", " << split[3] << ") intervals, "
                                  << points.size() << " points";
}

TEST(PixelSampler, LensPairAndPixelPairHaveOneSampleInEveryElementaryInterval)
{
    for (const Pixel& pixel : somePixels)
        for (int m = 0; m <= 12; ++m)
            for (int i = 0; i <= m; ++i)
            {
                SCOPED_TRACE(pixel);
                ExpectStratified(Block(pixel, 0, 1 << m), {i, m - i, 0, 0}, 1);
                ExpectStratified(Block(pixel, 0, 1 << m), {0, 0, i, m - i}, 1);
            }
}

TEST(PixelSampler, EachCoordinateHasOneSampleInEveryInterval)
{
    for (const Pixel& pixel : somePixels)
        for (int m = 0; m <= 12; ++m)
            for (int d = 0; d < dimensions; ++d)
            {
                SCOPED_TRACE(pixel);
                std::array<int, dimensions> split{};
                split[d] = m;
                ExpectStratified(Block(pixel, 0, 1 << m), split, 1);
            }
}

TEST(PixelSampler, AllFourCoordinatesAreANetOfQualityTwoAndThree)
{
    for (const Pixel& pixel : somePixels)
        for (int m = 2; m <= 14; ++m)
        {
            const int t = m <= 6 ? 2 : 3;
            const std::vector<Point> points = Block(pixel, 0, 1 << m);
            for (int i = 0; i <= m - t; ++i)
                for (int j = 0; i + j <= m - t; ++j)
                    for (int k = 0; i + j + k <= m - t; ++k)
                    {
                        SCOPED_TRACE(pixel);
                        ExpectStratified(points, {i, j, k, m - t - i - j - k}, 1 << t);
                    }
        }
}

TEST(PixelSampler, AlignedBlocksAreStratifiedUpToTheLastIndex)
{
    for (std::uint32_t first : {3u << 10, 1u << 20, (1u << 31) + 1024, 0u - 1024})
        for (int i = 0; i <= 10; ++i)
        {
            SCOPED_TRACE(first);
            ExpectStratified(Block({5, 6, 7}, first, 1024), {i, 10 - i, 0, 0}, 1);
            ExpectStratified(Block({5, 6, 7}, first, 1024), {0, 0, i, 10 - i}, 1);
        }
}

TEST(PixelSampler, EveryBitOfTheIndexMatters)
{
    for (const Pixel& pixel : somePixels)
        for (int bit = 0; bit < 32; ++bit)
        {
            const PixelSampler sampler(pixel.x, pixel.y, pixel.seed);
            const Point p = AsPoint(sampler(12345)), q = AsPoint(sampler(12345 ^ (1u << bit)));
            for (int d = 0; d < dimensions; ++d)
                EXPECT_NE(p[d], q[d]) << pixel << ", bit " << bit << ", dimension " << d;
        }
}

TEST(PixelSampler, ValuesDoNotDependOnTheOrderOfCalls)
{
    for (const Pixel& pixel : somePixels)
    {
        const std::vector<Point> forward = Block(pixel, 0, 1000);
        for (int i = 999; i >= 0; --i)
        {
            const PixelSampler again(pixel.x, pixel.y, pixel.seed);
            EXPECT_EQ(AsPoint(again(static_cast<std::uint32_t>(i))), forward[i]) << pixel << ", index " << i;
        }
    }
}

TEST(PixelSampler, TheSequenceIsThatOfTheReferenceImages)
{
    // A change of the sequence changes every picture with an aperture.
    const struct
    {
        Pixel pixel;
        std::uint32_t index;
        Point point;  // times 2^33
        std::uint32_t hash;
    } known[] = {{{0, 0, 0}, 0, {5387729817, 2228179273, 3368080663, 3584378989}, 0x458563ab},
                 {{640, 480, 1}, 77, {2797886911, 6373716091, 239829969, 106836973}, 0xe0cd7b94},
                 {{4294967295, 3, 9}, 1048576, {5385027649, 977681547, 6380548979, 6485646285}, 0xb5b8453d}};
    for (const auto& k : known)
    {
        Point point = AsPoint(PixelSampler(k.pixel.x, k.pixel.y, k.pixel.seed)(k.index));
        for (double& c : point)
            c = std::ldexp(c, 33);
        EXPECT_EQ(point, k.point) << k.pixel << ", index " << k.index;
        EXPECT_EQ(PixelHash(k.pixel.x, k.pixel.y, k.pixel.seed, k.index), k.hash) << k.pixel << ", salt " << k.index;
    }
}

TEST(PixelSampler, ValuesStayInsideTheOpenUnitInterval)
{
    for (const Pixel& pixel : somePixels)
    {
        const PixelSampler sampler(pixel.x, pixel.y, pixel.seed);
        for (std::uint32_t i = 0; i < (1u << 18); ++i)
            for (double c : AsPoint(sampler(i * 16411)))
                ASSERT_TRUE(c > 0 && c < 1) << pixel << ", index " << i * 16411 << ": " << c;
    }
}

TEST(PixelSampler, OneIndexIsUniformOverPixels)
{
    // 40 tests: p below 1e-5 by chance has probability 4e-4
    for (std::uint32_t index : {0u, 1u, 5u, 1000u})
        for (int d = 0; d < dimensions; ++d)
            for (int e = d; e < dimensions; ++e)
            {
                std::vector<double> count(256);
                for (std::uint32_t y = 0; y < 128; ++y)
                    for (std::uint32_t x = 0; x < 128; ++x)
                    {
                        const Point p = AsPoint(PixelSampler(x, y, 1)(index));
                        ++count[d == e ? int(p[d] * 256) : int(p[d] * 16) * 16 + int(p[e] * 16)];
                    }
                EXPECT_GT(ChiSquareP(count), 1e-5) << "index " << index << ", dimensions " << d << " and " << e;
            }
}

TEST(PixelSampler, ScramblingIsOwens)
{
    // 48 tests: p below 1e-5 by chance has probability 5e-4
    const std::uint32_t pairs[][2] = {{0, 1}, {0, 2},  {0, 3}, {1, 5},  {0, 4},    {2, 3},
                                      {0, 8}, {3, 11}, {5, 6}, {0, 16}, {0, 1024}, {7, 1000}};
    for (const auto& pair : pairs)
        for (int d = 0; d < dimensions; ++d)
        {
            std::vector<double> count(256);
            for (std::uint32_t i = 0; i < 40000; ++i)
            {
                const PixelSampler sampler(i % 200, i / 200, 4);
                double p = AsPoint(sampler(pair[0]))[d], q = AsPoint(sampler(pair[1]))[d];
                while (int(2 * p) == int(2 * q))
                {
                    p = 2 * p - int(2 * p);
                    q = 2 * q - int(2 * q);
                }
                ++count[int(32 * p) % 16 * 16 + int(32 * q) % 16];
            }
            EXPECT_GT(ChiSquareP(count), 1e-5) << "dimension " << d << ", samples " << pair[0] << " and " << pair[1];
        }
}

struct Integrand
{
    const char* name;
    double mean;
    std::function<double(const Point&)> f;
};

std::ostream& operator<<(std::ostream& out, const Integrand& i)
{
    return out << i.name;
}

/// Blurred by 2c pixels: fraction of x + c (2u - 1) > t.
Integrand BlurredEdge(const char* name, double c, double t)
{
    const auto part = [](double s) { return s > 0 ? s * s / 2 : 0.0; };
    const double below = (part(t + c) - part(t + c - 1) - part(t - c) + part(t - c - 1)) / (2 * c);
    return {name, 1 - below, [=](const Point& p) { return p[2] + c * (2 * p[0] - 1) > t ? 1.0 : 0.0; }};
}

const Integrand integrands[] = {
    {"smooth product", 1,
     [](const Point& p)
{
    double product = 1;
    for (double c : p)
        product *= 1 + 0.5 * std::sin(2 * M_PI * c) + (c - 0.5);
    return product;
}},
    {"quarter disc of the lens", M_PI / 4, [](const Point& p) { return Square(p[0]) + Square(p[1]) < 1 ? 1.0 : 0.0; }},
    {"diagonal edge in the pixel", 0.5, [](const Point& p) { return p[2] + p[3] > 1 ? 1.0 : 0.0; }},
    BlurredEdge("edge blurred by half a pixel", 0.5, 0.3),
    BlurredEdge("edge blurred by 3 pixels", 3, 1.7),
    BlurredEdge("edge blurred by 50 pixels", 50, -20)};

double MeanOf(const Integrand& integrand, const Pixel& p, int samples)
{
    const PixelSampler sampler(p.x, p.y, p.seed);
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        sum += integrand.f(AsPoint(sampler(static_cast<std::uint32_t>(i))));
    return sum / samples;
}

struct Tally
{
    double n = 0, sum = 0, squares = 0;

    void Add(double x)
    {
        n += 1;
        sum += x;
        squares += x * x;
    }
    double Mean() const { return sum / n; }
    double StandardError() const { return std::sqrt((squares / n - Square(Mean())) / n); }
};

class SamplerIntegral : public testing::TestWithParam<Integrand>
{
};

INSTANTIATE_TEST_SUITE_P(All, SamplerIntegral, testing::ValuesIn(integrands));

TEST_P(SamplerIntegral, IsUnbiased)
{
    for (int samples : {1, 3, 8, 50})
    {
        Tally error;
        for (std::uint32_t i = 0; i < 20000; ++i)
            error.Add(MeanOf(GetParam(), {i % 100, i / 100, 3}, samples) - GetParam().mean);
        EXPECT_LT(std::fabs(error.Mean()), 4.5 * error.StandardError()) << samples << " samples";
    }
}

TEST_P(SamplerIntegral, ErrorsOfNeighboursAndSeedsAreUncorrelated)
{
    const Pixel steps[] = {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 0, 0}, {0, 0, 1}, {0, 0, 2}, {1, 0, 1}, {1, 0, 0u - 1}};
    for (int samples : {1, 4, 16})
        for (const Pixel& step : steps)
        {
            Tally product, square;
            for (std::uint32_t i = 0; i < 10000; ++i)
            {
                const std::uint32_t x = i % 100 * 3, y = i / 100 * 2;
                const double a = MeanOf(GetParam(), {x, y, 5}, samples) - GetParam().mean;
                const double b = MeanOf(GetParam(), {x + step.x, y + step.y, 5 + step.seed}, samples) - GetParam().mean;
                product.Add(a * b);
                square.Add(a * a);
            }
            EXPECT_LT(std::fabs(product.Mean()), 4.5 * product.StandardError())
                << samples << " samples, step " << step << ", correlation " << product.Mean() / square.Mean();
        }
}

TEST_P(SamplerIntegral, TwoSeedsGiveTheTrueError)
{
    for (int samples : {4, 16, 64, 100, 256})
    {
        Tally estimated, actual, difference;
        for (std::uint32_t i = 0; i < 4000; ++i)
        {
            const double a = MeanOf(GetParam(), {i % 64, i / 64, 0}, samples);
            const double b = MeanOf(GetParam(), {i % 64, i / 64, 1}, samples);
            const double estimate = Square(a - b) / 4, truth = Square((a + b) / 2 - GetParam().mean);
            estimated.Add(estimate);
            actual.Add(truth);
            difference.Add(estimate - truth);
        }
        EXPECT_LT(std::fabs(difference.Mean()), 4.5 * difference.StandardError())
            << samples << " samples: variance estimated " << estimated.Mean() << ", actual " << actual.Mean();
    }
}

double RootMeanSquareError(const Integrand& integrand, int samples)
{
    Tally square;
    for (std::uint32_t i = 0; i < 200; ++i)
        square.Add(Square(MeanOf(integrand, {i, 77, 2}, samples) - integrand.mean));
    return std::sqrt(square.Mean());
}

TEST_P(SamplerIntegral, ErrorFallsFasterThanForRandomSamples)
{
    const double few = RootMeanSquareError(GetParam(), 16), many = RootMeanSquareError(GetParam(), 4096);
    const double slope = std::log2(many / few) / 8;
    // best exponents: 1.5 for bounded variation, 0.75 for an edge in two dimensions, 0.5 for random samples
    const bool smooth = GetParam().name == integrands[0].name;
    EXPECT_LT(slope, smooth ? -0.7 : -0.6) << "errors " << few << " and " << many;
}

TEST(PixelHash, IsTheSameFromTheSamplerAndTheFunction)
{
    for (const Pixel& p : somePixels)
        for (std::uint32_t salt : {0u, 1u, 77u, 4294967295u})
            EXPECT_EQ(PixelSampler(p.x, p.y, p.seed).Hash(salt), PixelHash(p.x, p.y, p.seed, salt)) << p << ", salt " << salt;
}

TEST(PixelSampler, GroupsContainThePointsOfTheirIndices)
{
    for (const Pixel& p : somePixels)
        for (const std::uint32_t index : {0u, 3u, 7u, 8u, 21u, 1000u, 123456789u, 4294967295u})
        {
            const PixelSampler sampler(p.x, p.y, p.seed);
            SequencePoints group;
            sampler.FindGroup(index, group);
            const std::uint32_t first = index - index % Settings::cameraRaysOfBatch;
            for (std::uint32_t i = 0; i < Settings::cameraRaysOfBatch; i++)
                EXPECT_EQ(AsPoint(group[i]), AsPoint(sampler(first + i))) << p << ", " << first + i;
        }
}

TEST(PixelHash, FlippingAnyInputBitFlipsHalfOfTheOutput)
{
    for (int argument = 0; argument < 4; ++argument)
        for (int bit = 0; bit < 32; ++bit)
        {
            std::array<int, 32> flips{};
            for (std::uint32_t i = 0; i < 4096; ++i)
            {
                std::array<std::uint32_t, 4> in = {i % 64, i / 64, i % 3, i % 1024};
                const std::uint32_t before = PixelHash(in[0], in[1], in[2], in[3]);
                in[argument] ^= 1u << bit;
                const std::uint32_t change = before ^ PixelHash(in[0], in[1], in[2], in[3]);
                for (int out = 0; out < 32; ++out)
                    flips[out] += static_cast<int>((change >> out) & 1u);
            }
            // 6 standard deviations of 4096 fair coins, 32 each
            for (int out = 0; out < 32; ++out)
                EXPECT_NEAR(flips[out], 2048, 192) << "argument " << argument << ", bit " << bit << ", output bit " << out;
        }
}

} // namespace
} // namespace tilt_lens
