// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/highlight.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

constexpr double kLensDiameter = 0.5;

/// Share of a sphere's highlight within the emitter, by evenly spread points, weighted by light.
double Covered(const GlossySphere& sphere, const Vec3& light, const Vec3& eye, const Emitter& emitter)
{
    constexpr int points = 200000;
    double all = 0.0, within = 0.0;
    for (int i = 0; i < points; i++)
    {
        const double z = 1.0 - (2.0 * i + 1.0) / points, turn = i * 2.399963229728653, side = std::sqrt(1.0 - z * z);
        const Vec3 normal{side * std::cos(turn), side * std::sin(turn), z}, at = sphere.centre + sphere.radius * normal;
        const Vec3 toLight = Normalized(light - at), toEye = Normalized(eye - at);
        const double seen = Dot(normal, toEye);
        if (!(seen > 0.0 && Dot(normal, toLight) > 0.0))
            continue;
        const double shown = seen * std::pow(std::max(0.0, Dot(normal, Normalized(toLight + toEye))), sphere.exponent);
        all += shown;
        if (Length(at - emitter.centre) <= emitter.radius)
            within += shown;
    }
    return within / all;
}

TEST(Highlight, CoversMostOfTheLight)
{
    std::mt19937 random(3);
    const auto uniform = [&random](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 30; i++)
    {
        const GlossySphere sphere{{uniform(-3, 3), uniform(-3, 3), uniform(4, 20)}, uniform(0.1, 2.0), 5.0, uniform(50, 2000), 0.2};
        const Vec3 light = sphere.centre +
                           uniform(1.5, 30) * sphere.radius * Normalized(Vec3{uniform(-1, 1), uniform(-1, 1), uniform(-1, 0.3)});
        const std::optional<Emitter> found = HighlightOf(sphere, light, kLensDiameter);
        ASSERT_TRUE(found);
        EXPECT_LT(found->radius, 0.45 * sphere.radius);
        for (const Vec3& eye : {Vec3{}, Vec3{0.5 * kLensDiameter, 0.0, 0.0}, Vec3{0.0, -0.5 * kLensDiameter, 0.0}})
            EXPECT_GT(Covered(sphere, light, eye, *found), 0.8) << i;
        EXPECT_DOUBLE_EQ(found->around, 0.2);
        EXPECT_NEAR(found->radiance, 0.2 + 5.0 * 0.4323, 1e-3);
    }
}

TEST(Highlight, SphereThatHoldsLensOrLightHasNone)
{
    const GlossySphere around{{0.0, 0.0, 1.0}, 2.0, 5.0, 100.0, 0.0}, before{{0.0, 0.0, 9.0}, 2.0, 5.0, 100.0, 0.0};
    EXPECT_FALSE(HighlightOf(around, {0.0, 9.0, 0.0}, kLensDiameter));
    EXPECT_FALSE(HighlightOf(before, {0.0, 0.0, 8.0}, kLensDiameter));
    EXPECT_FALSE(HighlightOf(before, {0.0, 0.0, 20.0}, kLensDiameter)) << "the light is behind";
    EXPECT_TRUE(HighlightOf(before, {0.0, 9.0, 0.0}, kLensDiameter));
}

}  // namespace
}  // namespace tilt_lens
