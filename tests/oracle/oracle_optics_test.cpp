// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "oracle_case.h"

namespace
{

using namespace witness;

const double kDegree = std::acos(-1.0) / 180.0;

CameraGiven AlongZ(Focus focus, double turnUp, double turnRight)
{
    CameraGiven given;
    given.location = {0.0, 0.0, 0.0};
    given.lookAt = {0.0, 0.0, 1.0};
    given.angle = 40.0;
    given.aperture = 0.4;
    given.sceneUnit = 200.0;
    given.focus = focus;
    given.turnUp = turnUp;
    given.turnRight = turnRight;
    given.points[0] = {0.4, -0.3, 6.0};
    return given;
}

Vector Crossing(const CameraSolved& camera, double a, double b, double x, double y)
{
    const Vector l = a * camera.lensX + b * camera.lensY;
    const Vector chief = camera.direction + x * camera.right + y * camera.up;
    const Vector ray = chief - Dot(camera.focus, chief) * l;
    return l + ((1.0 - Dot(camera.focus, l)) / Dot(camera.focus, ray)) * ray;
}

TEST(OracleOptics, EveryLensPointMeetsInThePlaneOfFocus)
{
    for (const double tilt : {-12.0, 0.0, 3.0, 20.0})
        for (const double swing : {-8.0, 0.0, 5.0})
        {
            const CameraSolved camera = SolveCase(AlongZ(Focus::Lens, tilt, swing), 4.0 / 3.0);
            for (const double x : {-0.5, 0.1, 0.5})
            {
                const Vector centre = Crossing(camera, 0.0, 0.0, x, 0.3), edge = Crossing(camera, 0.6, -0.8, x, 0.3);
                EXPECT_LT(Length(edge - centre), 1e-9 * Length(centre)) << tilt << ' ' << swing << ' ' << x;
            }
        }
}

TEST(OracleOptics, ObeysTheHingeRule)
{
    const CameraSolved camera = SolveCase(AlongZ(Focus::Lens, 6.0, 0.0), 4.0 / 3.0);
    // the plane of sharp focus meets z = 0 at the distance J below the lens
    EXPECT_NEAR(-1.0 / camera.focus.y, camera.focalLength / std::sin(6.0 * kDegree), 1e-12);
}

TEST(OracleOptics, ObeysEquationOneOfThePaper)
{
    for (const double focusTilt : {-75.0, -20.0, 10.0, 60.0, 89.0})
    {
        const CameraSolved camera = SolveCase(AlongZ(Focus::PlaneTurn, focusTilt, 0.0), 4.0 / 3.0);
        const double axial = 1.0 / camera.focus.z, s = camera.filmDistance;
        const double lensTilt = std::atan2(-camera.lensNormal.y, camera.lensNormal.z);
        EXPECT_NEAR(std::tan(lensTilt), s * std::tan(focusTilt * kDegree) / (axial + s), 1e-12) << focusTilt;
    }
}

TEST(OracleOptics, BothRoutesAgree)
{
    const CameraGiven lens = AlongZ(Focus::Lens, 7.0, -11.0);
    const CameraSolved a = SolveCase(lens, 4.0 / 3.0);
    CameraGiven plane = lens;
    plane.focus = Focus::Plane;
    plane.normal = a.focus;
    plane.distance = 1.0 / Length(a.focus);
    const CameraSolved b = SolveCase(plane, 4.0 / 3.0);
    EXPECT_LT(Length(a.lensNormal - b.lensNormal), 1e-13);
    EXPECT_NEAR(a.focalLength, b.focalLength, 1e-13);
    EXPECT_LT(Length(a.lensX - b.lensX), 1e-13);
}

TEST(OracleOptics, ScheimpflugLineIsInAllThreePlanes)
{
    const CameraSolved camera = SolveCase(AlongZ(Focus::Lens, 4.0, 9.0), 4.0 / 3.0);
    // Scheimpflug: the line of lens plane and film lies in the plane of focus
    const Vector t = camera.lensNormal;
    const double s = camera.filmDistance;
    for (const double x : {-1.0, 2.0})
    {
        const Vector point{x, (s * t.z - x * t.x) / t.y, -s};
        EXPECT_NEAR(Dot(camera.focus, point), 1.0, 1e-12) << x;
    }
}

TEST(OracleOptics, FocalLengthSetsTheFilmDistance)
{
    CameraGiven given = AlongZ(Focus::Lens, 0.0, 0.0);
    given.angle.reset();
    given.focalLength = 50.0;
    given.aperture.reset();
    given.fStop = 2.0;
    given.sceneUnit = 1000.0;
    const CameraSolved camera = SolveCase(given, 1.5);
    EXPECT_NEAR(1.0 / camera.filmDistance + 1.0 / 6.0, 1.0 / 0.05, 1e-12);
    EXPECT_NEAR(Length(camera.lensX), 0.0125, 1e-15);
    EXPECT_NEAR(Length(camera.right) / camera.direction.z, 0.036 / camera.filmDistance, 1e-12);
}

TEST(OracleOptics, ShiftMovesTheFrameOnly)
{
    CameraGiven given = AlongZ(Focus::Lens, 5.0, 2.0);
    const CameraSolved before = SolveCase(given, 4.0 / 3.0);
    given.shiftRight = 9.0;  // a quarter of 36 mm
    given.shiftUp = -4.5;
    const CameraSolved after = SolveCase(given, 4.0 / 3.0);
    const Vector moved = before.direction + 0.25 * before.right - (1.0 / 6.0) * before.up;
    EXPECT_LT(Length(after.direction - moved), 1e-14);
    EXPECT_LT(Length(after.focus - before.focus), 1e-14);
}

TEST(OracleOptics, TransformationsCarryThePlaneWithTheCamera)
{
    CameraGiven given = AlongZ(Focus::Lens, 5.0, 2.0);
    const CameraSolved before = SolveCase(given, 4.0 / 3.0);
    given.transformations = {{Transformation::Kind::Scale, {2.0, 2.0, 2.0}},
                             {Transformation::Kind::Rotate, {0.0, 90.0, 0.0}},
                             {Transformation::Kind::Translate, {1.0, 2.0, 3.0}}};
    const CameraSolved after = SolveCase(given, 4.0 / 3.0);
    EXPECT_LT(Length(after.direction - Vector{2.0 * before.direction.z, 0.0, 0.0}), 1e-14);
    const Vector point = Crossing(before, 0.0, 0.0, 0.2, 0.1), image = Crossing(after, 0.3, 0.4, 0.2, 0.1);
    EXPECT_LT(Length(image - Vector{2.0 * point.z, 2.0 * point.y, -2.0 * point.x}), 1e-9 * Length(image));
}

TEST(OracleCaseFile, WrongItemsAreNamed)
{
    nlohmann::json text = {{"name", "x"}, {"scene", "s.inc"}, {"picture", {4, 3}}, {"camera", nlohmann::json::object()}};
    text["camera"] = {
        {"location", {0, 0, 0}}, {"look_at", {0, 0, 1}}, {"angle", 40}, {"aperture", 1}, {"focus", {{"tilt", 1}, {"through", {0, 0, 3}}}}};
    EXPECT_NO_THROW(ReadCase(text));
    nlohmann::json unknown = text;
    unknown["camera"]["tlit"] = 3;
    EXPECT_THROW(ReadCase(unknown), std::runtime_error);
    nlohmann::json twice = text;
    twice["camera"]["focal_length"] = 50;
    EXPECT_THROW(ReadCase(twice), std::runtime_error);
    nlohmann::json empty = text;
    empty["picture"] = {0, 3};
    EXPECT_THROW(ReadCase(empty), std::runtime_error);
}

} // namespace
