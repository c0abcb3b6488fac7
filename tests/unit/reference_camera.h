// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reference_camera.h
/// An independent camera in any number type, by the thin lens equation and the intersection of chief ray and
/// plane of sharp focus.

#ifndef TILT_LENS_TESTS_REFERENCE_CAMERA_H
#define TILT_LENS_TESTS_REFERENCE_CAMERA_H

#include <cmath>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// Newton's method from the double's root: Boost's root is too slow for ten million cameras.
template<typename Real>
Real Root(const Real& a)
{
    if (!(a > 0))
        return sqrt(a);
    int power = 0;
    Real m = frexp(a, &power);
    if (power % 2 != 0)
    {
        m *= 2;
        power--;
    }
    Real root = std::sqrt(double(m));
    for (int step = 0; step < 2; step++)
        root = (root + m / root) / 2;
    return ldexp(root, power / 2);
}

template<typename Real>
struct Vec
{
    Real x, y, z;

    Vec() : x(0), y(0), z(0) {}
    Vec(const Real& x, const Real& y, const Real& z) : x(x), y(y), z(z) {}
    explicit Vec(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}

    Vec operator+(const Vec& b) const { return {x + b.x, y + b.y, z + b.z}; }
    Vec operator-(const Vec& b) const { return {x - b.x, y - b.y, z - b.z}; }
    Vec operator*(const Real& s) const { return {x * s, y * s, z * s}; }
    Real Dot(const Vec& b) const { return x * b.x + y * b.y + z * b.z; }
    Vec Cross(const Vec& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
    Real Length() const { return Root(Dot(*this)); }
    Vec Unit() const { return *this * (Real(1) / Length()); }
};

template<typename Real>
struct ReferenceRay
{
    Vec<Real> origin, direction; ///< relative to the lens centre
};

template<typename Real>
class ReferenceCamera
{
  public:
    using V = Vec<Real>;

    ReferenceCamera(const CameraFrame& camera, const Statement& given) : camera(camera), given(given)
    {
        right = V(camera.right).Unit();
        const V cross = V(camera.right).Cross(V(camera.up)).Unit();
        axis = cross.Dot(V(camera.direction)) < 0 ? cross * Real(-1) : cross;
        up = axis.Cross(right);
        if (up.Dot(V(camera.up)) < 0)
            up = up * Real(-1);
        millimetre = Real(given.scale) / Real(given.sceneUnit);
        if (given.focalLength)
            f = Real(*given.focalLength) * millimetre;
        else
            s = Real(given.filmWidth) * millimetre * axis.Dot(V(camera.direction)) / V(camera.right).Length();
        if (given.family == FocusFamily::LensTurn)
            SolveLens();
        else
            SolvePlane();
        Frame();
    }

    ReferenceRay<Real> Ray(double x, double y, double a, double b) const
    {
        const V chief = Chief(x, y), l = LensPoint(a, b);
        if (n.Dot(chief) == 0)
            return {l, chief};
        const Real parameter = d / n.Dot(chief);
        const V way = chief * parameter - l;
        return {l, way * (Real(1) / parameter)};
    }

    V Chief(double x, double y) const { return direction + V(camera.right) * Real(x) + V(camera.up) * Real(y); }
    V LensPoint(double a, double b) const { return Turned(right) * (radius * Real(a)) + Turned(up) * (radius * Real(b)); }
    V Focus() const { return n * (Real(1) / d); }
    Real Radius() const { return radius; }
    Real FilmDistance() const { return s; }

  private:
    const CameraFrame camera;
    const Statement given;
    V right, up, axis, direction;
    V t, n;                           ///< unit normals of lens and plane of sharp focus
    Real d, f, s, radius, millimetre; ///< n.X = d, focal length, film distance

    V TurnedAxis(double tiltDegrees, double swingDegrees) const
    {
        using std::atan;
        using std::tan;
        static const Real degree = atan(Real(1)) / 45;
        return (axis - up * tan(Real(tiltDegrees) * degree) - right * tan(Real(swingDegrees) * degree)).Unit();
    }

    V Local(const Vec3& world) const { return V(world) - V(camera.location); }

    void SolveLens()
    {
        t = TurnedAxis(given.tilt, given.swing);
        const V P = Local(given.focalPoint);
        if (given.focalLength)
            s = f * P.Dot(axis) / (P.Dot(t) - f);
        else
            f = s * P.Dot(t) / (s + P.Dot(axis));
        const V k = t * (Real(1) / f) - axis * (Real(1) / s);
        d = Real(1) / k.Length();
        n = k * d;
    }

    void SolvePlane()
    {
        GivenPlane();
        if (given.focalLength)
        {
            const V across = (n - axis * n.Dot(axis)) * (f / d);
            t = across + axis * Root(Real(1) - across.Dot(across));
            s = Real(1) / (t.Dot(axis) / f - n.Dot(axis) / d);
            return;
        }
        const V q = axis * (Real(1) / s) + n * (Real(1) / d);
        f = Real(1) / q.Length();
        t = q * f;
    }

    void GivenPlane()
    {
        if (given.family == FocusFamily::FocalPlane)
        {
            n = V(given.planeNormal).Unit();
            d = Real(given.planeDistance) - n.Dot(V(camera.location));
            return;
        }
        V P = Local(given.focalPoint);
        if (given.family == FocusFamily::FocusTurn)
            n = TurnedAxis(given.focusTilt, given.focusSwing);
        else
        {
            P = Local(given.points[0]);
            n = (Local(given.points[1]) - P).Cross(Local(given.points[2]) - P).Unit();
        }
        d = n.Dot(P);
    }

    void Frame()
    {
        radius = (given.fStop ? f / Real(*given.fStop) : Real(given.aperture) / 2 * Real(given.scale)) / 2;
        const Real width = V(camera.right).Length(), perMillimetre = width / Real(given.filmWidth);
        const Real depth = s / (Real(given.filmWidth) * millimetre) * width;
        const V middle(camera.direction);
        direction = middle + axis * (depth - axis.Dot(middle)) + right * (Real(given.shiftRight) * perMillimetre) +
                    up * (Real(given.shiftUp) * perMillimetre);
    }

    /// The smallest rotation, by Rodrigues.
    V Turned(const V& v) const
    {
        const V turn = axis.Cross(t);
        const Real sine = turn.Length(), cosine = axis.Dot(t);
        if (sine == 0)
            return v;
        const V about = turn * (Real(1) / sine);
        return v * cosine + about.Cross(v) * sine + about * (about.Dot(v) * (Real(1) - cosine));
    }
};

} // namespace tilt_lens

#endif
