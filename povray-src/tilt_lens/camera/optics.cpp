// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/optics.h"

#include "tilt_lens/camera/apply_character.h"
#include "tilt_lens/camera/real.h"
#include "tilt_lens/camera/sharp_plane.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

Real Radians(double degrees)
{
    static const Real degree = Real("3.14159265358979323846264338327950288419716939937511") / 180;
    return degrees * degree;
}

RealVec Exact(const Vec3& v)
{
    return {v.x, v.y, v.z};
}
Vec3 Rounded(const RealVec& v)
{
    return {double(v.x), double(v.y), double(v.z)};
}

using tilt_lens::Number;
std::string Number(const Real& value)
{
    return Number(double(value));
}

std::string Text(const Vec3& v)
{
    return "<" + Number(v.x) + ", " + Number(v.y) + ", " + Number(v.z) + ">";
}

/// x `right`, y the part of `up` across it, z the film's normal; origin in the lens centre.
struct Axes
{
    RealVec right, up, axis;

    RealVec ToCamera(const RealVec& v) const { return {Dot(v, right), Dot(v, up), Dot(v, axis)}; }
    RealVec ToWorld(const RealVec& v) const { return v.x * right + v.y * up + v.z * axis; }
};

Axes AxesOf(const CameraFrame& camera)
{
    const RealVec direction = Exact(camera.direction);
    const RealVec right = Normalized(Exact(camera.right));
    const RealVec upUnit = Normalized(Exact(camera.up));
    const RealVec upAcross = upUnit - Dot(upUnit, right) * right;
    const RealVec up = Normalized(upAcross);
    RealVec axis = Cross(right, up);
    if (Dot(axis, direction) < 0)
        axis = -axis;
    const Axes axes{right, up, axis};
    const bool independent = Length(upAcross) > kRounding && Dot(axis, direction) > kRounding * Length(direction);
    if (!independent || !IsFinite(camera.location))
        throw OpticsError("The camera spans no picture: direction " + Text(camera.direction) + ", right " + Text(camera.right) + ", up " +
                          Text(camera.up) + ". The three must be finite and independent; give other vectors.");
    return axes;
}

/// Unit normal, camera axes; the order of turns does not matter.
RealVec TurnedNormal(double tiltDegrees, double swingDegrees, const char* what, const char* tiltWord, const char* swingWord)
{
    if (!(std::fabs(tiltDegrees) < 90.0) || !(std::fabs(swingDegrees) < 90.0))
        throw OpticsError(std::string(what) + " is turned by 90 degrees or more: " + tiltWord + " " + Number(tiltDegrees) + ", " +
                          swingWord + " " + Number(swingDegrees) + ". Both must be between -90 and 90; turn it less.");
    const Real tilt = Radians(tiltDegrees), swing = Radians(swingDegrees);
    return Normalized(RealVec{-sin(swing) * cos(tilt), -sin(tilt) * cos(swing), cos(tilt) * cos(swing)});
}

/// k = n/d of the plane n.X = d.
/// @param normal  unit vector, camera axes
/// @param reach   size of the world coordinates, for rounding
RealVec FocusOfPlane(const RealVec& normal, const Real& distance, const Real& reach)
{
    if (!(abs(distance) > kRounding * reach))
        throw OpticsError("The plane of sharp focus passes through the lens centre (its distance from "
                          "the camera's location is " +
                          Number(distance) +
                          "). It must keep away from "
                          "the location; move the plane or the camera.");
    return normal / distance;
}

RealVec FocusOfPoints(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    const RealVec a = Exact(given.points[0]);
    const RealVec ab = Exact(given.points[1]) - a, ac = Exact(given.points[2]) - a;
    const RealVec normal = Cross(Normalized(ab), Normalized(ac));
    // sine of the angle at A; the tolerance allows for typed digits
    if (!(Length(normal) > 1e-12))
        throw OpticsError("The three focal_points lie on one line: " + Text(given.points[0]) + ", " + Text(given.points[1]) + ", " +
                          Text(given.points[2]) + ". They must span a plane; move one of them off the line.");
    const RealVec unit = axes.ToCamera(Normalized(normal));
    const RealVec point = axes.ToCamera(a - Exact(camera.location));
    return FocusOfPlane(unit, Dot(unit, point), Length(point) + Length(camera.location));
}

