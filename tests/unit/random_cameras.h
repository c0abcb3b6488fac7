// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file random_cameras.h
/// Random solvable cameras: angles of view 10 to 100 degrees, lens turns up to 30, planes up to 75 degrees,
/// focus from 5 to 10^4 focal lengths, f/1 to f/32.

#ifndef TILT_LENS_TESTS_RANDOM_CAMERAS_H
#define TILT_LENS_TESTS_RANDOM_CAMERAS_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <ostream>
#include <random>
#include <sstream>
#include <string>

#include "tilt_lens/lens_camera/solve.h"

namespace tilt_lens
{

constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// Gives the same numbers with every standard library.
class Random
{
  public:
    explicit Random(std::uint64_t seed) : engine(seed) {}

    double operator()(double low, double high) { return low + (high - low) * double(engine() >> 11) * 0x1p-53; }
    double Power(double lowExponent, double highExponent) { return std::pow(10.0, (*this)(lowExponent, highExponent)); }
    bool Coin() { return engine() >> 63; }
    Vec3 Vector(double most) { return {(*this)(-most, most), (*this)(-most, most), (*this)(-most, most)}; }

    Vec3 Direction()
    {
        for (;;)
        {
            const Vec3 v = Vector(1.0);
            const double length = Length(v);
            if (length > 0.1 && length < 1.0)
                return v / length;
        }
    }

