// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/film_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tilt_lens
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A chief ray's parts along the lens's axis and across it.
struct Split
{
    double along;
    Vec3 across;

    Split(const Lens& lens, const Vec3& chief) : along(Dot(chief, lens.normal)), across(chief - along * lens.normal) {}

    double SquaredTangent() const { return Dot(across, across) / (along * along); }
};

/// r_ideal / r_picture.
double Factor(const Lens& lens, double squaredTangent)
{
    return 1.0 + squaredTangent * (lens.distortion2 + squaredTangent * lens.distortion4);
}

/// Film point of a chief ray that ends where the frame lies; `up` may lean against `right`.
FilmPoint OnFrame(const Lens& lens, const Vec3& chief)
{
    const Vec3 offset = chief - lens.direction;
    const double y = Dot(offset, lens.axisUp) / Dot(lens.up, lens.axisUp);
    return {(Dot(offset, lens.axisRight) - y * Dot(lens.up, lens.axisRight)) / Dot(lens.right, lens.axisRight), y};
}

/// The root r of r (1 + a r^2 + b r^4) = wanted, below the fold; negative where there is none. Newton's steps within a
/// bracket, which is halved where they leave it.
double PictureTangent(double a, double b, double wanted)
{
    const double fold = std::sqrt(FoldOf(a, b));
    const auto value = [=](double r) { return r * (1.0 + r * r * (a + r * r * b)); };
    double low = 0.0, high = std::min(std::max(wanted, 1e-300), fold);
    while (value(high) < wanted)
    {
        if (high == fold || !std::isfinite(high))
            return -1.0;
        low = high;
        high = std::min(2.0 * high, fold);
    }
    double r = 0.5 * (low + high);
    for (int i = 0; i < 100; i++)
    {
        const double error = value(r) - wanted;
        (error > 0.0 ? high : low) = r;
        const double slope = 1.0 + r * r * (3.0 * a + 5.0 * b * r * r);
        double next = r - error / slope;
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (next == r || std::fabs(next - r) <= 1e-16 * r)
            break;
        r = next;
    }
    return r;
}

} // namespace

double FoldOf(double distortion2, double distortion4)
{
    // the least positive root t of 1 + 3 a t + 5 b t^2, the derivative of r (1 + a r^2 + b r^4) by r
    const double a = 3.0 * distortion2, b = 5.0 * distortion4;
    const double root = a * a - 4.0 * b;
    if (root < 0.0)
        return kInfinity;
    const double divisor = -a + std::sqrt(root);  // 2/divisor is the least positive root, or there is none
    return divisor > 0.0 ? 2.0 / divisor : kInfinity;
}

std::optional<FilmPoint> IdealFilmPointOf(const Lens& lens, const Vec3& along)
{
    const double ahead = Dot(along, lens.axis);
    if (!(ahead > 0.0))
        return {};
    return OnFrame(lens, (Dot(lens.direction, lens.axis) / ahead) * along);
}

FilmPoint IdealFilmPoint(const Lens& lens, const FilmPoint& picture, double magnified)
{
    const Vec3 chief = IdealChiefRay(lens, picture);
    const Split split(lens, chief);
    const Vec3 along = chief + (Factor(lens, split.SquaredTangent()) / magnified - 1.0) * split.across;
    return IdealFilmPointOf(lens, along).value_or(FilmPoint{picture.x, picture.y});
}

std::optional<FilmPoint> PictureFilmPoint(const Lens& lens, const FilmPoint& ideal)
{
    if (!lens.distorts)
        return ideal;
    const Split split(lens, IdealChiefRay(lens, ideal));
    const double tangent = std::sqrt(split.SquaredTangent());
    if (!(split.along > 0.0))
        return {};
    if (tangent == 0.0)
        return ideal;
    const double found = PictureTangent(lens.distortion2, lens.distortion4, tangent);
    if (found < 0.0)
        return {};
    return IdealFilmPointOf(lens, split.along * lens.normal + (found / tangent) * split.across);
}

double PictureStretch(const Lens& lens, const FilmPoint& picture)
{
    if (!lens.distorts)
        return 1.0;
    // how the ideal chief ray moves with the picture's point, per length on the frame
    const Vec3 at = IdealChiefRay(lens, picture);
    const double step = 1e-5 * Length(lens.right);
    const auto moved = [&](const Vec3& by) { return IdealChiefRay(lens, IdealFilmPoint(lens, OnFrame(lens, at + by))); };
    const Vec3 right = step * lens.axisRight, up = step * lens.axisUp;
    const Vec3 byX = (moved(right) - moved(-right)) / (2.0 * step), byY = (moved(up) - moved(-up)) / (2.0 * step);
    // the inverse of the least singular value of that map, by the eigenvalues of its square
    const double xx = Dot(byX, byX), yy = Dot(byY, byY), xy = Dot(byX, byY);
    const double least = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
    return 1.0 / std::sqrt(least);
}

} // namespace tilt_lens
