// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_numbers.cpp
/// Numbers for photographers, blur, and warnings.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

namespace
{

const double kInfinity = std::numeric_limits<double>::infinity();

/// Degrees; real lenses stop at about 10.
const double kUnusualTilt = 15.0;

/// Film widths; real lenses stop at a third.
const double kUnusualShift = 1.0;

double Degrees(double radians)
{
    return radians * (180.0 / kPi);
}

std::string NumberBelow(double value, double limit)
{
    const std::string text = Number(value);
    return text == Number(limit) && value < limit ? "almost " + text : text;
}

/// Rounding errors become 0.
Vec3 InCamera(const Lens& lens, const Vec3& v)
{
    const double rounding = kRounding * Length(v);
    const auto part = [&](const Vec3& axis)
    {
        const double along = Dot(v, axis);
        return std::fabs(along) > rounding ? along : 0.0;
    };
    return {part(lens.axisRight), part(lens.axisUp), part(lens.axis)};
}

/// The inverse distance is linear over the frame, so testing its corners suffices.
bool IsSharpBehindOnly(const Lens& lens)
{
    for (double x : {-0.5, 0.5})
        for (double y : {-0.5, 0.5})
            if (lens.focusMiddle + x * lens.focusRight + y * lens.focusUp > 0.0)
                return false;
    return true;
}

std::string WayToBringItForward(const Statement& given)
{
    if (!given.filmDistance)
        return "Compare the plane or points with location and look_at, and the sign of the plane's distance.";
    return "film_distance " + Number(*given.filmDistance) + " is too near for focal_length " + Number(*given.focalLength) +
           ", at which a lens that is not turned is focused at infinity. Give a larger film_distance.";
}

} // namespace

std::vector<std::string> Warnings(const Lens& lens, const Statement& given)
{
    std::vector<std::string> warnings;
    const Vec3 t = InCamera(lens, lens.normal);
    const double turn = Degrees(std::atan2(std::hypot(t.x, t.y), t.z));
    if (turn > kUnusualTilt * (1.0 + kRounding))
        warnings.push_back("The lens is turned by " + NumberBelow(turn, 90.0) +
                           " degrees; real lenses stop at about 10. "
                           "The picture is right, but check focal length, scene_unit and the plane of focus.");
    if (lens.diameter == 0.0 && (turn > 0.0 || given.family != FocusFamily::LensTurn))
        warnings.push_back("Without an aperture everything is sharp and the tilt shows nothing; give "
                           "aperture or f_stop.");
    if (lens.diameter > 0.0 && Length(lens.focus) > 0.0 && lens.fieldCurvature == 0.0 && IsSharpBehindOnly(lens))
        warnings.push_back("The plane of sharp focus lies behind the camera in the whole picture, so that nothing in it can be "
                           "sharp. " +
                           WayToBringItForward(given));
    if (std::hypot(given.shiftRight, given.shiftUp) > kUnusualShift * given.filmWidth)
        warnings.push_back("The frame is shifted by <" + Number(given.shiftRight) + ", " + Number(given.shiftUp) +
                           "> mm on a "
                           "film " +
                           Number(given.filmWidth) +
                           " mm wide; real lenses stop at about a third of it. The picture "
                           "is right, but check that the shift is in millimetres of film.");
    const double radius = 0.5 * lens.diameter;
    if (radius * std::hypot(t.x, t.y) >= lens.filmDistance)
        warnings.push_back("The turned lens is so large that its rim passes through the film: its radius is " + Number(radius) +
                           " units, the film is " + Number(lens.filmDistance) +
                           " units away. No "
                           "lens could be built so; check scene_unit, give a smaller aperture or a larger f_stop, or "
                           "turn it less.");
    return warnings;
}

double TiltOf(const Lens& lens)
{
    const Vec3 t = InCamera(lens, lens.normal);
    return Degrees(std::atan2(-t.y, t.z)) + 0.0;  // never -0
}

double SwingOf(const Lens& lens)
{
    const Vec3 t = InCamera(lens, lens.normal);
    return Degrees(std::atan2(-t.x, t.z)) + 0.0;
}

double FocusAngleOf(const Lens& lens)
{
    const Vec3 k = InCamera(lens, lens.focus);
    return Degrees(std::atan2(std::hypot(k.x, k.y), std::fabs(k.z)));
}

double HingeDistanceOf(const Lens& lens)
{
    const Vec3 k = InCamera(lens, lens.focus);
    return 1.0 / std::hypot(k.x, k.y);
}

double AxisFocusOf(const Lens& lens)
{
    return 1.0 / InCamera(lens, lens.focus).z;
}

SharpRange SharpRangeOf(const Lens& lens, double width, double pixels)
{
    const double nearest = VergenceOfBlur(lens, lens.axis, pixels, width);
    const double farthest = VergenceOfBlur(lens, lens.axis, -pixels, width);
    SharpRange range;
    range.near = nearest > 0.0 ? 1.0 / nearest : kInfinity;
    range.far = farthest > 0.0 ? 1.0 / farthest : kInfinity;
    return range;
}

double BlurPerVergence(const Lens& lens, double width)
{
    return lens.diameter * width / Length(lens.right);
}

namespace
{

/// Enlargement of blur by distortion; 1 beyond the fold.
double StretchOf(const Lens& lens, const Vec3& chief)
{
    if (!lens.distorts)
        return 1.0;
    const std::optional<FilmPoint> ideal = IdealFilmPointOf(lens, chief);
    const std::optional<FilmPoint> picture = ideal ? PictureFilmPoint(lens, *ideal) : ideal;
    return picture ? PictureStretch(lens, *picture) : 1.0;
}

} // namespace

double BlurDiameter(const Lens& lens, const Vec3& chief, double T, double width)
{
    return BlurVergence(lens, chief, T) * BlurPerVergence(lens, width) * StretchOf(lens, chief);
}

Vec3 PlaneOfBlur(const Lens& lens, double pixels, double width)
{
    // 1/T = w + pixels / BlurPerVergence, multiplied by T
    const double perDistance = BlurPerVergence(lens, width) * Dot(lens.direction, lens.axis);
    return lens.focus + (pixels / perDistance) * lens.axis;
}

double VergenceOfBlur(const Lens& lens, const Vec3& chief, double pixels, double width)
{
    const double ideal = Dot(PlaneOfBlur(lens, pixels / StretchOf(lens, chief), width), chief);
    return lens.fieldCurvature == 0.0 ? ideal : ideal + FieldVergence(lens, chief);
}

} // namespace tilt_lens