RealVec FocalPointInCamera(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    const RealVec point = axes.ToCamera(Exact(given.focalPoint) - Exact(camera.location));
    if (!(point.z > 0))
        throw OpticsError("The focal point " + Text(given.focalPoint) +
                          " is not in front of the camera "
                          "(it lies " +
                          Number(point.z) +
                          " units along its axis). It must lie in front; "
                          "give another focal_point or look_at.");
    return point;
}

RealVec FocusOfSharpPoints(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    std::vector<RealVec> points;
    for (const Vec3& point : given.sharpPoints)
        points.push_back(axes.ToCamera(Exact(point) - Exact(camera.location)));
    return LeastGreatestBlur(VergenceEquations(points, given.sharpPoints, camera.location));
}

RealVec GivenFocus(const Axes& axes, const CameraFrame& camera, const Statement& given)
{
    if (given.family == FocusFamily::FocalPoints)
        return FocusOfPoints(axes, camera, given);
    if (given.family == FocusFamily::SharpPoints)
        return FocusOfSharpPoints(axes, camera, given);
    if (given.family == FocusFamily::FocalPlane)
    {
        const double length = Length(given.planeNormal);
        if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(given.planeDistance))
            throw OpticsError("The normal of focal_plane has no direction: " + Text(given.planeNormal) +
                              ". It must be finite and not zero; write it as a plane's normal.");
        const RealVec unit = Normalized(Exact(given.planeNormal));
        return FocusOfPlane(axes.ToCamera(unit), given.planeDistance - Dot(unit, Exact(camera.location)),
                            std::fabs(given.planeDistance) + Length(camera.location));
    }
    const RealVec normal = TurnedNormal(given.focusTilt, given.focusSwing, "The plane of sharp focus", "focus_tilt", "focus_swing");
    const RealVec point = FocalPointInCamera(axes, camera, given);
    return FocusOfPlane(normal, Dot(normal, point), Length(point) + Length(camera.location));
}

/// Camera axes, scene units.
struct Solution
{
    RealVec normal;
    Real focalLength, filmDistance;
    RealVec focus;
};

Solution SolveLensTurn(const RealVec& t, const RealVec& P, const std::optional<Real>& focalLength, const Real& angleFilmDistance)
{
    const Real along = Dot(P, t);
    const Real aside = t.x * P.x + t.y * P.y;
    if (!(along > 0))
        throw OpticsError("The lens is turned so far that the focal point lies behind it (distance " + Number(along) +
                          " units from the lens plane). It must lie before the lens; "
                          "turn the lens less or move focal_point.");
    if (!focalLength)
    {
        const Real s = angleFilmDistance, f = s * along / (s + P.z);
        const Real fromFilm = 1.0 / (s * along);
        // t/f - z/s without cancellation of the large terms
        const RealVec k{t.x / f, t.y / f, t.z / along - aside * fromFilm};
        return {t, f, s, k};
    }
    const Real f = *focalLength;
    if (!(along - f > kRounding * f))
        throw OpticsError("The focus is nearer than the focal length: the focal point lies " + Number(along) +
                          " units from the lens, the focal length is " + Number(f) +
                          " units. A lens forms no picture of it; focus farther away, or give a shorter "
                          "focal_length or a larger scene_unit.");
    const RealVec k{t.x / f, t.y / f, 1.0 / P.z - aside / (f * P.z)};
    return {t, f, f * P.z / (along - f), k};
}

Solution SolveFilm(const RealVec& t, const Real& f, const Real& s)
{
    return {t, f, s, {t.x / f, t.y / f, t.z / f - 1 / s}};
}

