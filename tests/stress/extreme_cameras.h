// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file extreme_cameras.h
/// Random cameras at each limit of floating point.

#ifndef TILT_LENS_TESTS_EXTREME_CAMERAS_H
#define TILT_LENS_TESTS_EXTREME_CAMERAS_H

#include <cfloat>
#include <limits>
#include <vector>

#include "../unit/random_cameras.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

struct ExtremeSet
{
    const char* name;
    const char* title;
    void (*pull)(Random& random, Request& request, FilmPoint& at);
};

inline double Sign(Random& random)
{
    return random.Coin() ? 1.0 : -1.0;
}

inline double DistanceToFocus(const Request& r)
{
    return Length(r.given.focalPoint - r.camera.location);
}

inline void SetPlane(Request& r, const Vec3& normal, const Vec3& point)
{
    r.given.family = FocusFamily::FocalPlane;
    r.given.planeNormal = normal;
    r.given.planeDistance = Dot(Normalized(normal), point);
}

inline void PullTilt(Random& random, Request& r, FilmPoint&)
{
    r.given.family = FocusFamily::LensTurn;
    (random.Coin() ? r.given.tilt : r.given.swing) = Sign(random) * (random.Coin() ? 89.9 : random(75.0, 89.9));
    // a point aside would be behind the lens
    r.given.focalPoint = r.camera.location + DistanceToFocus(r) * AxisOf(r.camera);
}

/// Rays parallel to the plane, exactly or up to 1e-12, focus almost at infinity.
inline void PullParallel(Random& random, Request& r, FilmPoint& at)
{
    if (random.Coin())
    {
        r = PlainRequest();
        at = {random(-0.5, 0.5), 0.0};
        SetPlane(r, {0, 1, 0}, {0, Sign(random) * random(0.1, 2.0), 0});
        return;
    }
    const Vec3 ray = Normalized(r.camera.direction + at.x * r.camera.right + at.y * r.camera.up);
    const Vec3 across = Normalized(Cross(ray, random.Direction()));
    const Vec3 normal = Normalized(across + Sign(random) * random.Power(-16.0, -11.0) * ray);
    SetPlane(r, normal, r.camera.location + DistanceToFocus(r) * random(-1.0, 1.0) * across);
}

inline void PullThroughView(Random& random, Request& r, FilmPoint&)
{
    const Vec3 axis = AxisOf(r.camera);
    const Vec3 across = Normalized(Cross(axis, random.Direction()));
    const Vec3 normal = Normalized(across + random(-0.5, 0.5) * axis);
    const double reach = DistanceToFocus(r) + Length(r.camera.location);
    SetPlane(r, normal, r.camera.location + Sign(random) * reach * random.Power(-13.0, 0.0) * normal);
}

inline void PullBehind(Random& random, Request& r, FilmPoint&)
{
    const Vec3 axis = AxisOf(r.camera);
    const Vec3 across = Normalized(Cross(axis, random.Direction()));
    SetPlane(r, Normalized(axis + random(-1.0, 1.0) * across), r.camera.location - DistanceToFocus(r) * random.Power(-1.0, 6.0) * axis);
}

inline void PullFarFocus(Random& random, Request& r, FilmPoint&)
{
    const Vec3 axis = AxisOf(r.camera);
    const double far = random.Coin() ? 1e12 : random.Power(9.0, 15.0);
    for (Vec3* p : {&r.given.focalPoint, &r.given.points[0], &r.given.points[1], &r.given.points[2]})
        *p = r.camera.location + (far / DistanceToFocus(r)) * (*p - r.camera.location);
    r.given.planeDistance = Dot(Normalized(r.given.planeNormal), r.camera.location + far * axis);
}

inline void MoveAway(Random& random, Request& r, double distance)
{
    const Vec3 offset = distance * random.Direction();
    r.camera.location = r.camera.location + offset;
    for (Vec3* p : {&r.given.focalPoint, &r.given.points[0], &r.given.points[1], &r.given.points[2]})
        *p = *p + offset;
    r.given.planeDistance += Dot(Normalized(r.given.planeNormal), offset);
}

inline void PullFarCamera(Random& random, Request& r, FilmPoint&)
{
    MoveAway(random, r, 1e7);
}
inline void PullFartherCamera(Random& random, Request& r, FilmPoint&)
{
    MoveAway(random, r, 1e12);
}

inline void PullScale(Random& random, Request& r, FilmPoint&)
{
    const double scale = random.Power(-9.0, 9.0);
    for (Vec3* v : {&r.camera.location, &r.camera.direction, &r.camera.right, &r.camera.up, &r.given.focalPoint, &r.given.points[0],
                    &r.given.points[1], &r.given.points[2]})
        *v = scale * *v;
    r.given.planeDistance *= scale;
    r.given.aperture *= scale;
    if (random.Coin())
        r.given.sceneUnit /= scale;
}

