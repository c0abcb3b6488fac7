// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/padded_spread.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "picture_edges.h"
#include "random_cameras.h"
#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/samples/sequence.h"
#include "with_kernels.h"

namespace tilt_lens
{
namespace
{

constexpr int kSide = int(Settings::blockSide), kReach = SpreadSums::kReach;
constexpr Area kBlock{10 * Settings::blockSide, 10 * Settings::blockSide, Settings::blockSide, Settings::blockSide};
constexpr double kWidth = 640.0, kHeight = 480.0;

Vec3 ChiefThrough(const Lens& lens, const Vec3& point)
{
    return point * (Dot(lens.direction, lens.axis) / Dot(point, lens.axis));
}

FilmPoint PixelOf(const Lens& lens, const Vec3& chief)
{
    const Vec3 along = chief - lens.direction, r = Cross(lens.up, lens.axis), u = Cross(lens.axis, lens.right);
    return {(Dot(along, r) / Dot(lens.right, r) + 0.5) * kWidth, (0.5 - Dot(along, u) / Dot(lens.up, u)) * kHeight};
}

/// Solves chief ray = point / T - (1/T - w) lens point by iteration.
FilmPoint PixelThrough(const Lens& lens, const Vec3& point, const AperturePoint& at)
{
    const Vec3 l = at.a * lens.lensX + at.b * lens.lensY;
    Vec3 chief = ChiefThrough(lens, point);
    for (int i = 0; i < 200; i++)
    {
        const double w = Dot(lens.focus, chief);
        const double inverse = (Dot(lens.direction, lens.axis) - w * Dot(l, lens.axis)) / Dot(point - l, lens.axis);
        chief = inverse * point - (inverse - w) * l;
    }
    return PixelOf(lens, chief);
}

TEST(LensFootprint, CirclesMatchRaysThroughTheLens)
{
    Random random(11);
    for (int i = 0; i < 2000; i++)
    {
        Lens lens;
        const Request request = SolvableRequest(random, FocusFamily(i % 4), random.Coin(), lens);
        const LensFootprint footprint(lens, Aperture::Disc(), kWidth, kHeight);
        const FilmPoint film{random(-0.5, 0.5), random(-0.5, 0.5)};
        const AperturePoint at{random(-0.7, 0.7), random(-0.7, 0.7)};
        const LensRay ray = MakeRay(lens, film.x, film.y, at.a, at.b);
        const double T = random.Power(-0.5, 2.0) * lens.filmDistance * 10.0 / Length(ray.direction);
        const Vec3 point = ray.origin + T * ray.direction;
        if (Dot(point, lens.axis) < 0.2 * Length(point))
            continue;
        const CircleOfConfusion circle = footprint.CircleOf(film, at, 1.0 / T - ray.w);
        const FilmPoint middle = PixelOf(lens, ChiefThrough(lens, point)), own{(film.x + 0.5) * kWidth, (0.5 - film.y) * kHeight};
        const FilmPoint place{own.x - std::floor(own.x) - 0.5, own.y - std::floor(own.y) - 0.5};
        const double size = std::hypot(std::hypot(circle.xa, circle.xb), std::hypot(circle.ya, circle.yb));
        ASSERT_NEAR(circle.x, middle.x - place.x, 1e-4 * (1.0 + size + std::abs(middle.x))) << request;
        ASSERT_NEAR(circle.y, middle.y - place.y, 1e-4 * (1.0 + size + std::abs(middle.y))) << request;
        const double step = 1e-3;
        for (const AperturePoint& other : {AperturePoint{step, 0.0}, AperturePoint{0.0, step}})
        {
            const FilmPoint seen = PixelThrough(lens, point, other);
            const double dx = -(circle.xa * other.a + circle.xb * other.b), dy = -(circle.ya * other.a + circle.yb * other.b);
            ASSERT_NEAR(seen.x - middle.x, dx, 0.02 * step * size + 1e-9 * kWidth) << request;
            ASSERT_NEAR(seen.y - middle.y, dy, 0.02 * step * size + 1e-9 * kHeight) << request;
        }
    }
}

Lens RoundLens()
{
    return Solved(PlainRequest());
}

CircleOfConfusion CircleAt(const LensFootprint& lens, float x, float y, float radius)
{
    return {x, y, radius, 0.0f, 0.0f, radius, &lens};
}

Float4 SentTo(const SpreadSums& sums, int x, int y)
{
    Float4 sent;
    for (int c = 0; c < 4; c++)
        sent[c] = *sums.From(SpreadSums::Sum(c), x, y);
    return sent;
}

// Nearly, because possible senders are counted by a product of lengths.
TEST(SpreadSums, SharesAddUpToNearlyOneInCirclesWithinReach)
{
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(5, 0.3)})
    {
        const LensFootprint lens(RoundLens(), aperture, kWidth, kHeight);
        for (const float radius : {0.3f, 1.0f, 1.7f, 4.0f, 6.9f, 30.0f, 1e6f})
        {
            auto sums = std::make_unique<SpreadSums>(kBlock, kWidth, kHeight);
            sums->Add(3, 15, CircleAt(lens, 3.2f + 0.5f * radius, 15.4f, radius), Radiance{0.5, 1.0, 2.0, 0.0, 0.0});
            double share = 0.0, red = 0.0;
            for (int y = -kReach; y < kSide + kReach; y++)
                for (int x = -kReach; x < kSide + kReach; x++)
                {
                    const Float4 both = SentTo(*sums, x, y);
                    share += both[3];
                    red += both[0];
                    EXPECT_TRUE(both[3] == 0.0f || std::max(std::abs(x - 3), std::abs(y - 15)) <= kReach);
                    EXPECT_TRUE(both[3] == 0.0f || (x == 3 && y == 15) ||
                                std::hypot(x + 0.5 - 3.2 - 0.5 * radius, y + 0.5 - 15.4) <= 1.0001 * radius);
                }
            EXPECT_NEAR(red, 0.5 * share, 1e-5) << radius;
            if (radius <= 4.0f)
            {
                EXPECT_NEAR(share, 1.0, radius < 2.0f ? 0.02 : 0.12) << radius;
            }
            EXPECT_EQ(sums->OwnShare(3, 15), SentTo(*sums, 3, 15)[3]);
            EXPECT_EQ(sums->OwnWeight(3, 15), 1.0f);
            EXPECT_EQ(sums->IsSpread(), radius >= 1.0f) << radius;
        }
    }
}