/// A lens turned after it was focused at the distance s + f s / (s - f) from film to subject.
Solution SolveFocusScale(const RealVec& t, const Real& scale, const std::optional<Real>& focalLength, const Real& angleFilmDistance)
{
    if (!focalLength)
    {
        const Real s = angleFilmDistance;
        if (!(scale - s > kRounding * s))
            throw OpticsError("focus_scale " + Number(scale) + " ends between the film and the lens, which are " + Number(s) +
                              " units apart with this angle of view. It is measured from the film; give a larger distance or a "
                              "larger scene_unit.");
        return SolveFilm(t, s * (scale - s) / scale, s);
    }
    const Real f = *focalLength, least = 4 * f;
    if (!(scale >= least))
        throw OpticsError("focus_scale " + Number(scale) + " is nearer than any lens of this focal length, " + Number(f) +
                          " units, can focus: film and subject are at least four focal lengths (" + Number(least) +
                          " units) "
                          "apart. Give a larger distance, a larger scene_unit, or film_distance for a picture larger than life.");
    return SolveFilm(t, f, 2 * f * scale / (scale + sqrt(scale * (scale - least))));
}

Solution SolvePlane(const RealVec& k, const std::optional<Real>& focalLength, const Real& angleFilmDistance)
{
    const Real across = sqrt(k.x * k.x + k.y * k.y);  // hinge line's inverse distance
    const char* backward = ". Such a plane needs a lens turned backward; move or turn the plane away from the camera.";
    if (!focalLength)
    {
        const RealVec q{k.x, k.y, k.z + 1.0 / angleFilmDistance};
        const Real length = Length(q);
        if (!(q.z > kRounding * length))
            throw OpticsError("The plane of sharp focus crosses the camera axis between lens and film (at " + Number(1 / k.z) +
                              " units, the film is at " + Number(-angleFilmDistance) + ")" + backward);
        return {q / length, 1.0 / length, angleFilmDistance, k};
    }
    const Real f = *focalLength, sine = f * across;
    if (!(1 - sine > kRounding))
        throw OpticsError("No tilt of this lens reaches the plane of sharp focus: its hinge line is " + Number(1 / across) +
                          " units from the lens, the focal length " + Number(f) +
                          " units. The hinge distance must be larger than the focal length; give a "
                          "shorter focal_length or turn the plane less.");
    const RealVec t{f * k.x, f * k.y, sqrt((1 - sine) * (1 + sine))};
    const Real vergence = t.z / f - k.z;  // 1/s
    if (!(vergence * f > kRounding))
        throw OpticsError("The plane of sharp focus is nearer than this lens can focus: on the axis it is at " + Number(1 / k.z) +
                          " units, the focal length is " + Number(f) +
                          " units. The film "
                          "would lie before the lens; focus farther away or give a shorter focal_length.");
    return {t, f, 1.0 / vergence, k};
}

/// Scene units.
struct Scales
{
    const Real millimetre, filmWidth;
    const Real rightLength;
    const Real angleFilmDistance;

    Scales(const Axes& axes, const CameraFrame& camera, const Statement& given) :
        millimetre(Real(given.scale) / given.sceneUnit),
        filmWidth(given.filmWidth * millimetre),
        rightLength(Length(Exact(camera.right))),
        angleFilmDistance(filmWidth * Dot(axes.axis, Exact(camera.direction)) / rightLength)
    {
    }
};

Solution SolveCamera(const Axes& axes, const CameraFrame& camera, const Statement& given, const Scales& scales)
{
    const Real &millimetre = scales.millimetre, &angleFilmDistance = scales.angleFilmDistance;
    std::optional<Real> focalLength;
    if (given.focalLength)
        focalLength = *given.focalLength * millimetre;
    if (given.family != FocusFamily::LensTurn)
        return SolvePlane(GivenFocus(axes, camera, given), focalLength, angleFilmDistance);
    const RealVec t = TurnedNormal(given.tilt, given.swing, "The lens", "tilt", "swing");
    if (given.filmDistance)
        return SolveFilm(t, *focalLength, *given.filmDistance * millimetre);
    if (given.focusScale)
        return SolveFocusScale(t, Real(*given.focusScale) * given.scale, focalLength, angleFilmDistance);
    return SolveLensTurn(t, FocalPointInCamera(axes, camera, given), focalLength, angleFilmDistance);
}

Real DiameterOf(const Statement& given, const Real& focalLength)
{
    if (given.fStop)
        return focalLength / *given.fStop;
    return Real(given.aperture) * given.scale / 2;  // POV-Ray's aperture is twice the diameter
}

