// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "glass_camera.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace paper
{

using witness::Cross;
using witness::Dot;
using witness::Unit;

namespace
{

const double kFilmWidth = 36.0;
const double kPi = std::acos(-1.0);

/// A little more than the paraxial pupil: the stop decides.
const double kAim = 1.15;

Vector AtLensPlane(const Ray& ray)
{
    return ray.origin - (ray.origin.z / ray.direction.z) * ray.direction;
}

/// Least squares z = p0 + p1 x + p2 y over (x, y, z), by Cramer's rule.
std::array<double, 3> FitPlane(const std::vector<Vector>& points)
{
    Vector rows[3], right;
    for (const Vector& p : points)
    {
        const double terms[3] = {1.0, p.x, p.y};
        for (int i = 0; i < 3; ++i)
            rows[i] = rows[i] + Vector{terms[i], terms[i] * p.x, terms[i] * p.y};
        right = right + p.z * Vector{1.0, p.x, p.y};
    }
    const Vector &a = rows[0], &b = rows[1], &c = rows[2];  // symmetric: rows are columns
    const double whole = Dot(a, Cross(b, c));
    return {Dot(right, Cross(b, c)) / whole, Dot(a, Cross(right, c)) / whole,
            Dot(a, Cross(b, right)) / whole};
}

}  // namespace

GlassCamera::GlassCamera(const Setting& setting, bool thinOnly)
    : mSetting(setting), mGlass(setting.focalLength, setting.fStop)
{
    mAxis = Unit(Vector{0.0, 3.0, 0.0} - mLocation);
    mRight = Unit(Cross({0.0, 1.0, 0.0}, mAxis));
    mUp = Cross(mAxis, mRight);
    const double angle = setting.tilt * kPi / 180.0;
    mLensUp = {0.0, std::cos(angle), std::sin(angle)};
    mLensAxis = {0.0, -std::sin(angle), std::cos(angle)};
    for (int row = 0; row <= setting.height && !thinOnly; ++row)
        for (int column = 0; column <= setting.width; ++column)
            mNodes.push_back(FitBundle(column, row));
}

Vector GlassCamera::Chief(double x, double y) const
{
    const double s = mSetting.filmDistance, height = kFilmWidth * mSetting.height / mSetting.width;
    return {kFilmWidth / s * (x / mSetting.width - 0.5), height / s * (0.5 - y / mSetting.height),
            1.0};
}

Vector GlassCamera::FromLens(const Vector& v) const
{
    return Vector{v.x, 0.0, 0.0} + v.y * mLensUp + v.z * mLensAxis;
}

Vector GlassCamera::ToLens(const Vector& v) const
{
    return {v.x, Dot(v, mLensUp), Dot(v, mLensAxis)};
}

Ray GlassCamera::ToWorld(const Vector& origin, const Vector& direction) const
{
    const auto world = [this](const Vector& v) { return v.x * mRight + v.y * mUp + v.z * mAxis; };
    return {mLocation + (1.0 / mSetting.sceneUnit) * world(origin), Unit(world(direction))};
}

/// From the film toward a point of the exit pupil; lens frame.
Ray GlassCamera::FilmRay(double x, double y, double a, double b) const
{
    const Vector film =
        ToLens(-mSetting.filmDistance * Chief(x, y)) - Vector{0.0, 0.0, mGlass.Separation()};
    const double radius = kAim * mGlass.PupilRadius();
    const Vector direction = Unit(Vector{radius * a, radius * b, mGlass.ExitPupil()} - film);
    return {film, direction.z < 0.0 ? -1.0 * direction : direction};
}

/// Through an ideal lens: from its point toward the image of the film point, 1/u + 1/v = 1/f.
Ray GlassCamera::ThinRay(const Vector& chief, double a, double b) const
{
    const double radius = 0.5 * mSetting.focalLength / mSetting.fStop, f = mSetting.focalLength;
    const Vector point = FromLens({radius * a, radius * b, 0.0});
    const double v = mSetting.filmDistance * Dot(chief, mLensAxis);
    const Vector image = (f / (v - f) * mSetting.filmDistance) * chief;
    return ToWorld(point, image - point);
}

Vector GlassCamera::Bundle::Direction(double x, double y) const
{
    return {slopes[0] + slopes[1] * x + slopes[2] * y, slopes[3] + slopes[4] * x + slopes[5] * y,
            1.0};
}

Ray GlassCamera::FieldRay(const Bundle& bundle, double a, double b) const
{
    const double radius = 0.5 * mSetting.focalLength / mSetting.fStop;
    return ToWorld(FromLens({radius * a, radius * b, 0.0}),
                   FromLens(bundle.Direction(radius * a, radius * b)));
}

Ray GlassCamera::PupilRay(const Bundle& bundle, const Ray& out) const
{
    const Vector at = AtLensPlane(out);
    return ToWorld(FromLens(at), FromLens(bundle.Direction(at.x, at.y)));
}

GlassCamera::Bundle GlassCamera::FitBundle(double x, double y) const
{
    std::vector<Vector> across, upward;
    const int rings = 4, spokes = 8;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < spokes; ++j)
        {
            const double radius = std::sqrt((i + 0.5) / rings) / kAim;
            const double angle = 2.0 * kPi * (j + 0.5 * (i % 2)) / spokes;
            const auto passage = mGlass.Trace(
                FilmRay(x, y, radius * std::cos(angle), radius * std::sin(angle)), false);
            if (!passage)
                continue;
            const Ray& out = passage->out;
            const Vector at = AtLensPlane(out);
            across.push_back({at.x, at.y, out.direction.x / out.direction.z});
            upward.push_back({at.x, at.y, out.direction.y / out.direction.z});
        }
    if (across.size() < 6)
        throw std::runtime_error("a film point that hardly any ray leaves");
    const auto u = FitPlane(across), v = FitPlane(upward);
    return {{u[0], u[1], u[2], v[0], v[1], v[2]}};
}

