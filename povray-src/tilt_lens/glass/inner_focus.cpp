// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/inner_focus.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/paraxial.h"

namespace tilt_lens
{

namespace
{

/// Relative tolerance, since files round.
constexpr double kStatedDistance = 0.05;

constexpr int kHalvings = 60;

double ThicknessOf(const PrescriptionRow& row, double state)
{
    if (row.nearThickness.empty())
        return row.thickness;
    const std::size_t before = std::min(std::size_t(state), row.nearThickness.size() - 1);
    const double from = before == 0 ? row.thickness : row.nearThickness[before - 1], share = state - double(before);
    return (1.0 - share) * from + share * row.nearThickness[before];
}

double BehindLast(const Prescription& prescription, double state)
{
    const PrescriptionRow& last = prescription.rows.back();
    return CardinalPointsOf(InState(prescription, 0.0)).backFocus + (ThicknessOf(last, state) - last.thickness);
}

} // namespace

Prescription InState(const Prescription& prescription, double state)
{
    Prescription moved = prescription;
    for (PrescriptionRow& row : moved.rows)
    {
        row.thickness = ThicknessOf(row, state);
        row.nearThickness.clear();
    }
    moved.objectDistances.clear();
    return moved;
}

double FilmPlaceOf(const Prescription& prescription, double state)
{
    const CardinalPoints points = CardinalPointsOf(InState(prescription, state));
    return BehindLast(prescription, state) - points.separation - points.rearVertex;
}

double ObjectDistanceOf(const Prescription& prescription, double state)
{
    const ParaxialMap lens = MapBetween(InState(prescription, state), 0, prescription.rows.size());
    const ParaxialMap toFilm = ParaxialMap{1.0, BehindLast(prescription, state), 0.0, 1.0} * lens;
    return -toFilm.b / toFilm.a;
}

double StateFor(const Prescription& prescription, const std::function<double(double focalLength)>& filmVergence)
{
    const auto tooNear = [&](double state)
    {
        const double focalLength = CardinalPointsOf(InState(prescription, state)).focalLength;
        return filmVergence(focalLength) > 1.0 / FilmPlaceOf(prescription, state);
    };
    double far = 0.0, near = 0.0;
    while (!tooNear(near))
    {
        if (near == double(prescription.objectDistances.size()))
            return near;
        far = near;
        near += 1.0;
    }
    for (int i = 0; i < kHalvings && far < near; i++)
        (tooNear(0.5 * (far + near)) ? near : far) = 0.5 * (far + near);
    return near;
}

void RequireFocuses(const Prescription& prescription, int line)
{
    for (std::size_t i = 0; i < prescription.objectDistances.size(); i++)
    {
        const double stated = prescription.objectDistances[i], traced = ObjectDistanceOf(prescription, double(i + 1));
        if (!(FilmPlaceOf(prescription, double(i + 1)) > 0.0))
            throw PrescriptionError(line, "an object distance of " + Number(stated) +
                                              " for which the film stands before the rear principal "
                                              "point. Are the thicknesses in the order of the object distances?");
        if (!(std::fabs(traced - stated) <= kStatedDistance * stated))
            throw PrescriptionError(line, "an object distance of " + Number(stated) +
                                              " mm, where the glass with the thicknesses for it is focused "
                                              "at " +
                                              Number(traced) + " mm. They must agree within " + Number(100.0 * kStatedDistance) +
                                              " per cent; are all moved thicknesses there, in the order of the object distances?");
    }
}

} // namespace tilt_lens
