// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/lens_camera.h"

#include <limits>

#include <gtest/gtest.h>

#include "double_gauss_rows.h"
#include "random_cameras.h"

namespace tilt_lens
{
namespace
{

/// 50 mm, f/2.8; 1 unit is 1 mm.
struct Setting
{
    Statement given;

    Setting()
    {
        given.focalLength = 50.0;
        given.fStop = 2.8;
        given.sceneUnit = 1.0;
        given.focalPoint = {0.0, 0.0, 3000.0};
    }

    Setting& With(double Character::* item, double value)
    {
        given.character.*item = value;
        return *this;
    }
    Setting& Glass(bool dispersion = false)
    {
        given.prescription = std::make_shared<const Prescription>(ReadPrescription(kDispersiveDoubleGauss));
        given.focalLength.reset();
        given.dispersion = dispersion;
        return *this;
    }

    SolvedLens Solved() const { return Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given); }
};

struct Rules
{
    bool colours, bends, spreads, aims;
};

struct Case
{
    const char* name;
    Setting setting;
    bool deflected;
    Rules rules;
};

TEST(LensCamera, EachRuleHoldsForTheLensesThatItNames)
{
    using C = Character;
    const Case cases[] = {
        {"plain", Setting(), false, {false, false, true, true}},
        {"natural vignetting", Setting().With(&C::naturalVignetting, 1.0), false, {false, false, true, true}},
        {"edge light", Setting().With(&C::edgeLight, 0.3), false, {false, false, true, true}},
        {"distortion", Setting().With(&C::distortion1, -0.05), false, {false, true, false, true}},
        {"field curvature", Setting().With(&C::fieldCurvature, 0.2), false, {false, false, false, true}},
        {"optical vignetting", Setting().With(&C::opticalVignetting, 0.4), false, {false, false, false, true}},
        {"lateral colour", Setting().With(&C::lateralColour, 0.02), false, {true, false, false, true}},
        {"axial colour", Setting().With(&C::axialColour, 0.02), false, {true, false, false, true}},
        {"deflected rays", Setting(), true, {false, false, false, false}},
        {"glass", Setting().Glass(), false, {false, true, false, true}},
        {"glass with dispersion", Setting().Glass(true), false, {true, true, false, true}},
    };
    for (const Case& one : cases)
    {
        SCOPED_TRACE(one.name);
        const LensCamera camera(Shared(one.setting.Solved()), Aperture::Disc(), one.setting.given.character, one.deflected);
        EXPECT_EQ(camera.HasColours(), one.rules.colours);
        EXPECT_EQ(camera.BendsChiefRays(), one.rules.bends);
        EXPECT_EQ(camera.CanSpread(), one.rules.spreads);
        EXPECT_EQ(camera.CanAimAtEmitters(), one.rules.aims);
        EXPECT_EQ(camera.NeedsFewFirstSamples(), one.rules.aims && !one.setting.given.prescription);
        EXPECT_EQ(camera.Glass() != nullptr, bool(one.setting.given.prescription));
    }
}

TEST(LensCamera, MiddleRaysPassTheMiddle)
{
    const Setting distorts = Setting().With(&Character::distortion1, -0.1);
    const LensCamera thin(Shared(distorts.Solved()), Aperture::Disc(), distorts.given.character);
    for (const FilmPoint& film : {FilmPoint{0.0, 0.0}, FilmPoint{0.4, -0.3}})
    {
        const std::optional<LensRay> middle = thin.MiddleRay(film);
        ASSERT_TRUE(middle);
        EXPECT_EQ(Length(middle->origin), 0.0);
        EXPECT_EQ(Length(middle->direction - ChiefRay(thin.Solved(), film)), 0.0);
    }
    Setting shifted = Setting().Glass();
    shifted.given.shiftUp = 12.0;
    const LensCamera glass(Shared(shifted.Solved()), Aperture::Disc(), {});
    EXPECT_TRUE(glass.MiddleRay({0.0, 0.0}));
    EXPECT_FALSE(glass.MiddleRay({0.5, 3.0}));
}

TEST(LensCamera, BlurGrowsAwayFromTheSharpPlane)
{
    const LensCamera camera(Shared(Setting().Solved()), Aperture::Disc(), {});
    EXPECT_NEAR(camera.Blur({0.2, 0.1}, 3000.0, 640.0), 0.0, 1e-9);
    EXPECT_GT(camera.Blur({0.2, 0.1}, 2000.0, 640.0), 1.0);
    EXPECT_LT(camera.Blur({0.2, 0.1}, 5000.0, 640.0), -1.0);
    const SolvedLens& lens = camera.Solved();
    const double atInfinity = camera.Blur({0.2, 0.1}, std::numeric_limits<double>::infinity(), 640.0);
    EXPECT_NEAR(atInfinity, -lens.diameter * lens.filmDistance / 3000.0 / 36.0 * 640.0, 1e-9);
}

TEST(LensCamera, PlainPinholesNeedNoCamera)
{
    Setting pinhole;
    pinhole.given.fStop.reset();
    EXPECT_TRUE(IsPlainPinhole(pinhole.Solved(), pinhole.given.character));
    EXPECT_FALSE(IsPlainPinhole(Setting().Solved(), {}));
    for (const auto item : {&Character::distortion1, &Character::lateralColour, &Character::naturalVignetting})
    {
        Setting real = pinhole;
        real.With(item, 0.01);
        EXPECT_FALSE(IsPlainPinhole(real.Solved(), real.given.character));
    }
}

} // namespace
} // namespace tilt_lens
