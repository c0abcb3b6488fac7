// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "double_gauss_camera.h"

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

/// Steps of the frame's width and height between fitted places.
const int kPlaces = 24;

/// Beyond the paraxial pupil: the stop decides.
const double kAim = 1.15;

Vector AtLensPlane(const Ray& ray)
{
    return ray.origin - (ray.origin.z / ray.direction.z) * ray.direction;
}

/// Least squares z = p0 + p1 x + p2 y, by Cramer's rule.
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
    return {Dot(right, Cross(b, c)) / whole, Dot(a, Cross(right, c)) / whole, Dot(a, Cross(b, right)) / whole};
}

} // namespace

GlassCamera::GlassCamera(const Setting& setting, bool thinOnly) :
    mSetting(setting), mGlass(setting.focalLength, setting.fStop, setting.moved)
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
    return {kFilmWidth / s * (x / mSetting.width - 0.5), height / s * (0.5 - y / mSetting.height), 1.0};
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

/// From film to exit pupil; lens frame.
Ray GlassCamera::FilmRay(double x, double y, double a, double b) const
{
    const Vector film = ToLens(-mSetting.filmDistance * Chief(x, y)) - Vector{0.0, 0.0, mGlass.Separation()};
    const double radius = kAim * mGlass.PupilRadius();
    const Vector direction = Unit(Vector{radius * a, radius * b, mGlass.ExitPupil()} - film);
    return {film, direction.z < 0.0 ? -1.0 * direction : direction};
}

/// Toward the film point's image, 1/u + 1/v = 1/f.
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
    return {slopes[0] + slopes[1] * x + slopes[2] * y, slopes[3] + slopes[4] * x + slopes[5] * y, 1.0};
}