inline void PullUnit(Random& random, Request& r, FilmPoint&)
{
    r.given.sceneUnit = random.Power(-9.0, 9.0);
}

inline void PullAperture(Random& random, Request& r, FilmPoint&)
{
    r.given.fStop.reset();
    const double shares[] = {0.0, 1e-300, 1e-30, 1e-9, 1.0, 4.0, 1e3};
    r.given.aperture = DistanceToFocus(r) * shares[int(random(0.0, 7.0))];
}

inline void PullFilm(Random& random, Request& r, FilmPoint&)
{
    const double width = random.Power(-1.0, 4.0);
    const double ratio = width / r.given.filmWidth;
    r.given.filmWidth = width;
    r.given.shiftRight *= ratio;
    r.given.shiftUp *= ratio;
    if (r.given.focalLength)
        r.given.focalLength = *r.given.focalLength * ratio;
}

inline void PullNarrow(Random& random, Request& r, FilmPoint&)
{
    const double share = random.Power(-9.0, -4.0);
    r.camera.right = share * r.camera.right;
    r.camera.up = share * r.camera.up;
    // a focal length would set the angle of view
    r.given.focalLength.reset();
}

inline void PullNothing(Random&, Request&, FilmPoint&) {}

inline void PullCorners(Random& random, Request&, FilmPoint& at)
{
    const double middle = 0.5 - 0.5e-5;
    at = {Sign(random) * middle, Sign(random) * middle};
}

inline void PullOddNumbers(Random& random, Request& r, FilmPoint&)
{
    Statement& s = r.given;
    std::vector<double*> fields = {&s.filmWidth,     &s.sceneUnit,  &s.tilt,    &s.swing,    &s.focusTilt, &s.focusSwing,
                                   &s.planeDistance, &s.shiftRight, &s.shiftUp, &s.aperture, &s.scale};
    for (Vec3* v : {&r.camera.location, &r.camera.direction, &r.camera.right, &r.camera.up, &s.planeNormal, &s.points[0], &s.points[1],
                    &s.points[2], &s.focalPoint})
        for (double* component : {&v->x, &v->y, &v->z})
            fields.push_back(component);
    if (s.focalLength)
        fields.push_back(&*s.focalLength);
    if (s.fStop)
        fields.push_back(&*s.fStop);

    const double infinity = std::numeric_limits<double>::infinity();
    const double odd[] = {0.0,     -0.0,     5e-324,   -5e-324,   1e-310,
                          -1e-310, DBL_MIN,  1e-150,   1e150,     1e300,
                          DBL_MAX, -DBL_MAX, infinity, -infinity, std::numeric_limits<double>::quiet_NaN()};
    const int count = 1 + int(random(0.0, 3.0));
    for (int i = 0; i < count; i++)
        *fields[std::size_t(random(0.0, double(fields.size())))] = odd[std::size_t(random(0.0, double(sizeof odd / sizeof *odd)))];
}

inline void PullSeveral(Random& random, Request& r, FilmPoint& at)
{
    void (*const pulls[])(Random&, Request&, FilmPoint&) = {PullTilt,     PullParallel,  PullThroughView,   PullBehind,
                                                            PullFarFocus, PullFarCamera, PullFartherCamera, PullScale,
                                                            PullUnit,     PullAperture,  PullFilm};
    for (int i = 0; i < 3; i++)
        pulls[std::size_t(random(0.0, double(sizeof pulls / sizeof *pulls)))](random, r, at);
}

const ExtremeSet kExtremeSets[] = {
    {"corners", "corners of a picture 100,000 pixels wide", PullCorners},
    {"tilt", "lens turned by 75 to 89.9 degrees", PullTilt},
    {"parallel", "plane of focus parallel to the ray, exactly or but for 1e-11 to 1e-16", PullParallel},
    {"through_view", "plane of focus through the view, down to 1e-13 of the numbers it is written with", PullThroughView},
    {"behind", "plane of focus behind the camera", PullBehind},
    {"far_focus", "plane of focus 1e9 to 1e15 away", PullFarFocus},
    {"far_camera", "camera and scene 1e7 from the origin", PullFarCamera},
    {"farther_camera", "camera and scene 1e12 from the origin", PullFartherCamera},
    {"scale", "the whole scene 1e-9 to 1e9 times as large", PullScale},
    {"unit", "scene_unit from 1e-9 to 1e9 mm", PullUnit},
    {"aperture", "aperture from 0 to 1000 times the distance", PullAperture},
    {"film", "film from 0.1 mm to 10 m", PullFilm},
    {"narrow", "angle of view 1e-4 to 1e-9 of a usual one", PullNarrow},
    {"odd_numbers", "zeros of both signs, denormals, the largest numbers, infinities, NaN", PullOddNumbers},
    {"several", "three of these at once", PullSeveral},
};

} // namespace tilt_lens

#endif