  private:
    std::mt19937_64 engine;
};

struct Request
{
    CameraFrame camera;
    Statement given;
};

inline std::ostream& operator<<(std::ostream& out, const Vec3& v)
{
    return out << '<' << v.x << ", " << v.y << ", " << v.z << '>';
}

inline std::ostream& operator<<(std::ostream& out, const Request& request)
{
    const CameraFrame& c = request.camera;
    const Statement& s = request.given;
    std::ostringstream text;
    text << std::setprecision(17) << "location " << c.location << " direction " << c.direction << " right " << c.right << " up " << c.up
         << "\nfilm_width " << s.filmWidth << " scene_unit " << s.sceneUnit << " scale " << s.scale << " family " << int(s.family);
    if (s.focalLength)
        text << " focal_length " << *s.focalLength;
    text << "\ntilt " << s.tilt << " swing " << s.swing << " focus_tilt " << s.focusTilt << " focus_swing " << s.focusSwing
         << " focal_plane " << s.planeNormal << ", " << s.planeDistance << " focal_points " << s.points[0] << s.points[1] << s.points[2]
         << " focal_point " << s.focalPoint << "\nshift <" << s.shiftRight << ", " << s.shiftUp << "> aperture " << s.aperture;
    if (s.fStop)
        text << " f_stop " << *s.fStop;
    return out << text.str();
}

/// 1.6 by 1.2, angle of view 53 degrees.
inline Request PlainRequest()
{
    Request request;
    request.camera = {{0, 0, 0}, {0, 0, 1.6}, {1.6, 0, 0}, {0, 1.2, 0}};
    request.given.focalPoint = {0, 0, 5};
    request.given.fStop = 2.0;
    return request;
}

inline Lens Solved(const Request& request)
{
    return Solve(request.camera, request.given);
}

inline std::shared_ptr<const SolvedLens> Shared(const SolvedLens& lens)
{
    return std::make_shared<const SolvedLens>(lens);
}

inline CameraFrame RandomFrame(Random& random)
{
    const Vec3 axis = random.Direction();
    const Vec3 right = Normalized(Cross(axis, random.Direction()));
    const Vec3 up = Cross(axis, right) * (random.Coin() ? 1.0 : -1.0);
    const double unit = random.Power(-1.0, 1.0), aspect = random(0.5, 2.0);

    CameraFrame camera;
    camera.location = random.Vector(10.0);
    camera.right = unit * aspect * right;
    camera.up = unit * (up + (random.Coin() ? random(-0.3, 0.3) : 0.0) * right);
    camera.direction = 0.5 * unit * aspect / std::tan(random(5.0, 50.0) * kDegree) * axis;
    if (random.Coin())
        camera.direction = camera.direction + random(-0.3, 0.3) * camera.right + random(-0.3, 0.3) * camera.up;
    return camera;
}

inline Vec3 AxisOf(const CameraFrame& camera)
{
    const Vec3 axis = Normalized(Cross(camera.right, camera.up));
    return Dot(axis, camera.direction) < 0.0 ? -axis : axis;
}

inline void RandomFocus(Random& random, const CameraFrame& camera, double distance, Statement& s)
{
    const Vec3 axis = AxisOf(camera), right = Normalized(camera.right), up = Cross(axis, right);
    const Vec3 offset = distance * (axis + random(-0.3, 0.3) * right + random(-0.3, 0.3) * up);
    s.focalPoint = camera.location + offset;
    s.tilt = random(-30.0, 30.0);
    s.swing = random(-30.0, 30.0);
    s.focusTilt = random(-75.0, 75.0);
    s.focusSwing = random(-75.0, 75.0);

    const Vec3 across = random.Direction();
    const Vec3 normal = Normalized(axis + std::tan(random(0.0, 75.0) * kDegree) * Normalized(Cross(axis, across)));
    s.planeNormal = random.Power(-1.0, 1.0) * (random.Coin() ? normal : -normal);
    s.planeDistance = Dot(s.planeNormal, s.focalPoint) / Length(s.planeNormal);
    const Vec3 u = Normalized(Cross(normal, random.Direction())), v = Cross(normal, u);
    s.points[0] = s.focalPoint;
    s.points[1] = s.focalPoint + distance * (random(0.2, 1.0) * u + random(-0.5, 0.5) * v);
    s.points[2] = s.focalPoint + distance * (random(-0.5, 0.5) * u - random(0.2, 1.0) * v);
}

inline Request RandomRequest(Random& random, FocusFamily family, bool focalLengthGiven)
{
    Request request;
    request.camera = RandomFrame(random);
    Statement& s = request.given;
    s.family = family;
    s.filmWidth = random(8.0, 200.0);
    s.sceneUnit = random.Power(0.0, 4.0);
    const double filmDistance = s.filmWidth * Dot(AxisOf(request.camera), request.camera.direction) / Length(request.camera.right);
    if (focalLengthGiven)
        s.focalLength = filmDistance * random(0.8, 1.2);
    RandomFocus(random, request.camera, filmDistance / s.sceneUnit * random.Power(0.7, 4.0), s);
    s.shiftRight = random(-0.2, 0.2) * s.filmWidth;
    s.shiftUp = random(-0.2, 0.2) * s.filmWidth;
    if (random.Coin())
        s.fStop = random.Power(0.0, 1.5);
    else
        s.aperture = 2.0 * filmDistance / s.sceneUnit / random.Power(0.0, 1.5);
    return request;
}

inline bool CouldBeBuilt(const Lens& lens)
{
    for (int corner = 0; corner < 4; corner++)
    {
        const Vec3 chief = lens.direction + (corner & 1 ? 0.5 : -0.5) * lens.right + (corner & 2 ? 0.5 : -0.5) * lens.up;
        if (!(Dot(lens.normal, chief) > 0.2 * Length(chief)))
            return false;
    }
    const double dip = std::hypot(Dot(lens.lensX, lens.axis), Dot(lens.lensY, lens.axis));
    return dip < 0.5 * lens.filmDistance && lens.diameter < 2.0 * lens.focalLength;
}

inline Request SolvableRequest(Random& random, FocusFamily family, bool focalLengthGiven, Lens& lens)
{
    for (;;)
    {
        const Request request = RandomRequest(random, family, focalLengthGiven);
        try
        {
            lens = Solve(request.camera, request.given);
        }
        catch (const OpticsError&)
        {
            continue;
        }
        if (CouldBeBuilt(lens))
            return request;
    }
}

} // namespace tilt_lens

#endif