Ray GlassCamera::FieldRay(const Bundle& bundle, double a, double b) const
{
    const double radius = 0.5 * mSetting.focalLength / mSetting.fStop;
    return ToWorld(FromLens({radius * a, radius * b, 0.0}), FromLens(bundle.Direction(radius * a, radius * b)));
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
            const auto passage = mGlass.Trace(FilmRay(x, y, radius * std::cos(angle), radius * std::sin(angle)), false);
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
    // the same stop points for every model: noise cancels
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

std::optional<std::array<Ray, kModels>> GlassCamera::ShootAll(double x, double y, double a, double b) const
{
    const auto passage = mGlass.Trace(FilmRay(x, y, a, b));
    if (!passage)
        return std::nullopt;
    std::array<Ray, kModels> rays;
    for (int m = 0; m < kModels; ++m)
        rays[m] = Through(static_cast<Model>(m), x, y, *passage);
    return rays;
}

std::optional<Ray> GlassCamera::ShootCharacter(const Character& character, double x, double y, double a, double b) const
{
    const auto passage = mGlass.Trace(FilmRay(x, y, a, b));
    if (!passage)
        return std::nullopt;
    const double half = 0.5 * kFilmWidth, radius = 0.5 * mSetting.focalLength / mSetting.fStop, f = mSetting.focalLength;
    const Vector ideal = ToLens(Chief(x, y));
    const double r = std::hypot(ideal.x, ideal.y) / ideal.z * mSetting.filmDistance / half;
    const double third = character.distortion1 + character.distortionNear * Nearness(Chief(x, y));
    const double factor = (1.0 + third * r * r + character.distortion2 * std::pow(r, 4)) / ideal.z;
    const Vector chief{factor * ideal.x, factor * ideal.y, 1.0}, point{radius * passage->stopX, radius * passage->stopY, 0.0};
    const double image = mSetting.filmDistance / FromLens(chief).z;
    const double w = (image - f) / (f * image) + character.fieldCurvature / (half * half) * (chief.x * chief.x + chief.y * chief.y);
    return ToWorld(FromLens(point), FromLens(chief - w * point));
}

bool GlassCamera::Vignetted(double x, double y, double a, double b) const
{
    const Ray ray = FilmRay(x, y, a, b);
    return mGlass.Trace(ray, false) && !mGlass.Trace(ray);
}

namespace
{

/// Normal equations, up to three terms; redundant ones get 0.
class LeastSquares
{
  public:
    void Add(const std::array<double, 3>& terms, double value)
    {
        for (int i = 0; i < 3; ++i)
        {
            mRight[i] += terms[i] * value;
            for (int j = 0; j < 3; ++j)
                mMatrix[i][j] += terms[i] * terms[j];
        }
    }

    /// Gauss: a vanishing pivot is a combination of earlier terms.
    std::array<double, 3> Solve() const
    {
        auto a = mMatrix;
        auto b = mRight;
        std::array<bool, 3> used{};
        for (int i = 0; i < 3; ++i)
        {
            used[i] = a[i][i] > 1e-9 * mMatrix[i][i];
            for (int j = i + 1; used[i] && j < 3; ++j)
            {
                const double factor = a[j][i] / a[i][i];
                for (int k = i; k < 3; ++k)
                    a[j][k] -= factor * a[i][k];
                b[j] -= factor * b[i];
            }
        }
        std::array<double, 3> found{};
        for (int i = 2; i >= 0; --i)
        {
            for (int k = i + 1; k < 3; ++k)
                b[i] -= a[i][k] * found[k];
            found[i] = used[i] ? b[i] / a[i][i] : 0.0;
        }
        return found;
    }

  private:
    std::array<std::array<double, 3>, 3> mMatrix{};
    std::array<double, 3> mRight{};
};

} // namespace

double GlassCamera::Nearness(const Vector& chief) const
{
    return 1.0 - mSetting.focalLength / (mSetting.filmDistance * Dot(chief, mLensAxis));
}

/// u (1 + (d2 + n m) u^2 + d4 u^4) for the ideal ray's tangent u, m being Nearness().
GlassCamera::Distortion GlassCamera::FittedDistortion(bool near) const
{
    LeastSquares bend;
    std::vector<std::array<double, 4>> places;
    for (int i = 0; i <= kPlaces; ++i)
        for (int j = 0; j <= kPlaces; ++j)
        {
            const double x = static_cast<double>(mSetting.width) * i / kPlaces, y = static_cast<double>(mSetting.height) * j / kPlaces;
            const Bundle bundle = BundleAt(x, y);
            const Vector chief = ToLens(Chief(x, y));
            const double u = std::hypot(chief.x, chief.y) / chief.z, seen = std::hypot(bundle.slopes[0], bundle.slopes[3]);
            const double third = std::pow(u, 3);
            places.push_back({third, std::pow(u, 5), near ? Nearness(Chief(x, y)) * third : 0.0, seen - u});
            bend.Add({places.back()[0], places.back()[1], places.back()[2]}, seen - u);
        }
    Distortion found{bend.Solve(), 0.0};
    for (const auto& place : places)
        found.left += std::pow(place[3] - found.factors[0] * place[0] - found.factors[1] * place[1] - found.factors[2] * place[2], 2);
    found.left = std::sqrt(found.left / static_cast<double>(places.size())) * mSetting.filmDistance / kFilmWidth * mSetting.width;
    return found;
}

/// Slopes fall by w, the inverse focus distance, per mm across the lens; field curvature adds c u^2 to w.
Character GlassCamera::Fitted() const
{
    double bent = 0.0, most = 0.0;
    for (int i = 0; i <= kPlaces; ++i)
        for (int j = 0; j <= kPlaces; ++j)
        {
            const Bundle bundle = BundleAt(static_cast<double>(mSetting.width) * i / kPlaces,
                                           static_cast<double>(mSetting.height) * j / kPlaces);
            const double seen = std::hypot(bundle.slopes[0], bundle.slopes[3]);
            const double image = mSetting.filmDistance / FromLens(bundle.Direction(0.0, 0.0)).z;
            const double w = -0.5 * (bundle.slopes[1] + bundle.slopes[5]), f = mSetting.focalLength;
            bent += seen * seen * (w - (image - f) / (f * image));
            most += std::pow(seen, 4);
        }
    const double half = 0.5 * kFilmWidth, unit = half / mSetting.filmDistance;
    const Distortion bend = FittedDistortion(true);
    return {bend.factors[0] * unit * unit,
            bend.factors[1] * std::pow(unit, 4),
            bend.factors[2] * unit * unit,
            bent / most * half * half,
            bend.left,
            FittedDistortion(false).left};
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
    return {0.5 * mSetting.width + scale * Dot(d, mRight), 0.5 * mSetting.height - scale * Dot(d, mUp)};
}

} // namespace paper