double Window(double distance)
{
    const double radius = kReach + 1.0;
    return std::abs(distance) < radius ? 1.0 - distance * distance / (radius * radius) : 0.0;
}

double SendersTo(int pixel, double middle, double half, double begin, double end)
{
    constexpr int kSteps = 200;
    const double from = std::max({middle - half, pixel + 0.5 - kReach - 1.0, begin}),
                 to = std::min({middle + half, pixel + 0.5 + kReach + 1.0, end});
    double sum = 0.0;
    for (int i = 0; i < kSteps; i++)
        sum += Window(from + (to - from) * (i + 0.5) / kSteps - (pixel + 0.5));
    return std::max(1.0, sum * (to - from) / kSteps);
}

TEST(SpreadSums, SharesAreTheWindowOverThatOfAllPossibleSenders)
{
    Random random(13);
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    for (int i = 0; i < 20000; i++)
    {
        const Area block = i % 2 ? kBlock : Area{0, 0, kSide, kSide};
        const double left = -double(block.left), top = -double(block.top);
        const int column = int(random(0.0, kSide)), row = int(random(0.0, kSide));
        const double a = random.Power(0.1, 1.5), b = random.Power(0.1, 1.5);
        const double x = column + 0.5 + a * random(-1.0, 1.0), y = row + 0.5 + b * random(-1.0, 1.0);
        const auto distance = [&](int u, int v) { return std::hypot((u + 0.5 - x) / a, (v + 0.5 - y) / b); };
        const auto window = [&](int u, int v) { return Window(u - column) * Window(v - row); };
        int count = 0;
        double sum = 0.0;
        bool clear = true;  // rounding decides at the rim
        for (int v = row - kReach; v <= row + kReach; v++)
            for (int u = column - kReach; u <= column + kReach; u++)
            {
                count += distance(u, v) <= 1.0;
                sum += distance(u, v) <= 1.0 ? window(u, v) : 0.0;
                clear = clear && std::abs(distance(u, v) - 1.0) > 1e-4;
            }
        if (!clear || count <= 1 || distance(column, row) > 1.0)
            continue;
        auto sums = std::make_unique<SpreadSums>(block, kWidth, kHeight);
        sums->Add(column, row, {float(x), float(y), float(a), 0.0f, 0.0f, float(b), &lens}, Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
        std::vector<double> along(2 * kReach + 1), down(2 * kReach + 1);
        for (int i = -kReach; i <= kReach; i++)
        {
            along[i + kReach] = SendersTo(column + i, x, a, left, left + kWidth);
            down[i + kReach] = SendersTo(row + i, y, b, top, top + kHeight);
        }
        const auto senders = [&](int u, int v) { return along[u - column + kReach] * down[v - row + kReach]; };
        for (int v = row - kReach; v <= row + kReach; v++)
            for (int u = column - kReach; u <= column + kReach; u++)
            {
                const double share = SentTo(*sums, u, v)[3];
                const double expected = distance(u, v) <= 1.0 ? window(u, v) * senders(column, row) / (sum * senders(u, v)) : 0.0;
                ASSERT_NEAR(share, expected, 1e-4 * expected) << u << ", " << v << " of " << x << ", " << y << ": " << a << ", " << b;
            }
    }
}

TEST(SpreadSums, AreTheSameWithAllKernels)
{
    if (!HasSeveralVariants())
        GTEST_SKIP() << "This processor knows one variant.";
    Random random(12);
    const Area block{0, std::uint32_t(kHeight) - kSide, kSide, kSide};
    for (const Aperture& aperture : {Aperture::Disc(), Aperture::Polygon(5, 0.3)})
    {
        const LensFootprint lens(RoundLens(), aperture, kWidth, kHeight);
        auto sums = std::make_unique<SpreadSums>(block, kWidth, kHeight), plain = std::make_unique<SpreadSums>(block, kWidth, kHeight);
        for (int i = 0; i < 3000; i++)
        {
            const int column = int(random(0.0, kSide)), row = int(random(0.0, kSide));
            const float size = float(random.Power(-1.0, 2.5));
            const auto part = [&] { return size * float(random(-1.0, 1.0)); };
            const CircleOfConfusion circle{column + 0.5f + part(), row + 0.5f + part(), part(), part(), part(), part(), &lens};
            const Radiance radiance{random(0.0, 1.0), random(0.0, 2.0), random(0.0, 30.0), 0.0, 0.0};
            sums->Add(column, row, circle, radiance);
            WithPlainKernels([&] { plain->Add(column, row, circle, radiance); });
        }
        EXPECT_TRUE(sums->IsSpread());
        for (int y = -kReach; y < kSide + kReach; y++)
            for (int x = -kReach; x < kSide + kReach; x++)
                for (int c = 0; c < SpreadSums::kSums; c++)
                    ASSERT_EQ(*sums->From(SpreadSums::Sum(c), x, y), *plain->From(SpreadSums::Sum(c), x, y)) << x << ", " << y;
        for (int i = 0; i < kSide * kSide; i++)
            ASSERT_EQ(sums->OwnShare(i % kSide, i / kSide), plain->OwnShare(i % kSide, i / kSide));
    }
}

/// Radiance: squared distance from the pixel's centre.
double MeanSquareDistanceOf(int pixelX, int pixelY, float radius)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), 3.0 * kSide, 3.0 * kSide);
    Float4 received = Float4();
    for (int i = 0; i < 9; i++)
    {
        const int left = i % 3 * kSide, top = i / 3 * kSide;
        SpreadSums sums({std::uint32_t(left), std::uint32_t(top), Settings::blockSide, Settings::blockSide}, 3.0 * kSide, 3.0 * kSide);
        for (int pixel = 0; pixel < kSide * kSide; pixel++)
            for (std::uint32_t sample = 0; sample < 64; sample++)
            {
                const int x = pixel % kSide, y = pixel / kSide;
                const SequencePoint point = PixelSampler(left + x, top + y, 0)(sample);
                const AperturePoint seen = Aperture::Disc()(point.lensU, point.lensV);
                const float atX = x + 0.5f + radius * float(seen.a), atY = y + 0.5f + radius * float(seen.b);
                const double value = std::pow(left + atX - pixelX - 0.5, 2.0) + std::pow(top + atY - pixelY - 0.5, 2.0);
                sums.Add(x, y, CircleAt(lens, atX, atY, radius), {value, value, value, 0.0, 0.0});
            }
        const int x = pixelX - left, y = pixelY - top;
        if (std::min(x, y) >= -kReach && std::max(x, y) < kSide + kReach)
            received += SentTo(sums, x, y);
    }
    return received[0] / received[3];
}