/// Camera axes after the smallest rotation that takes z to t.
void SpanLens(Lens& lens, const Axes& axes, const RealVec& t, const Real& diameter)
{
    const Real radius = diameter / 2, bend = 1 / (1 + t.z);
    const RealVec a{1 - t.x * t.x * bend, -t.x * t.y * bend, -t.x};
    const RealVec b{-t.x * t.y * bend, 1 - t.y * t.y * bend, -t.y};
    lens.lensX = Rounded(radius * axes.ToWorld(a));
    lens.lensY = Rounded(radius * axes.ToWorld(b));
}

RealVec FrameDirection(const Axes& axes, const CameraFrame& camera, const Statement& given, const Real& filmDistance, const Real& filmWidth)
{
    if (!given.focalLength)
        return Exact(camera.direction);
    const RealVec direction = Exact(camera.direction);
    const Real wanted = filmDistance * Length(Exact(camera.right)) / filmWidth;
    return direction + (wanted - Dot(axes.axis, direction)) * axes.axis;
}

/// True if products of three such lengths neither overflow nor underflow.
bool IsModerate(double length)
{
    return length > 1e-100 && length < 1e100;
}

void RequireUsable(const Lens& lens)
{
    bool usable = Length(lens.focus) < 1e100 && lens.diameter >= 0.0 && lens.diameter < 1e100;
    for (double length : {lens.focalLength, lens.filmDistance, lens.millimetre, Dot(lens.direction, lens.axis), Length(lens.direction),
                          Length(lens.right), Length(lens.up)})
        usable = usable && IsModerate(length);
    if (!usable)
        throw OpticsError("The camera's numbers are too large or too small, or have the wrong sign: focal "
                          "length " +
                          Number(lens.focalLength) + ", film distance " + Number(lens.filmDistance) + ", lens diameter " +
                          Number(lens.diameter) + ", a millimetre of film " + Number(lens.millimetre) + ", direction " +
                          Text(lens.direction) + ", right " + Text(lens.right) + ", up " + Text(lens.up) +
                          " units. Lengths must be between 1e-100 and "
                          "1e100; give moderate ones.");
}

} // namespace

double FilmVergence(const CameraFrame& camera, const Statement& given, double focalLength)
{
    const Axes axes = AxesOf(camera);
    const Scales scales(axes, camera, given);
    Statement thin = given;
    thin.focalLength = focalLength;
    try
    {
        return double(scales.millimetre / SolveCamera(axes, camera, thin, scales).filmDistance);
    }
    catch (const OpticsError&)
    {
        return -HUGE_VAL;  // cannot focus; other errors are reported later
    }
}

Lens SolveThinLens(const CameraFrame& camera, const Statement& given)
{
    const Axes axes = AxesOf(camera);
    const Scales scales(axes, camera, given);
    const Solution solved = SolveCamera(axes, camera, given, scales);
    const Real diameter = DiameterOf(given, solved.focalLength);
    const RealVec focus = axes.ToWorld(solved.focus);

    Lens lens;
    lens.axisRight = Rounded(axes.right);
    lens.axisUp = Rounded(axes.up);
    lens.axis = Rounded(axes.axis);
    lens.normal = Rounded(axes.ToWorld(solved.normal));
    lens.focalLength = double(solved.focalLength);
    lens.filmDistance = double(solved.filmDistance);
    lens.focus = Rounded(focus);
    lens.diameter = double(diameter);
    lens.millimetre = double(scales.millimetre);
    lens.right = camera.right;
    lens.up = camera.up;
    const Real perMillimetre = scales.rightLength / given.filmWidth;
    const RealVec direction = FrameDirection(axes, camera, given, solved.filmDistance, scales.filmWidth) +
                              (given.shiftRight * perMillimetre) * axes.right + (given.shiftUp * perMillimetre) * axes.up;
    lens.direction = Rounded(direction);
    lens.focusMiddle = double(Dot(focus, direction));
    lens.focusRight = double(Dot(focus, Exact(camera.right)));
    lens.focusUp = double(Dot(focus, Exact(camera.up)));
    SpanLens(lens, axes, solved.normal, diameter);
    RequireUsable(lens);
    ApplyCharacter(lens, given);
    return lens;
}

}  // namespace tilt_lens
