// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/apply_character.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

namespace
{

constexpr double kMostLateralColour = 0.25;

/// Squared tangent between the lens's axis and the frame's farthest chief ray.
double FarthestOf(const Lens& lens)
{
    double farthest = 0.0;
    ForCorners([&](const FilmPoint& corner)
    {
        const Vec3 chief = IdealChiefRay(lens, corner);
        const double along = Dot(chief, lens.normal);
        if (!(along > 0.0))
            throw OpticsError("The frame reaches behind the turned lens, where distortion, field_curvature, optical_vignetting and "
                              "lateral_colour have no meaning. Turn the lens or shift the frame less, or remove these items.");
        farthest = std::max(farthest, Dot(chief, chief) / (along * along) - 1.0);
    });
    return farthest;
}

void RequireUnfolded(const Lens& lens, const Character& character, double unit, double farthest)
{
    // distortionNear first folds the picture in this direction
    const Vec3 across = lens.focus - Dot(lens.focus, lens.normal) * lens.normal;
    const double atAxis = lens.distortion2 + lens.distortionNear * Dot(lens.focus, lens.normal);
    const double fold = FoldOf(atAxis, lens.distortion4, -std::fabs(lens.distortionNear) * Length(across));
    if (!(farthest < fold))
        throw OpticsError("distortion " + Number(character.distortion1) + ", " + Number(character.distortion2) +
                          (character.distortionNear != 0.0 ? ", " + Number(character.distortionNear) : "") + " folds the picture: beyond " +
                          Number(std::sqrt(fold) / unit) +
                          " half widths of the film from the "
                          "lens's axis it would show the same again, and the frame reaches to " +
                          Number(std::sqrt(farthest) / unit) + ". Give numbers nearer to 0, or shift or turn less.");
}

void RequireBefore(const Lens& lens)
{
    ForCorners([&](const FilmPoint& corner)
    {
        const Vec3 ideal = ChiefRay(lens, corner);
        if (!(Dot(ideal, lens.normal) > 0.0) || !(Dot(ideal, ideal) < 1e6 * Dot(lens.direction, lens.direction)))
            throw OpticsError("distortion bends a corner of the turned lens's picture backward. Give numbers nearer to 0, or shift "
                              "or turn less.");
    });
}

double AxialColourOf(const Lens& lens, const Character& character)
{
    return 0.5 * character.axialColour * lens.millimetre / (lens.filmDistance * lens.filmDistance);
}

double LateralColourOf(const Lens& lens, const Character& character, double unit)
{
    const double halfWidth = unit * lens.filmDistance;
    const double larger = 0.5 * character.lateralColour * lens.millimetre / halfWidth;
    if (!(std::fabs(larger) < kMostLateralColour))
        throw OpticsError("lateral_colour " + Number(character.lateralColour) +
                          " moves the colours by more than half of the film's half "
                          "width, " +
                          Number(halfWidth / lens.millimetre) + " mm. Real lenses have 0.005 to 0.05; give a smaller number.");
    return larger;
}

} // namespace

void ApplyCharacter(Lens& lens, const Statement& given)
{
    const Character& character = given.character;
    const bool distorts = character.Distorts();
    if (character.rimStop && *character.rimStop * lens.diameter > lens.focalLength * (1.0 + 1e-9))
        throw OpticsError("optical_vignetting has a rim of f/" + Number(*character.rimStop) +
                          ", which is narrower than the aperture of f/" + Number(lens.focalLength / lens.diameter) +
                          ". It must be at least as wide; give the f-number of the lens "
                          "wide open.");
    lens.axialColour = AxialColourOf(lens, character);
    if (!distorts && character.fieldCurvature == 0.0 && character.opticalVignetting == 0.0 && character.lateralColour == 0.0)
        return;
    const double farthest = FarthestOf(lens);
    const double unit = 0.5 * Length(lens.right) / Dot(lens.direction, lens.axis);  // tangent of half the film's width
    if (distorts)
    {
        lens.distorts = true;
        lens.distortion2 = character.distortion1 / (unit * unit);
        lens.distortion4 = character.distortion2 / (unit * unit * unit * unit);
        lens.distortionNear = character.distortionNear * lens.focalLength / (unit * unit);
        RequireUnfolded(lens, character, unit, farthest);
        RequireBefore(lens);
    }
    // moving the image by S changes the vergence by S/s^2
    lens.lateralColour = LateralColourOf(lens, character, unit);
    lens.fieldCurvature = character.fieldCurvature * lens.millimetre / (lens.filmDistance * lens.filmDistance * unit * unit);
}

} // namespace tilt_lens