TEST(SpreadSums, AllPartsOfTheLensCountAlikeInCirclesOfAnyWidth)
{
    for (const float radius : {4.0f, 8.0f, 12.0f, 20.0f})
    {
        const double mean = radius * radius / 2.0;
        EXPECT_NEAR(MeanSquareDistanceOf(24, 24, radius), mean, 0.04 * mean) << radius;
        EXPECT_NEAR(MeanSquareDistanceOf(0, 24, radius), mean, 0.08 * mean) << "at an edge of the picture, " << radius;
    }
}

TEST(SpreadSums, SharpOrNonFiniteSamplesServeTheirOwnPixelAlone)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    const double infinite = std::numeric_limits<double>::infinity();
    auto sums = std::make_unique<SpreadSums>(kBlock, kWidth, kHeight);
    sums->Add(5, 5, CircleOfConfusion(), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    sums->Add(5, 5, CircleAt(lens, 5.5f, 5.5f, 5.0f), Radiance{infinite, 1.0, 1.0, 0.0, 0.0});
    sums->Add(5, 5, CircleAt(lens, 5.5f, 5.5f, std::nanf("")), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    sums->Add(5, 5, CircleAt(lens, float(infinite), 5.5f, 5.0f), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    sums->Add(6, 5, CircleAt(lens, std::nanf(""), 5.5f, 5.0f), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    sums->Add(6, 5, CircleAt(lens, 6.5f, std::nanf(""), 5.0f), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    EXPECT_FALSE(sums->IsSpread());
    EXPECT_EQ(sums->OwnShare(5, 5), 4.0f);
    EXPECT_EQ(sums->OwnShare(6, 5), 2.0f);
}

/// Two samples a pixel, all equally blurred.
std::shared_ptr<const PaddedSpread> Received(const LensFootprint& lens, float radius, const std::function<double(int, int, int)>& grey,
                                             const PictureEdges& edges = kFarEdges)
{
    std::array<std::unique_ptr<SpreadSums>, 9> blocks;
    PaddedSpread::Sent places;
    for (int i = 0; i < 9; i++)
    {
        blocks[i] = std::make_unique<SpreadSums>(kBlock, kWidth, kHeight);
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++)
                for (int sample = 0; sample < 2; sample++)
                {
                    const double value = grey(x + (i % 3 - 1) * kSide, y + (i / 3 - 1) * kSide, sample);
                    blocks[i]->Add(x, y, CircleAt(lens, x + 0.5f, y + 0.5f, radius), {value, value, value, 0.0, 0.0});
                }
        places[i] = blocks[i].get();
    }
    return PaddedSpread::Of(places, edges);
}

TEST(PaddedSpread, EvenRadianceStaysEvenAndSharesSumToNearlyTheSamples)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    const auto received = Received(lens, 3.0f, [](int, int, int) { return 0.7; });
    for (int y = -PaddedBlock::kBorder; y < kSide + PaddedBlock::kBorder; y++)
        for (int x = -PaddedBlock::kBorder; x < kSide + PaddedBlock::kBorder; x++)
        {
            const int at = PaddedBlock::At(x, y);
            EXPECT_NEAR(received->mean[0][at], 0.7, 1e-6);
            EXPECT_NEAR(received->variance[at], 0.0, 1e-5);
            EXPECT_NEAR(received->share[at], 2.0, 0.2);
        }
}

TEST(PaddedSpread, VarianceIsThatOfTheReceivedSamples)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    const auto received = Received(lens, 3.0f, [](int, int, int sample) { return sample == 0 ? 0.2 : 0.8; });
    for (int y = 0; y < kSide; y++)
        for (int x = 0; x < kSide; x++)
            EXPECT_NEAR(received->variance[PaddedBlock::At(x, y)], 3.0 * 0.3 * 0.3, 1e-5) << x << ", " << y;
}

/// Pixels behind an edge receive samples as well, but from one side alone.
TEST(PaddedSpread, IsMirroredAtThePicturesEdges)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    const auto received = Received(lens, 3.0f, [](int x, int y, int) { return 0.01 * x * y; }, {0, -kSide, 2 * kSide, 12});
    for (int i = 0; i < PaddedBlock::kBorder; i++)
        for (int at = 0; at < kSide; at++)
            for (const PaddedSpread::Plane* plane : {&received->mean[0], &received->mean[2], &received->variance, &received->share,
                                                     &received->samples, &received->ownShare, &received->ownWeight})
            {
                ASSERT_EQ((*plane)[PaddedBlock::At(at, 12 + i)], (*plane)[PaddedBlock::At(at, 11 - i)]) << at << ", " << i;
                ASSERT_EQ((*plane)[PaddedBlock::At(-1 - i, at)], (*plane)[PaddedBlock::At(i, at)]) << at << ", " << i;
            }
}

