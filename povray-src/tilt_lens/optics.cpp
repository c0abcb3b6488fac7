// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "optics.h"

#include <cstdio>
#include <limits>

namespace tilt_lens
{

namespace
{

const double kPi = 3.14159265358979323846;
const double kInfinity = std::numeric_limits<double>::infinity();

/// A lens turned further has so little left of its own plane that the picture is of no use; makers
/// stop at about 10 degrees.
const double kDoubtfulTilt = 15.0;

/// What rounding may leave, relative to the numbers it comes from, where nothing ought to be left.
const double kRounding = 1e-14;

double Radians(double degrees) { return degrees * (kPi / 180.0); }
double Degrees(double radians) { return radians * (180.0 / kPi); }

std::string Number(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string Text(const Vec3& v)
{
    return "<" + Number(v.x) + ", " + Number(v.y) + ", " + Number(v.z) + ">";
}

/// The camera's own axes: `right`, what is left of `up`, and the film's normal. In this frame
/// everything below is solved: x right, y up, z axis.
struct Axes
{
    Vec3 right, up, axis;

    Vec3 ToCamera(const Vec3& v) const { return {Dot(v, right), Dot(v, up), Dot(v, axis)}; }
    Vec3 ToWorld(const Vec3& v) const { return v.x * right + v.y * up + v.z * axis; }
};

Axes AxesOf(const CameraFrame& camera)
{
    const Vec3 right = Normalized(camera.right);
    const Vec3 upUnit = Normalized(camera.up);
    const Vec3 upAcross = upUnit - Dot(upUnit, right) * right;
    const Vec3 up = Normalized(upAcross);
    Vec3 axis = Normalized(Cross(right, up));
    if (Dot(axis, camera.direction) < 0.0)
        axis = -axis;  // POV-Ray's cameras are left-handed unless `right` is negative
    const Axes axes{right, up, axis};
    // of vectors that depend on each other rounding leaves something, too
    const bool independent = Length(upAcross) > kRounding &&
                             Dot(axis, camera.direction) > kRounding * Length(camera.direction);
    if (!independent || !IsFinite(right) || !IsFinite(axis) || !IsFinite(camera.location))
        throw OpticsError("The camera spans no picture: direction " + Text(camera.direction) +
                          ", right " + Text(camera.right) + ", up " + Text(camera.up) +
                          ". The three must be finite and independent; give other vectors.");
    return axes;
}

/// Unit normal, in camera axes, of a plane turned about the horizontal and the vertical axis. The
/// formula treats both turns alike, so that their order does not matter.
Vec3 TurnedNormal(double tiltDegrees, double swingDegrees, const char* what, const char* tiltWord,
                  const char* swingWord)
{
    if (!(std::fabs(tiltDegrees) < 90.0) || !(std::fabs(swingDegrees) < 90.0))
        throw OpticsError(std::string(what) + " is turned by 90 degrees or more: " + tiltWord + " " +
                          Number(tiltDegrees) + ", " + swingWord + " " + Number(swingDegrees) +
                          ". Both must be between -90 and 90; turn it less.");
    const double tilt = Radians(tiltDegrees), swing = Radians(swingDegrees);
    return Normalized({-std::sin(swing) * std::cos(tilt), -std::sin(tilt) * std::cos(swing),
                       std::cos(tilt) * std::cos(swing)});
}

/// The plane of sharp focus n.X = d (n unit, camera axes, about the lens centre) as k = n/d; reach is
/// the size of the world coordinates that d was computed from.
Vec3 FocusOfPlane(const Vec3& normal, double distance, double reach)
{
    // A plane nearer to the lens centre than rounding can tell is a plane through it.
    if (!(std::fabs(distance) > kRounding * reach))
        throw OpticsError("The plane of sharp focus passes through the lens centre (its distance from "
                          "the camera's location is " + Number(distance) + "). It must keep away from "
                          "the location; move the plane or the camera.");
    return normal / distance;
}

Vec3 FocusOfPoints(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    const Vec3 a = given.points[0] - camera.location;
    const Vec3 ab = given.points[1] - given.points[0], ac = given.points[2] - given.points[0];
    const Vec3 normal = Cross(Normalized(ab), Normalized(ac));
    // sine of the angle at A; 1e-12 is what is left of doubles that were typed with a few digits
    if (!(Length(normal) > 1e-12))
        throw OpticsError("The three focal_points lie on one line: " + Text(given.points[0]) + ", " +
                          Text(given.points[1]) + ", " + Text(given.points[2]) +
                          ". They must span a plane; move one of them off the line.");
    const Vec3 unit = axes.ToCamera(Normalized(normal));
    const Vec3 point = axes.ToCamera(a);
    return FocusOfPlane(unit, Dot(unit, point), Length(point) + Length(camera.location));
}

Vec3 FocalPointInCamera(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    const Vec3 point = axes.ToCamera(given.focalPoint - camera.location);
    if (!(point.z > 0.0))
        throw OpticsError("The focal point " + Text(given.focalPoint) + " is not in front of the camera "
                          "(it lies " + Number(point.z) + " units along its axis). It must lie in front; "
                          "give another focal_point or look_at.");
    return point;
}

/// k of the families that give the plane of sharp focus itself.
Vec3 GivenFocus(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    if (given.family == FocusFamily::FocalPoints)
        return FocusOfPoints(axes, camera, given);
    if (given.family == FocusFamily::FocalPlane)
    {
        const double length = Length(given.planeNormal);
        if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(given.planeDistance))
            throw OpticsError("The normal of focal_plane has no direction: " + Text(given.planeNormal) +
                              ". It must be finite and not zero; write it as a plane's normal.");
        const Vec3 unit = given.planeNormal / length;
        return FocusOfPlane(axes.ToCamera(unit), given.planeDistance - Dot(unit, camera.location),
                            std::fabs(given.planeDistance) + Length(camera.location));
    }
    const Vec3 normal = TurnedNormal(given.focusTilt, given.focusSwing, "The plane of sharp focus",
                                     "focus_tilt", "focus_swing");
    const Vec3 point = FocalPointInCamera(axes, camera, given);
    return FocusOfPlane(normal, Dot(normal, point), Length(point) + Length(camera.location));
}

/// Lens normal t, focal length f, film distance s and focus vector k; camera axes, scene units.
struct Solution
{
    Vec3 normal;
    double focalLength, filmDistance;
    Vec3 focus;
};

/// Lens turned as given, focus on a point P of the axis or beside it.
Solution SolveLensTurn(const Vec3& t, const Vec3& P, const std::optional<double>& focalLength,
                       double angleFilmDistance)
{
    const double along = Dot(P, t);  // distance of P from the lens plane
    const double aside = t.x * P.x + t.y * P.y;
    if (!(along > 0.0))
        throw OpticsError("The lens is turned so far that the focal point lies behind it (distance " +
                          Number(along) + " units from the lens plane). It must lie before the lens; "
                          "turn the lens less or move focal_point.");
    if (!focalLength)
    {
        const double s = angleFilmDistance, f = s * along / (s + P.z);
        const double fromFilm = 1.0 / (s * along);
        // t/f - z/s with the large terms taken out, so that nothing cancels
        const Vec3 k{t.x / f, t.y / f, t.z / along - aside * fromFilm};
        return {t, f, s, k};
    }
    const double f = *focalLength;
    if (!(along > f))
        throw OpticsError("The focus is nearer than the focal length: the focal point lies " +
                          Number(along) + " units from the lens, the focal length is " + Number(f) +
                          " units. A lens forms no picture of it; focus farther away, or give a shorter "
                          "focal_length or a larger scene_unit.");
    const Vec3 k{t.x / f, t.y / f, 1.0 / P.z - aside / (f * P.z)};
    return {t, f, f * P.z / (along - f), k};
}

/// Plane of sharp focus as given, the lens follows.
Solution SolvePlane(const Vec3& k, const std::optional<double>& focalLength, double angleFilmDistance)
{
    const double across = std::hypot(k.x, k.y);  // 1/J
    const char* backward =
        ". Such a plane needs a lens turned backward; move or turn the plane away from the camera.";
    if (!focalLength)
    {
        const Vec3 q{k.x, k.y, k.z + 1.0 / angleFilmDistance};
        const double length = Length(q);
        if (!(q.z > 0.0))
            throw OpticsError("The plane of sharp focus crosses the camera axis between lens and film (at " +
                              Number(1.0 / k.z) + " units, the film is at " + Number(-angleFilmDistance) + ")" +
                              backward);
        return {q / length, 1.0 / length, angleFilmDistance, k};
    }
    const double f = *focalLength, sine = f * across;
    if (!(sine < 1.0))
        throw OpticsError("No tilt of this lens reaches the plane of sharp focus: its hinge line is " +
                          Number(1.0 / across) + " units from the lens, the focal length " + Number(f) +
                          " units. The hinge distance must be larger than the focal length; give a "
                          "shorter focal_length or turn the plane less.");
    const Vec3 t{f * k.x, f * k.y, std::sqrt((1.0 - sine) * (1.0 + sine))};
    const double vergence = t.z / f - k.z;  // 1/s
    if (!(vergence > 0.0))
        throw OpticsError("The plane of sharp focus is nearer than this lens can focus: on the axis it is at " +
                          Number(1.0 / k.z) + " units, the focal length is " + Number(f) + " units. The film "
                          "would lie before the lens; focus farther away or give a shorter focal_length.");
    return {t, f, 1.0 / vergence, k};
}

Solution SolveCamera(const Axes& axes, const CameraFrame& camera, const Statement& given,
                     double angleFilmDistance, double millimetre)
{
    std::optional<double> focalLength;
    if (given.focalLength)
        focalLength = *given.focalLength * millimetre;
    if (given.family != FocusFamily::LensTurn)
        return SolvePlane(GivenFocus(axes, camera, given), focalLength, angleFilmDistance);
    const Vec3 t = TurnedNormal(given.tilt, given.swing, "The lens", "tilt", "swing");
    return SolveLensTurn(t, FocalPointInCamera(axes, camera, given), focalLength, angleFilmDistance);
}

double DiameterOf(const Statement& given, double focalLength)
{
    if (given.fStop)
        return focalLength / *given.fStop;
    return given.aperture * 0.5 * given.scale;  // POV-Ray's aperture is twice the diameter
}

/// The lens plane's own right and up, from the axes by the smallest turn that takes z to t: a
/// polygon or a picture in the lens turns no further than the lens does.
void SpanLens(Lens& lens, const Axes& axes, const Vec3& t)
{
    const double radius = 0.5 * lens.diameter, bend = 1.0 / (1.0 + t.z);
    const Vec3 a{1.0 - t.x * t.x * bend, -t.x * t.y * bend, -t.x};
    const Vec3 b{-t.x * t.y * bend, 1.0 - t.y * t.y * bend, -t.y};
    lens.lensX = radius * axes.ToWorld(a);
    lens.lensY = radius * axes.ToWorld(b);
}

/// `direction` as it was, or made longer or shorter along the axis so that the frame lies at the
/// film's distance; what lies across the axis is a shift that was there before and stays one.
Vec3 FrameDirection(const Axes& axes, const CameraFrame& camera, const Statement& given, double filmDistance,
                    double filmWidth)
{
    if (!given.focalLength)
        return camera.direction;
    const double wanted = filmDistance * Length(camera.right) / filmWidth;
    return camera.direction + (wanted - Dot(axes.axis, camera.direction)) * axes.axis;
}

void RequireUsable(const Lens& lens)
{
    const bool positive = lens.focalLength > 0.0 && lens.filmDistance > 0.0 && lens.millimetre > 0.0 &&
                          lens.diameter >= 0.0 && Dot(lens.direction, lens.axis) > 0.0;
    const double sum = lens.focalLength + lens.filmDistance + lens.millimetre + lens.diameter;
    if (!positive || !std::isfinite(sum + Length(lens.focus) + Length(lens.direction)))
        throw OpticsError("The camera's numbers leave the range of floating point or have the wrong sign: focal "
                          "length " + Number(lens.focalLength) + ", film distance " + Number(lens.filmDistance) +
                          ", lens diameter " + Number(lens.diameter) + ", a millimetre of film " +
                          Number(lens.millimetre) + " units. All must be finite and positive; give moderate "
                          "lengths.");
}

/// A vector of the lens in camera axes, without what is only rounding: the numbers of a parallel lens
/// are to read 0 and infinity however the camera is turned.
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

} // namespace

Lens Solve(const CameraFrame& camera, const Statement& given)
{
    const Axes axes = AxesOf(camera);
    const double millimetre = given.scale / given.sceneUnit;
    const double filmWidth = given.filmWidth * millimetre;
    const double angleFilmDistance = filmWidth * Dot(axes.axis, camera.direction) / Length(camera.right);
    const Solution solved = SolveCamera(axes, camera, given, angleFilmDistance, millimetre);

    Lens lens;
    lens.axisRight = axes.right;
    lens.axisUp = axes.up;
    lens.axis = axes.axis;
    lens.normal = axes.ToWorld(solved.normal);
    lens.focalLength = solved.focalLength;
    lens.filmDistance = solved.filmDistance;
    lens.focus = axes.ToWorld(solved.focus);
    lens.diameter = DiameterOf(given, solved.focalLength);
    lens.millimetre = millimetre;
    lens.right = camera.right;
    lens.up = camera.up;
    // a frame moved by a millimetre moves over the picture by that share of the film's width
    const double perMillimetre = Length(camera.right) / given.filmWidth;
    lens.direction = FrameDirection(axes, camera, given, solved.filmDistance, filmWidth) +
                     (given.shiftRight * perMillimetre) * axes.right +
                     (given.shiftUp * perMillimetre) * axes.up;
    SpanLens(lens, axes, solved.normal);
    RequireUsable(lens);
    return lens;
}

std::vector<std::string> Doubts(const Lens& lens, const Statement& given)
{
    std::vector<std::string> doubts;
    const Vec3 t = InCamera(lens, lens.normal);
    const double turn = Degrees(std::atan2(std::hypot(t.x, t.y), t.z));
    if (turn > kDoubtfulTilt * (1.0 + kRounding))
        doubts.push_back("The lens is turned by " + Number(turn) + " degrees; real lenses stop at about 10. "
                         "The picture is right, but check focal length, scene_unit and the plane of focus.");
    if (lens.diameter == 0.0 && (turn > 0.0 || given.family != FocusFamily::LensTurn))
        doubts.push_back("Without an aperture everything is sharp and the tilt shows nothing; give "
                         "aperture or f_stop.");
    const double radius = 0.5 * lens.diameter;
    if (radius * std::hypot(t.x, t.y) >= lens.filmDistance)
        doubts.push_back("The turned lens is so large that its rim passes through the film: its radius is " +
                         Number(radius) + " units, the film is " + Number(lens.filmDistance) + " units away. No "
                         "lens could be built so; check scene_unit, give a smaller aperture or a larger f_stop, or "
                         "turn it less.");
    return doubts;
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
    // Blur in pixels of a point at Z on the axis: |1/Z - k.z| * diameter * (axis component of
    // `direction`) * width / |right|; the longest diameter of the lens lies parallel to the film.
    const double scale = lens.diameter * Dot(lens.direction, lens.axis) * width / Length(lens.right);
    const double allowed = pixels / scale, sharp = Dot(lens.focus, lens.axis);
    SharpRange range;
    range.near = sharp + allowed > 0.0 ? 1.0 / (sharp + allowed) : kInfinity;
    range.far = sharp - allowed > 0.0 ? 1.0 / (sharp - allowed) : kInfinity;
    return range;
}

} // namespace tilt_lens
