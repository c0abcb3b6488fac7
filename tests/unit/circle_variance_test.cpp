// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/pixel_variance.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "picture_edges.h"
#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/samples/sequence.h"

namespace tilt_lens
{
namespace
{

constexpr int kSide = int(Settings::blockSide);
constexpr double kLamp = 10.0;

/// Four samples a pixel; one in `every` has hit a red lamp.
std::shared_ptr<const PaddedSpread> LampHitByOneIn(std::uint32_t every)
{
    static const LensFootprint lens(Lens(), Aperture::Disc(), 3.0 * kSide, 3.0 * kSide);
    const auto sums = std::make_unique<SpreadSums>(Area{Settings::blockSide, Settings::blockSide, Settings::blockSide, Settings::blockSide},
                                                   3.0 * kSide, 3.0 * kSide);
    for (std::uint32_t i = 0; i < 4 * kSide * kSide; i++)
    {
        const int column = int(i / 4 % kSide), row = int(i / 4 / kSide);
        const CircleOfConfusion circle{column + 0.5f, row + 0.5f, 6.0f, 0.0f, 0.0f, 6.0f, &lens};
        sums->Add(column, row, circle, Radiance{PixelHash(i, 0, 0, 0) % every == 0 ? kLamp : 0.0, 0.0, 0.0, 0.0, 0.0});
    }
    PaddedSpread::Sent sent{};
    sent[4] = sums.get();
    return PaddedSpread::Of(sent, kFarEdges);
}

constexpr std::size_t kMiddle = std::size_t(PaddedBlock::At(8, 8));

TEST(CircleVariance, ReachesPixelsThatMissedTheLamp)
{
    const auto spread = LampHitByOneIn(64);
    const double variance = spread->variance[kMiddle];
    EXPECT_GT(variance, 0.3 * Square(kLamp) / 64.0);
    const CircleVariance circle(spread.get(), kMiddle, 4.0);
    const Radiance blend = circle.Blend(Radiance{});
    EXPECT_NEAR(blend[0], variance, 0.1 * variance);
    EXPECT_EQ(blend[1], 0.0) << "the lamp is red";
    EXPECT_NEAR(circle.AtLeast(0.0), blend[0], 1e-6);
}

TEST(CircleVariance, IsTheSameForPixelsThatHitTheLamp)
{
    const auto spread = LampHitByOneIn(64);
    const CircleVariance circle(spread.get(), kMiddle, 4.0);
    const Radiance met{Square(kLamp) / 4.0, 0.0, 0.0, 0.0, 0.0};
    EXPECT_NEAR(circle.Blend(met)[0], circle.Blend(Radiance{})[0], 0.1 * met[0]);
    EXPECT_EQ(circle.AtLeast(met[0]), met[0]) << "its own noise is that of its own samples";
}

TEST(CircleVariance, IsIgnoredWhereAPixelHasManySamples)
{
    const auto spread = LampHitByOneIn(64);
    const Radiance own{0.5, 0.25, 0.125, 0.0, 0.0};
    const Radiance blend = CircleVariance(spread.get(), kMiddle, 4096.0).Blend(own);
    for (int c = 0; c < 3; c++)
        EXPECT_NEAR(blend[c], own[c], 1e-5);
}

TEST(CircleVariance, NothingSentChangesNothing)
{
    const Radiance own{0.5, 0.25, 0.125, 0.0, 0.0};
    EXPECT_EQ(CircleVariance(nullptr, 0, 8.0).Blend(own), own);
    EXPECT_EQ(CircleVariance(nullptr, kMiddle, 4.0).Blend(own), own);
    EXPECT_EQ(CircleVariance(nullptr, kMiddle, 4.0).AtLeast(0.25), 0.25);
}

TEST(CircleVariance, IsZeroInEvenLight)
{
    const auto spread = LampHitByOneIn(1);
    EXPECT_NEAR(CircleVariance(spread.get(), kMiddle, 4.0).AtLeast(0.0), 0.0, 1e-4);
}

} // namespace
} // namespace tilt_lens
