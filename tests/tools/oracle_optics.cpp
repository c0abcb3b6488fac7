// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The imaging equation 1/u + 1/v = 1/f in homogeneous coordinates, which include images at infinity; Scheimpflug's rule. Camera frame:
// lens centre at the origin, x right, y up, z into the scene, film at z = -s.

#include <stdexcept>

#include "oracle_case.h"

namespace witness
{

namespace
{

const double kDegree = std::acos(-1.0) / 180.0;

struct Basis
{
    Vector right, up, axis;
    Vector Local(const Vector& v) const { return {Dot(v, right), Dot(v, up), Dot(v, axis)}; }
    Vector World(const Vector& v) const { return v.x * right + v.y * up + v.z * axis; }
};

Basis LookAt(const Vector& location, const Vector& target)
{
    Basis basis;
    basis.axis = Unit(target - location);
    basis.right = Unit(Cross({0.0, 1.0, 0.0}, basis.axis));
    basis.up = Cross(basis.axis, basis.right);
    return basis;
}

Vector TurnedNormal(double turnUp, double turnRight)
{
    const double a = turnUp * kDegree, b = turnRight * kDegree;
    return Unit({-std::sin(b) * std::cos(a), -std::sin(a) * std::cos(b), std::cos(a) * std::cos(b)});
}

/// Homogeneous points (X, weight): k.X = weight.
Vector PlaneThrough(const Vector points[3], const double weights[3])
{
    const double determinant = Dot(points[0], Cross(points[1], points[2]));
    if (determinant == 0.0)
        throw std::runtime_error("the plane of sharp focus goes through the lens centre, or its points are on one line");
    return (1.0 / determinant) *
           (weights[0] * Cross(points[1], points[2]) + weights[1] * Cross(points[2], points[0]) + weights[2] * Cross(points[0], points[1]));
}

/// Normal t, focal length f, film at -s.
Vector PlaneOfLens(const Vector& t, double f, double s)
{
    const Vector film[3] = {{0.0, 0.0, -s}, {s, 0.0, -s}, {0.0, s, -s}};
    Vector images[3];
    double weights[3];
    for (int i = 0; i < 3; ++i)
    {
        const double v = -Dot(film[i], t);
        images[i] = -f * film[i];  // (u/v) times the mirrored film point, u = v f / (v - f)
        weights[i] = v - f;
    }
    return PlaneThrough(images, weights);
}

/// Scheimpflug: the lens plane contains the line of film and plane.
Vector LensOfPlane(const Vector& k, double s)
{
    const Vector axis{0.0, 0.0, 1.0};
    const Vector along = Cross(axis, k);
    const double across2 = Dot(along, along);
    if (across2 == 0.0)
        return axis;
    const Vector foot = ((1.0 + s * k.z) / across2) * Vector{k.x, k.y, 0.0} - s * axis;
    const Vector t = Unit(Cross(along, foot));
    return t.z > 0.0 ? t : -1.0 * t;
}

double FocalLengthFor(const Vector& t, const Vector& film, const Vector& point)
{
    const double u = Dot(point, t), v = -Dot(film, t);
    return u * v / (u + v);
}

Vector GivenPlane(const CameraGiven& given, const Basis& basis)
{
    if (given.focus == Focus::ThreePoints)
    {
        Vector local[3];
        for (int i = 0; i < 3; ++i)
            local[i] = basis.Local(given.points[i] - given.location);
        const double weights[3] = {1.0, 1.0, 1.0};
        return PlaneThrough(local, weights);
    }
    Vector normal, point;
    if (given.focus == Focus::Plane)
    {
        normal = Unit(given.normal);
        point = given.distance * normal - given.location;
        normal = basis.Local(normal);
        point = basis.Local(point);
    }
    else
    {
        normal = TurnedNormal(given.turnUp, given.turnRight);
        point = basis.Local(given.points[0] - given.location);
    }
    return (1.0 / Dot(normal, point)) * normal;
}

void SolveFocus(const CameraGiven& given, const Basis& basis, CameraSolved& solved)
{
    const double millimetre = 1.0 / given.sceneUnit;
    if (given.focus == Focus::Lens)
    {
        const Vector t = TurnedNormal(given.turnUp, given.turnRight);
        const Vector point = basis.Local(given.points[0] - given.location);
        if (given.focalLength)
        {
            solved.focalLength = *given.focalLength * millimetre;
            solved.filmDistance = solved.focalLength * point.z / (Dot(point, t) - solved.focalLength);
        }
        else
        {
            const double tangent = std::tan(0.5 * *given.angle * kDegree);
            solved.filmDistance = 0.5 * given.filmWidth * millimetre / tangent;
            const Vector film = (-solved.filmDistance / point.z) * point;
            solved.focalLength = FocalLengthFor(t, film, point);
        }
        solved.lensNormal = t;
        solved.focus = PlaneOfLens(t, solved.focalLength, solved.filmDistance);
        return;
    }
    if (given.focalLength)
        throw std::runtime_error("focal_length with a given plane is no case of this oracle");
    solved.filmDistance = 0.5 * given.filmWidth * millimetre / std::tan(0.5 * *given.angle * kDegree);
    solved.focus = GivenPlane(given, basis);
    solved.lensNormal = LensOfPlane(solved.focus, solved.filmDistance);
    const Vector centre{0.0, 0.0, -solved.filmDistance};
    const Vector axisPoint{0.0, 0.0, 1.0 / solved.focus.z};
    solved.focalLength = FocalLengthFor(solved.lensNormal, centre, axisPoint);
}

/// Rotates about the line common to both planes (Rodrigues).
Vector TurnWithLens(const Vector& v, const Vector& t)
{
    const Vector axis{0.0, 0.0, 1.0};
    const Vector hinge = Cross(axis, t);
    const double sine = Length(hinge), cosine = t.z;
    if (sine == 0.0)
        return v;
    const Vector unit = (1.0 / sine) * hinge;
    return cosine * v + sine * Cross(unit, v) + ((1.0 - cosine) * Dot(unit, v)) * unit;
}

Vector Rotated(Vector v, const Vector& degrees)
{
    // POV-Ray's rotations are left-handed
    const double cx = std::cos(degrees.x * kDegree), sx = std::sin(degrees.x * kDegree);
    v = {v.x, cx * v.y - sx * v.z, sx * v.y + cx * v.z};
    const double cy = std::cos(degrees.y * kDegree), sy = std::sin(degrees.y * kDegree);
    v = {cy * v.x + sy * v.z, v.y, -sy * v.x + cy * v.z};
    const double cz = std::cos(degrees.z * kDegree), sz = std::sin(degrees.z * kDegree);
    return {cz * v.x - sz * v.y, sz * v.x + cz * v.y, v.z};
}

void Transform(const Transformation& step, CameraSolved& camera)
{
    if (step.kind == Transformation::Kind::Translate)
    {
        camera.location = camera.location + step.amount;
        return;
    }
    Vector* vectors[] = {&camera.location, &camera.direction, &camera.right, &camera.up, &camera.lensX, &camera.lensY};
    if (step.kind == Transformation::Kind::Rotate)
    {
        for (Vector* v : vectors)
            *v = Rotated(*v, step.amount);
        camera.focus = Rotated(camera.focus, step.amount);
        camera.lensNormal = Rotated(camera.lensNormal, step.amount);
        return;
    }
    const double factor = step.amount.x;
    if (step.amount.y != factor || step.amount.z != factor || factor <= 0.0)
        throw std::runtime_error("the oracle scales a camera evenly or not at all");
    for (Vector* v : vectors)
        *v = factor * *v;
    camera.focus = (1.0 / factor) * camera.focus;
    camera.focalLength *= factor;
    camera.filmDistance *= factor;
}

} // namespace

CameraSolved SolveCase(const CameraGiven& given, double aspect)
{
    const Basis basis = LookAt(given.location, given.lookAt);
    CameraSolved solved;
    SolveFocus(given, basis, solved);

    const double millimetre = 1.0 / given.sceneUnit;
    const double width = given.filmWidth * millimetre;
    solved.location = given.location;
    // unit: film distance; direction has length 1 without shift
    const double s = solved.filmDistance;
    solved.right = (width / s) * basis.right;
    solved.up = (width / (s * aspect)) * basis.up;
    solved.direction = basis.axis + (given.shiftRight * millimetre / s) * basis.right + (given.shiftUp * millimetre / s) * basis.up;

    const double diameter = given.fStop ? solved.focalLength / *given.fStop : 0.5 * *given.aperture;
    const Vector t = solved.lensNormal;
    solved.lensX = 0.5 * diameter * basis.World(TurnWithLens({1.0, 0.0, 0.0}, t));
    solved.lensY = 0.5 * diameter * basis.World(TurnWithLens({0.0, 1.0, 0.0}, t));
    solved.lensNormal = basis.World(t);
    solved.focus = basis.World(solved.focus);
    for (const Transformation& step : given.transformations)
        Transform(step, solved);
    return solved;
}

} // namespace witness