TEST(PaddedSpread, IsNullWhereNothingWasSent)
{
    EXPECT_EQ(PaddedSpread::Of({}, kFarEdges), nullptr);
}

TEST(PaddedSpread, PixelsThatReceivedNothingKeepTheirOwnMean)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    auto sums = std::make_unique<SpreadSums>(kBlock, kWidth, kHeight);
    for (int sample = 0; sample < 2; sample++)
        sums->Add(0, 0, CircleAt(lens, 0.5f, 0.5f, 2.0f), Radiance{1.0, 1.0, 1.0, 0.0, 0.0});
    PaddedSpread::Sent sent{};
    sent[4] = sums.get();
    const auto received = PaddedSpread::Of(sent, kFarEdges);
    EXPECT_GT(received->share[PaddedBlock::At(1, 0)], 0.0f);
    EXPECT_LT(received->ownShare[PaddedBlock::At(0, 0)], 0.2f);
    EXPECT_EQ(received->share[PaddedBlock::At(10, 10)], 0.0f);
    EXPECT_EQ(received->ownShare[PaddedBlock::At(10, 10)], 1.0f);
}

TEST(Reconstruction, SharpSamplesHaveTheirPartOfTheSpreadEstimate)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    std::array<std::unique_ptr<SpreadSums>, 9> sums;
    std::array<BlockStatistics, 9> statistics;
    PaddedSpread::Sent sent;
    std::array<const BlockStatistics*, 9> known;
    for (int i = 0; i < 9; i++)
    {
        sums[i] = std::make_unique<SpreadSums>(kBlock, kWidth, kHeight);
        for (int y = 0; y < kSide; y++)
            for (int x = 0; x < kSide; x++)
            {
                statistics[i].Set(x, y, {0.5, 0.5, 0.5, 0.0, 0.0}, 0.75, 0.0, 2);
                sums[i]->Add(x, y, CircleAt(lens, x + 0.5f, y + 0.5f, 3.0f), Radiance{});
                sums[i]->Add(x, y, CircleAt(lens, x + 0.5f, y + 0.5f, 0.1f), {1.0, 1.0, 1.0, 0.0, 0.0});
            }
        sent[i] = sums[i].get();
        known[i] = &statistics[i];
    }
    const ReconstructedBlock estimates = SpreadEstimates(PaddedBlock(known, kFarEdges), Settings(), *PaddedSpread::Of(sent, kFarEdges));
    for (const float mean : estimates.mean[0])
        EXPECT_NEAR(mean, 0.5, 0.03);
}