/// Between the corners of a pixel.
GlassCamera::Bundle GlassCamera::BundleAt(double x, double y) const
{
    const int column = std::clamp(static_cast<int>(x), 0, mSetting.width - 1);
    const int row = std::clamp(static_cast<int>(y), 0, mSetting.height - 1);
    const double u = x - column, v = y - row;
    const Bundle* upper = &mNodes[static_cast<std::size_t>(row) * (mSetting.width + 1) + column];
    const Bundle* lower = upper + mSetting.width + 1;
    Bundle mixed;
    for (int i = 0; i < 6; ++i)
        mixed.slopes[i] = (1.0 - v) * ((1.0 - u) * upper[0].slopes[i] + u * upper[1].slopes[i]) +
                          v * ((1.0 - u) * lower[0].slopes[i] + u * lower[1].slopes[i]);
    return mixed;
}

std::optional<Ray> GlassCamera::Shoot(Model model, double x, double y, double a, double b) const
{
    if (mNodes.empty())
        return ThinRay(Chief(x, y), a, b);
    // Every model takes the same points of the stop, so that noise does not tell them apart.
    const auto passage = mGlass.Trace(FilmRay(x, y, a, b), model >= Model::Pupil);
    if (!passage)
        return std::nullopt;
    return Through(model, x, y, *passage);
}

Ray GlassCamera::Through(Model model, double x, double y, const Passage& passage) const
{
    const double p = passage.stopX, q = passage.stopY;
    if (model == Model::Thin)
        return ThinRay(Chief(x, y), p, q);
    if (model == Model::Glass)
        return ToWorld(FromLens(passage.out.origin), FromLens(passage.out.direction));
    const Bundle bundle = BundleAt(x, y);
    if (model == Model::Field)
        return FieldRay(bundle, p, q);
    if (model == Model::Pupil)
        return PupilRay(bundle, passage.out);
    const Vector chief = FromLens(bundle.Direction(0.0, 0.0));
    return ThinRay((1.0 / chief.z) * chief, p, q);
}

std::optional<std::array<Ray, kModels>> GlassCamera::ShootAll(double x, double y, double a,
                                                              double b) const
{
    const auto passage = mGlass.Trace(FilmRay(x, y, a, b));
    if (!passage)
        return std::nullopt;
    std::array<Ray, kModels> rays;
    for (int m = 0; m < kModels; ++m)
        rays[m] = Through(static_cast<Model>(m), x, y, *passage);
    return rays;
}

bool GlassCamera::Vignetted(double x, double y, double a, double b) const
{
    const Ray ray = FilmRay(x, y, a, b);
    return mGlass.Trace(ray, false) && !mGlass.Trace(ray);
}

double GlassCamera::Depth(const Vector& point) const
{
    return Dot(point - mLocation, mAxis);
}

std::array<double, 2> GlassCamera::PixelAt(const Ray& ray, double depth) const
{
    const double step = (depth - Depth(ray.origin)) / Dot(ray.direction, mAxis);
    const Vector d = ray.origin + step * ray.direction - mLocation;
    const double scale = mSetting.filmDistance / kFilmWidth * mSetting.width / Dot(d, mAxis);
    return {0.5 * mSetting.width + scale * Dot(d, mRight),
            0.5 * mSetting.height - scale * Dot(d, mUp)};
}

}  // namespace paper
