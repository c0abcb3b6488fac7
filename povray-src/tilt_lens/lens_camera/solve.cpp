// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/solve.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/inner_focus.h"
#include "tilt_lens/lens_camera/sharp_points.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

/// An f-number of four digits counts as the glass's own.
constexpr double kSameFNumber = 1e-3;

/// Least distance, mm, from the last vertex to a film corner; negative if the film reaches into the glass.
double RoomBehind(const Lens& lens, const CardinalPoints& points)
{
    double least = HUGE_VAL;
    ForCorners([&](const FilmPoint& corner)
    {
        const double along = Dot(IdealChiefRay(lens, corner), lens.normal);
        const double behind = along * lens.filmDistance / (Dot(lens.direction, lens.axis) * lens.millimetre);
        least = std::min(least, behind + points.separation + points.rearVertex);
    });
    return least;
}

double GroupsOf(const CameraFrame& camera, const Statement& given)
{
    // a stated film_distance leaves the groups at infinity
    if (!given.prescription || given.prescription->objectDistances.empty() || given.filmDistance)
        return 0.0;
    return StateFor(*given.prescription, [&](double focalLength) { return FilmVergence(camera, given, focalLength); });
}

/// @throws OpticsError  if the aperture is wider than the glass or the film within it
void ApplyPrescription(SolvedLens& lens, const Statement& given)
{
    const auto glass = std::make_shared<GlassLens>(*given.prescription);
    const CardinalPoints& points = glass->Cardinal();
    const double fNumber = lens.focalLength / lens.diameter;
    if (!(fNumber >= points.fNumber * (1.0 - kSameFNumber)))
        throw OpticsError("The aperture of f/" + Number(fNumber) + " is wider than the lens of the prescription, which is open to f/" +
                          Number(points.fNumber) + ". Give a greater f_stop or a smaller aperture, or neither for the lens wide open.");
    const double room = RoomBehind(lens, points);
    if (!(room > 0.0))
        throw OpticsError("The film lies within the glass: a corner of the frame is " + Number(-room) +
                          " mm before the last surface of the "
                          "lens. Focus nearer, or turn or shift the lens less.");
    if (given.fStop || given.aperture > 0.0)
        glass->StopDown(fNumber);
    lens.glass = glass;
    if (given.dispersion)
        lens.dispersion = given.prescription;
}

} // namespace

SolvedLens Solve(const CameraFrame& camera, const Statement& written)
{
    const Statement statement = WithWidestStop(camera, written);
    const double groups = GroupsOf(camera, statement);
    const Statement focused = WithGroups(statement, groups);
    SolvedLens lens = SolveThinLens(camera, IdealStatement(focused));
    lens.groups = groups;
    if (focused.prescription)
        ApplyPrescription(lens, focused);
    return lens;
}

Statement IdealStatement(const Statement& given)
{
    if (!given.prescription)
        return given;
    Statement ideal = given;
    const CardinalPoints points = GlassLens(*given.prescription).Cardinal();
    ideal.focalLength = points.focalLength;
    if (!given.fStop && given.aperture == 0.0)
        ideal.fStop = points.fNumber;
    ideal.prescription.reset();
    return ideal;
}

Statement WithGroups(const Statement& given, double state)
{
    if (!given.prescription || given.prescription->objectDistances.empty())
        return given;
    Statement focused = given;
    focused.prescription = std::make_shared<const Prescription>(InState(*given.prescription, state));
    return focused;
}

} // namespace tilt_lens
