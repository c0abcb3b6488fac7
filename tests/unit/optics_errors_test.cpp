// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "random_cameras.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{
namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();
const double kNaN = std::numeric_limits<double>::quiet_NaN();

struct BadCase
{
    const char* name;
    std::function<void(Request&)> spoil;
    std::vector<const char*> words;
};

std::ostream& operator<<(std::ostream& out, const BadCase& bad)
{
    return out << bad.name;
}

void Plane(Request& r, const Vec3& normal, double distance)
{
    r.given.family = FocusFamily::FocalPlane;
    r.given.planeNormal = normal;
    r.given.planeDistance = distance;
}

void Points(Request& r, const Vec3& a, const Vec3& b, const Vec3& c)
{
    r.given.family = FocusFamily::FocalPoints;
    r.given.points[0] = a;
    r.given.points[1] = b;
    r.given.points[2] = c;
}

void FocusTurn(Request& r, double tilt, double swing)
{
    r.given.family = FocusFamily::FocusTurn;
    r.given.focusTilt = tilt;
    r.given.focusSwing = swing;
}

// clang-format off
const BadCase kBadCases[] = {
    {"LensTurnedBy90", [](Request& r) { r.given.tilt = 90; },
        {"lens is turned by 90", "tilt 90", "between", "turn it less"}},
    {"LensSwungBackward", [](Request& r) { r.given.swing = -120; },
        {"lens is turned", "swing -120", "between", "turn it less"}},
    {"FocusTurnedBy90", [](Request& r) { FocusTurn(r, 0, 90); },
        {"plane of sharp focus is turned", "focus_swing 90", "between", "turn it less"}},
    {"PointsOnOneLine",
        [](Request& r) {
            Points(r, {0, 0, 2}, {1, 1, 3}, {3, 3, 5});
        },
        {"on one line", "<1, 1, 3>", "must span a plane", "move one"}},
    {"PointsTwice",
        [](Request& r) {
            Points(r, {0, 0, 2}, {0, 0, 2}, {3, 3, 5});
        },
        {"on one line", "<0, 0, 2>", "must span a plane", "move one"}},
    {"PlaneThroughLens",
        [](Request& r) {
            Plane(r, {0, 1, 0}, 0);
        },
        {"through the lens centre", "is 0", "must keep away", "move the plane"}},
    {"PlaneThroughLensFarAway",
        [](Request& r)
        {
            r.camera.location = {3e7, 1e7, 0};
            Plane(r, {1, -3, 0}, 0);
        },
        {"through the lens centre", "distance", "must keep away", "move the plane"}},
    {"PointsThroughLens",
        [](Request& r) {
            Points(r, {1, 0, 2}, {-1, 0, 3}, {0, 0, 1});
        },
        {"through the lens centre", "must keep away"}},
    {"FocusTurnThroughLens",
        [](Request& r)
        {
            FocusTurn(r, 45, 0);
            r.given.focalPoint = {0, 1, 1};
        },
        {"through the lens centre", "must keep away"}},
    {"LensTurnedBackward",
        [](Request& r) {
            Plane(r, {0, 0, 1}, -0.02);
        },
        {"between lens and film", "-0.02", "turned backward", "move or turn"}},
    {"NoNormal",
        [](Request& r) {
            Plane(r, {0, 0, 0}, 1);
        },
        {"normal of focal_plane", "<0, 0, 0>", "not zero", "write it as"}},
    {"FocalPointBehind",
        [](Request& r) {
            r.given.focalPoint = {0, 0, -1};
        },
        {"not in front", "-1 units", "must lie in front", "give another"}},
    {"FocalPointBehindTurnedLens",
        [](Request& r)
        {
            r.given.tilt = 60;
            r.given.focalPoint = {0, 5, 1};
        },
        {"turned so far", "must lie before the lens", "turn the lens less"}},
    {"FocusNearerThanFocalLength",
        [](Request& r)
        {
            r.given.focalLength = 50;
            r.given.focalPoint = {0, 0, 0.04};
        },
        {"nearer than the focal length", "0.04", "0.05", "forms no picture", "focus farther"}},
    {"FocusAtFocalLength",
        [](Request& r)
        {
            r.given.focalLength = 50;
            r.given.focalPoint = {0, 0, 0.05};
        },
        {"nearer than the focal length", "0.05", "focus farther"}},
    {"HingeNearerThanFocalLength",
        [](Request& r)
        {
            r.given.focalLength = 50;
            Plane(r, {0, 1, 0}, -0.04);
        },
        {"No tilt of this lens", "0.04", "must be larger", "shorter focal_length"}},
    {"PlaneTooNear",
        [](Request& r)
        {
            r.given.focalLength = 50;
            Plane(r, {0, 0, 1}, 0.04);
        },
        {"nearer than this lens can focus", "0.04", "focus farther"}},
    {"NumbersTooLarge", [](Request& r) { r.camera.right = {-1.7976931348623157e308, 0, 0}; },
        {"too large or too small", "right <-1.79769e+308", "between 1e-100 and 1e100", "moderate"}},
    {"LensTooLarge", [](Request& r) { r.given.fStop.reset(), r.given.aperture = 1e300; },
        {"too large or too small", "lens diameter 5e+299", "between 1e-100", "moderate"}},
    {"FilmAtTheFocalLengthButForRounding",
        [](Request& r)
        {
            r.given.focalLength = 57.1;
            r.given.focalPoint = {0, 0, 0.0571};
        },
        {"nearer than the focal length", "0.0571", "focus farther"}},
    {"UpAlongRight",
        [](Request& r) {
            r.camera.up = {2, 0, 0};
        },
        {"spans no picture", "up <2, 0, 0>", "must be finite and independent", "other vectors"}},
    {"UpAlongSlantedRight",
        [](Request& r)
        {
            r.camera.right = {0.1, 0.2, 0.3};
            r.camera.up = 2.7 * r.camera.right;
        },
        {"spans no picture", "must be finite and independent"}},
    {"DirectionInFilm",
        [](Request& r)
        {
            r.camera.right = {0.1, 0.2, 0.3};
            r.camera.up = {0.7, -0.3, 0.1};
            r.camera.direction = 0.3 * r.camera.right + 0.7 * r.camera.up;
        },
        {"spans no picture", "must be finite and independent"}},
    {"NoRight",
        [](Request& r) {
            r.camera.right = {0, 0, 0};
        },
        {"spans no picture", "right <0, 0, 0>"}},
    {"NoDirection",
        [](Request& r) {
            r.camera.direction = {0, 0, 0};
        },
        {"spans no picture", "direction <0, 0, 0>"}},
};
// clang-format on