TEST(Reconstruction, SpreadSamplesRemoveMoreNoiseThanFilters)
{
    const LensFootprint lens(RoundLens(), Aperture::Disc(), kWidth, kHeight);
    Random random(9);
    double without = 0.0, with = 0.0, reported = 0.0;
    for (int picture = 0; picture < 20; picture++)
    {
        std::array<BlockStatistics, 9> statistics;
        std::array<const BlockStatistics*, 9> known;
        std::map<std::pair<int, int>, std::array<double, 2>> values;
        const auto received = Received(lens, 6.0f, [&](int x, int y, int sample) { return values[{x, y}][sample] = random(0.0, 1.0); });
        for (int i = 0; i < 9; i++)
        {
            for (int y = 0; y < kSide; y++)
                for (int x = 0; x < kSide; x++)
                {
                    const auto& [a, b] = values[{x + (i % 3 - 1) * kSide, y + (i / 3 - 1) * kSide}];
                    const double mean = 0.5 * (a + b);
                    statistics[i].Set(x, y, {mean, mean, mean, 0.0, 0.0}, 3.0 / 24.0, 0.0, 2);
                }
            known[i] = &statistics[i];
        }
        const PaddedBlock around(known, kFarEdges);
        const ReconstructedBlock plain = Reconstruct(around, Settings()), spread = Reconstruct(around, Settings(), received.get());
        for (float value : plain.mean[0])
            without += Square(value - 0.5);
        for (float value : spread.mean[0])
            with += Square(value - 0.5);
        for (float ratio : spread.residualVarianceRatio)
            reported += ratio / 24.0;
    }
    EXPECT_LT(with, 0.5 * without);
    EXPECT_GT(reported, 0.8 * with);
    EXPECT_LT(reported, 2.0 * with);  // a block's least risk is noisy
}

} // namespace
} // namespace tilt_lens
