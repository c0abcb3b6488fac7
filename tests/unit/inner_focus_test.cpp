// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/inner_focus.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tilt_lens/glass/paraxial.h"
#include "tilt_lens/lens_camera/glass_camera.h"

namespace tilt_lens
{
namespace
{

/// Thin lenses of 50 and -80 mm; the second moves towards the film at 68 mm.
const char* const kThinGroups = R"({
 "object-distance": ["infinity", 585.714],
 "surfaces": [
  {"radius": 50, "thickness": 1e-9, "ior": 1.5, "semi_aperture": 10},
  {"radius": -50, "thickness": 1e-9, "ior": 1, "semi_aperture": 10},
  {"radius": 0, "thickness": [20, 28], "ior": 0, "semi_aperture": 8},
  {"radius": -80, "thickness": 1e-9, "ior": 1.5, "semi_aperture": 10},
  {"radius": 80, "thickness": [48, 40], "ior": 1, "semi_aperture": 10}]})";

std::string Whole(const std::string& name)
{
    std::ifstream file(std::string(TILT_LENS_SOURCE) + "/scenes/include/lenses/" + name);
    EXPECT_TRUE(file.good()) << name;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

struct Named
{
    const char* name;
    Prescription prescription;
};

std::vector<Named> Lenses()
{
    return {{"thin groups", ReadPrescription(kThinGroups)},
            {"Micro-Nikkor", ReadPrescription(Whole("nikon_micro_nikkor_200.json"))},
            {"Master Prime", ReadPrescription(Whole("zeiss_master_prime_100.json"))},
            {"Canon RF", ReadPrescription(Whole("canon_rf_51.json"))}};
}

/// 36 by 24 mm; 1 unit is 1 mm.
Statement Block(const Prescription& prescription)
{
    Statement given;
    given.prescription = std::make_shared<const Prescription>(prescription);
    given.sceneUnit = 1.0;
    return given;
}

SolvedLens Solved(const Statement& given)
{
    return Solve({{}, {0.0, 0.0, 1.0}, {1.5, 0.0, 0.0}, {0.0, 1.0, 0.0}}, given);
}

SolvedLens FocusedAt(const Prescription& prescription, double distance)
{
    Statement given = Block(prescription);
    given.focalPoint = {0.0, 0.0, distance};
    return Solved(given);
}

double DistanceOf(const Prescription& prescription, double state)
{
    return ObjectDistanceOf(prescription, state) + CardinalPointsOf(InState(prescription, state)).frontVertex;
}

TEST(InnerFocus, MatchesThinLenses)
{
    const Prescription lens = ReadPrescription(kThinGroups);
    for (const double state : {0.25, 0.5, 1.0})
    {
        const double moved = 8.0 * state;
        const double virtualObject = 1.0 / (1.0 / (48.0 - moved) + 1.0 / 80.0), image = 20.0 + moved + virtualObject;
        EXPECT_NEAR(ObjectDistanceOf(lens, state) * (1.0 / 50.0 - 1.0 / image), 1.0, 1e-6) << state;
    }
    EXPECT_GT(std::fabs(ObjectDistanceOf(lens, 0.0)), 1e9);
    EXPECT_EQ(InState(lens, 0.5).rows[2].thickness, 24.0);
    EXPECT_EQ(InState(lens, 0.5).rows[4].thickness, 44.0);
    EXPECT_EQ(InState(lens, 0.0).rows[2].thickness, 20.0);
    EXPECT_EQ(InState(lens, 1.0).rows[2].thickness, 28.0);
    EXPECT_TRUE(InState(lens, 0.5).objectDistances.empty());
}

TEST(InnerFocus, GoesFromStateToStateOfTheFile)
{
    const Prescription lens = ReadPrescription(Whole("nikon_micro_nikkor_200.json"));
    ASSERT_EQ(lens.objectDistances.size(), 2u);
    EXPECT_EQ(InState(lens, 1.0).rows[4].thickness, 14.2099);
    EXPECT_EQ(InState(lens, 2.0).rows[4].thickness, 6.6433);
    EXPECT_NEAR(InState(lens, 1.5).rows[4].thickness, 0.5 * (14.2099 + 6.6433), 1e-12);
    // half life size and life size in the patent
    EXPECT_NEAR(ObjectDistanceOf(lens, 1.0), 480.07, 0.3);
    EXPECT_NEAR(ObjectDistanceOf(lens, 2.0), 272.364, 0.01);
    for (const double state : {1.0, 2.0})
        EXPECT_NEAR(FilmPlaceOf(lens, state) / DistanceOf(lens, state), 0.5 * state, 1e-4);
}

TEST(InnerFocus, ImagesTheFocusOntoTheFilm)
{
    for (const Named& named : Lenses())
    {
        const double nearest = DistanceOf(named.prescription, double(named.prescription.objectDistances.size()));
        for (const double distance : {1.0001 * nearest, 1.3 * nearest, 2.5 * nearest, 20.0 * nearest, 1e7 * nearest})
        {
            SCOPED_TRACE(std::string(named.name) + " " + std::to_string(distance));
            const SolvedLens lens = FocusedAt(named.prescription, distance);
            const CardinalPoints& points = lens.glass->Cardinal();
            const Prescription moved = InState(named.prescription, lens.groups);
            const ParaxialMap map = MapBetween(moved, 0, moved.rows.size());
            const double object = distance - points.frontVertex;
            const double image = -(map.a * object + map.b) / (map.c * object + map.d);
            EXPECT_NEAR(image, lens.filmDistance + points.separation + points.rearVertex, 1e-6);
            EXPECT_NEAR(lens.filmDistance, FilmPlaceOf(named.prescription, lens.groups), 1e-6);
            EXPECT_NEAR(lens.focalLength, points.focalLength, 1e-12 * points.focalLength);
        }
    }
}

TEST(InnerFocus, LeadsRealRaysToTheFocus)
{
    for (const Named& named : Lenses())
    {
        const double distance = 1.7 * DistanceOf(named.prescription, double(named.prescription.objectDistances.size()));
        const SolvedLens lens = FocusedAt(named.prescription, distance);
        EXPECT_GT(lens.groups, 0.1);
        GlassRay ray{{0.0, 0.0, -lens.filmDistance - lens.glass->Cardinal().separation}, Normalized(Vec3{1e-5, 0.0, 1.0})};
        StopPoint stop;
        ASSERT_EQ(lens.glass->Trace(ray, stop), Passage::Passed);
        EXPECT_NEAR((ray.origin.z - ray.origin.x * ray.direction.z / ray.direction.x) / distance, 1.0, 1e-6) << named.name;
    }
}

TEST(InnerFocus, KeepsTheMeaningOfTheOtherItems)
{
    for (const Named& named : Lenses())
    {
        SCOPED_TRACE(named.name);
        const double distance = 3.0 * DistanceOf(named.prescription, double(named.prescription.objectDistances.size()));
        Statement given = Block(named.prescription);
        given.family = FocusFamily::FocalPoints;
        given.points[0] = {0.0, 0.0, distance};
        given.points[1] = {0.3 * distance, 0.1 * distance, 1.1 * distance};
        given.points[2] = {0.0, 0.4 * distance, 1.2 * distance};
        const SolvedLens lens = Solved(given);
        for (const Vec3& point : given.points)
            EXPECT_NEAR(Dot(lens.focus, point), 1.0, 1e-12);
        EXPECT_GT(lens.groups, 0.0);
        EXPECT_NEAR(lens.filmDistance, FilmPlaceOf(named.prescription, lens.groups), 1e-6);
        Statement turned = Block(named.prescription);
        turned.tilt = TiltOf(lens);
        turned.swing = SwingOf(lens);
        turned.focalPoint = given.points[1];
        EXPECT_NEAR(Solved(turned).groups, lens.groups, 1e-9);
        given.fStop = 3.0 * lens.glass->Cardinal().fNumber;
        const SolvedLens stopped = Solved(given);
        EXPECT_NEAR(stopped.diameter * *given.fStop, stopped.glass->Cardinal().focalLength, 1e-9);
    }
}

TEST(InnerFocus, EqualsALensWithTheseThicknesses)
{
    const Prescription prescription = ReadPrescription(Whole("nikon_micro_nikkor_200.json"));
    const auto focused = [](const Prescription& lens) { return std::make_shared<const SolvedLens>(FocusedAt(lens, 700.0)); };
    const auto moved = focused(prescription), fixed = focused(InState(prescription, moved->groups));
    EXPECT_NEAR(moved->filmDistance, fixed->filmDistance, 1e-12);
    const GlassCamera first(moved, Aperture::Disc(), 0.0), second(fixed, Aperture::Disc(), 0.0);
    for (const FilmPoint& film : {FilmPoint{0.0, 0.0}, FilmPoint{0.4, -0.3}, FilmPoint{-0.5, 0.5}})
    {
        const GlassSample a = first.Draw(film, 0.3, 0.6, 1), b = second.Draw(film, 0.3, 0.6, 1);
        EXPECT_EQ(a.weight, b.weight);
        EXPECT_LT(Length(Cross(a.ray.direction, b.ray.direction)), 1e-12);
    }
}

TEST(InnerFocus, MovesTheFilmBeyondTheGroupsReach)
{
    const Prescription prescription = ReadPrescription(kThinGroups);
    const double nearest = DistanceOf(prescription, 1.0), distance = 0.5 * nearest;
    const SolvedLens lens = FocusedAt(prescription, distance);
    EXPECT_EQ(lens.groups, 1.0);
    EXPECT_NEAR(1.0 / lens.filmDistance + 1.0 / distance, 1.0 / lens.focalLength, 1e-12);
    EXPECT_GT(lens.filmDistance, FilmPlaceOf(prescription, 1.0) + 1.0);
    Statement given = Block(prescription);
    given.family = FocusFamily::FocalPlane;
    given.planeNormal = {0.0, -1.0, -0.2};
    given.planeDistance = 300.0;
    const SolvedLens beyond = Solved(given);
    EXPECT_EQ(beyond.groups, 0.0);
    EXPECT_LT(beyond.filmDistance, FilmPlaceOf(prescription, 0.0));
    given = Block(prescription);
    given.filmDistance = 90.0;
    EXPECT_EQ(Solved(given).groups, 0.0);
    EXPECT_NEAR(Solved(given).filmDistance, 90.0, 1e-12);
}

TEST(InnerFocus, FollowsTheFocusingScale)
{
    const Prescription prescription = ReadPrescription(kThinGroups);
    Statement given = Block(prescription);
    given.focusScale = DistanceOf(prescription, 0.5) + FilmPlaceOf(prescription, 0.5);
    EXPECT_NEAR(Solved(given).groups, 0.5, 1e-9);
    given.tilt = 5.0;
    EXPECT_NEAR(Solved(given).groups, 0.5, 1e-9);
}

TEST(InnerFocus, ScalesWithTheLens)
{
    for (const Named& named : Lenses())
    {
        const Prescription larger = Scaled(named.prescription, 3.0);
        EXPECT_NEAR(larger.objectDistances[0], 3.0 * named.prescription.objectDistances[0], 1e-9);
        EXPECT_NEAR(ObjectDistanceOf(larger, 0.7) / ObjectDistanceOf(named.prescription, 0.7), 3.0, 1e-9);
        EXPECT_NEAR(FocusedAt(larger, 6000.0).groups, FocusedAt(named.prescription, 2000.0).groups, 1e-9);
    }
}

TEST(InnerFocus, NeedsObjectDistances)
{
    const Prescription zeiss = ReadPrescription(Whole("zeiss_planar_50.dat"));
    EXPECT_TRUE(zeiss.objectDistances.empty());
    const SolvedLens lens = FocusedAt(zeiss, 500.0);
    EXPECT_EQ(lens.groups, 0.0);
    EXPECT_NEAR(1.0 / lens.filmDistance, 1.0 / GlassLens(zeiss).Cardinal().focalLength - 1.0 / 500.0, 1e-12);
}

void ExpectError(std::string text, const std::string& part, const std::string& by, int line, const std::string& message)
{
    const std::size_t at = text.find(part);
    ASSERT_NE(at, std::string::npos) << part;
    try
    {
        ReadPrescription(text.replace(at, part.size(), by));
        ADD_FAILURE() << "no error for " << message;
    }
    catch (const PrescriptionError& error)
    {
        EXPECT_EQ(error.line, line) << error.what();
        EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << error.what();
    }
}

TEST(InnerFocus, RefusesInconsistentData)
{
    ExpectError(kThinGroups, "[20, 28]", "[20, 28, 29]", 6, "\"thickness\" with 3 values, where \"object-distance\" has 2");
    ExpectError(kThinGroups, "[20, 28]", "[20, -1]", 6, "a thickness of -1 for a near focus");
    ExpectError(kThinGroups, "[20, 28]", "[20, \"far\"]", 6, "\"thickness\" is the text 'far'");
    ExpectError(kThinGroups, "[\"infinity\", 585.714]", "[700, 585.714]", 2, "begins with 700");
    ExpectError(kThinGroups, "[\"infinity\", 585.714]", "585.714", 2, "begins with 585.714");
    ExpectError(kThinGroups, "[\"infinity\", 585.714]", "[\"infinity\"]", 2, "infinity alone");
    ExpectError(kThinGroups, "[\"infinity\", 585.714]", "[\"infinity\", -3]", 2, "object distance of -3");
    ExpectError(kThinGroups, "[\"infinity\", 585.714]", "[\"infinity\", 585.714, 600]", 2, "object distance of 600");
    ExpectError(kThinGroups, "585.714", "700", 2, "is focused at 585.7");
    ExpectError(kThinGroups, "[20, 28]", "20", 2, "are all moved thicknesses there");
    ExpectError(kThinGroups, "\"object-distance\": [\"infinity\", 585.714],", "", 6, "a zoom");
}

} // namespace
} // namespace tilt_lens