class BadStatement : public testing::TestWithParam<BadCase>
{
};

INSTANTIATE_TEST_SUITE_P(Optics, BadStatement, testing::ValuesIn(kBadCases),
                         [](const testing::TestParamInfo<BadCase>& info) { return std::string(info.param.name); });

TEST_P(BadStatement, IsRefusedInWords)
{
    Request request = PlainRequest();
    GetParam().spoil(request);
    try
    {
        const Lens lens = Solved(request);
        FAIL() << request << "\ngave a lens of focal length " << lens.focalLength << ", normal " << lens.normal;
    }
    catch (const OpticsError& error)
    {
        for (const char* word : GetParam().words)
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << '\'' << word << "' is not in: " << error.what();
    }
}

TEST(BadCamera, DependentVectorsAreRefusedDespiteRounding)
{
    Random random(10);
    for (int i = 0; i < 1000; i++)
    {
        Request flat = PlainRequest(), thin = PlainRequest();
        thin.camera.right = random.Vector(1.0);
        thin.camera.up = random(-3, 3) * thin.camera.right;
        flat.camera.right = random.Vector(1.0);
        flat.camera.up = random.Vector(1.0);
        flat.camera.direction = random(-3, 3) * flat.camera.right + random(-3, 3) * flat.camera.up;
        ASSERT_THROW(Solved(thin), OpticsError) << thin;
        ASSERT_THROW(Solved(flat), OpticsError) << flat;
    }
}

TEST(BadCamera, PlaneThroughTheLensIsRefusedDespiteRounding)
{
    Random random(12);
    for (int i = 0; i < 1000; i++)
    {
        Request request = PlainRequest();
        request.camera.location = random.Power(-6, 9) * random.Direction();
        const Vec3 normal = random.Power(-1, 1) * random.Direction();
        Plane(request, normal, Dot(normal, request.camera.location) / Length(normal));
        ASSERT_THROW(Solved(request), OpticsError) << request;
    }
}

std::vector<double*> NumbersOf(Request& r)
{
    Statement& s = r.given;
    std::vector<double*> numbers = {&s.filmWidth, &s.sceneUnit, &s.shiftRight, &s.shiftUp, &*s.fStop, &s.scale};
    if (s.focalLength)
        numbers.push_back(&*s.focalLength);
    for (Vec3* v : {&r.camera.location, &r.camera.direction, &r.camera.right, &r.camera.up})
        numbers.insert(numbers.end(), {&v->x, &v->y, &v->z});
    if (s.family == FocusFamily::FocalPlane)
        numbers.insert(numbers.end(), {&s.planeNormal.x, &s.planeNormal.y, &s.planeNormal.z, &s.planeDistance});
    else if (s.family == FocusFamily::FocalPoints)
        for (Vec3& p : s.points)
            numbers.insert(numbers.end(), {&p.x, &p.y, &p.z});
    else
        numbers.insert(numbers.end(), {&s.focalPoint.x, &s.focalPoint.y, &s.focalPoint.z});
    if (s.family == FocusFamily::LensTurn)
        numbers.insert(numbers.end(), {&s.tilt, &s.swing});
    if (s.family == FocusFamily::FocusTurn)
        numbers.insert(numbers.end(), {&s.focusTilt, &s.focusSwing});
    return numbers;
}

Request RequestOf(FocusFamily family, bool focalLength)
{
    Request request = PlainRequest();
    request.given.family = family;
    request.given.planeNormal = {0, 1, 1};
    request.given.planeDistance = 3;
    request.given.points[0] = {0, 0, 4};
    request.given.points[1] = {1, 0, 5};
    request.given.points[2] = {0, 1, 6};
    if (focalLength)
        request.given.focalLength = 50;
    return request;
}

void ExpectErrorOrLens(const Request& request, bool errorWanted)
{
    SCOPED_TRACE(testing::Message() << request);
    try
    {
        const Lens lens = Solved(request);
        EXPECT_FALSE(errorWanted) << "no error";
        const LensRay ray = MakeRay(lens, 0.3, -0.2, 0.5, 0.4);
        EXPECT_TRUE(IsFinite(ray.origin) && IsFinite(ray.direction) && IsFinite(lens.normal) && IsFinite(lens.focus));
        EXPECT_GT(Length(ray.direction), 0.0);
        EXPECT_TRUE(lens.focalLength > 0 && lens.filmDistance > 0 && lens.diameter >= 0 && lens.millimetre > 0)
            << "f " << lens.focalLength << ", s " << lens.filmDistance << ", diameter " << lens.diameter;
    }
    catch (const OpticsError& error)
    {
        EXPECT_GT(std::string(error.what()).size(), 40u) << error.what();
    }
}

TEST(BadNumbers, YieldAnErrorOrAUsableLens)
{
    const FocusFamily families[] = {FocusFamily::LensTurn, FocusFamily::FocusTurn, FocusFamily::FocalPlane, FocusFamily::FocalPoints};
    for (const FocusFamily family : families)
        for (const bool focalLength : {false, true})
        {
            Request sound = RequestOf(family, focalLength);
            const std::size_t count = NumbersOf(sound).size();
            for (std::size_t i = 0; i < count; i++)
                for (const double bad : {kNaN, kInfinity, -kInfinity, 0.0, -1.0, 1e300, -1e300, 1e-300})
                {
                    Request request = sound;
                    double* number = NumbersOf(request)[i];
                    const bool fStop = request.given.fStop && number == &*request.given.fStop;
                    *number = bad;
                    SCOPED_TRACE(testing::Message() << "number " << i);
                    ExpectErrorOrLens(request, std::isnan(bad) || (std::isinf(bad) && !fStop));
                }
        }
}

TEST(Warnings, NameTurnsPast15DegreesOnly)
{
    Random random(9);
    for (int i = 0; i < 300; i++)
    {
        Request request;
        request.camera = RandomFrame(random);
        request.given.focalPoint = request.camera.location + 5.0 * AxisOf(request.camera);
        request.given.aperture = 0.01;
        SCOPED_TRACE(testing::Message() << request);
        for (double Statement::* turn : {&Statement::tilt, &Statement::swing})
            for (const double sign : {-1.0, 1.0})
            {
                Statement s = request.given;
                s.*turn = sign * 15.0;
                ASSERT_TRUE(Warnings(Solve(request.camera, s), s).empty());
                s.*turn = sign * 15.01;
                ASSERT_EQ(Warnings(Solve(request.camera, s), s).size(), 1u);
            }
    }
    Request both = PlainRequest();
    both.given.tilt = both.given.swing = 12.0;
    const std::vector<std::string> warnings = Warnings(Solved(both), both.given);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("16.7"), std::string::npos) << warnings[0];
}

TEST(Warnings, NameATiltWithoutAnAperture)
{
    Request request = PlainRequest();
    request.given.fStop.reset();
    EXPECT_TRUE(Warnings(Solved(request), request.given).empty());
    request.given.shiftUp = 8.0;
    EXPECT_TRUE(Warnings(Solved(request), request.given).empty());
    request.given.tilt = 1e-6;
    const std::vector<std::string> warnings = Warnings(Solved(request), request.given);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("aperture"), std::string::npos);
    request.given.aperture = 0.1;
    EXPECT_TRUE(Warnings(Solved(request), request.given).empty());
}

/// The rim reaches radius * sin(turn) behind the lens centre.
TEST(Warnings, NameARimThatPassesThroughTheFilm)
{
    Random random(10);
    for (int i = 0; i < 300; i++)
    {
        Request request;
        request.camera = RandomFrame(random);
        request.given.focalPoint = request.camera.location + 5.0 * AxisOf(request.camera);
        request.given.tilt = random(0.5, 10.0);
        request.given.swing = random(-10.0, 10.0);
        request.given.aperture = 0.0;
        SCOPED_TRACE(testing::Message() << request);
        const Lens pinhole = Solved(request);
        const double sine = Length(pinhole.normal - Dot(pinhole.normal, pinhole.axis) * pinhole.axis);
        const double limit = 4.0 * pinhole.filmDistance / sine / request.given.scale;
        request.given.aperture = 0.999 * limit;
        EXPECT_TRUE(Warnings(Solved(request), request.given).empty());
        request.given.aperture = 1.001 * limit;
        const std::vector<std::string> warnings = Warnings(Solved(request), request.given);
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("rim passes through the film"), std::string::npos) << warnings[0];
    }
}

} // namespace
} // namespace tilt_lens
