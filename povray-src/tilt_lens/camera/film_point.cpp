// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/film_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tilt_lens
{

namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr double kFarthestTangent = 1e6;

struct Split
{
    double along;
    Vec3 across;

    Split(const Lens& lens, const Vec3& chief) : along(Dot(chief, lens.normal)), across(chief - along * lens.normal) {}

    double SquaredTangent() const { return Dot(across, across) / (along * along); }
};

double Factor(const Lens& lens, const Vec3& chief, const Split& split)
{
    const double squaredTangent = split.SquaredTangent(), nearness = Dot(lens.focus, chief) / split.along;
    return 1.0 + squaredTangent * (lens.distortion2 + lens.distortionNear * nearness + squaredTangent * lens.distortion4);
}

/// The distortion polynomial along one direction.
struct Bend
{
    double square, cube, fourth;

    /// @param across  unit vector across the axis
    Bend(const Lens& lens, const Vec3& across) :
        square(lens.distortion2 + lens.distortionNear * Dot(lens.focus, lens.normal)),
        cube(lens.distortionNear * Dot(lens.focus, across)),
        fourth(lens.distortion4)
    {
    }

    double Ideal(double r) const { return r * (1.0 + r * r * (square + r * cube + r * r * fourth)); }
    double Slope(double r) const { return 1.0 + r * r * (3.0 * square + 4.0 * r * cube + 5.0 * fourth * r * r); }
};

/// `up` may lean to `right`.
FilmPoint OnFrame(const Lens& lens, const Vec3& chief)
{
    const Vec3 offset = chief - lens.direction;
    const double y = Dot(offset, lens.axisUp) / Dot(lens.up, lens.axisUp);
    return {(Dot(offset, lens.axisRight) - y * Dot(lens.up, lens.axisRight)) / Dot(lens.right, lens.axisRight), y};
}

/// Solves Ideal(r) = wanted below the fold, by Newton's method within a bracket. Negative: no solution.
double PictureTangent(const Bend& bend, double wanted)
{
    const double fold = std::sqrt(FoldOf(bend.square, bend.fourth, bend.cube));
    double low = 0.0, high = std::min(std::max(wanted, 1e-300), fold);
    while (bend.Ideal(high) < wanted)
    {
        if (high == fold || !std::isfinite(high))
            return -1.0;
        low = high;
        high = std::min(2.0 * high, fold);
    }
    double r = 0.5 * (low + high);
    for (int i = 0; i < 100; i++)
    {
        const double error = bend.Ideal(r) - wanted;
        (error > 0.0 ? high : low) = r;
        double next = r - error / bend.Slope(r);
        if (!(next > low && next < high))
            next = 0.5 * (low + high);
        if (next == r || std::fabs(next - r) <= 1e-16 * r)
            break;
        r = next;
    }
    return r;
}

template<typename Function>
double Bisect(const Function& function, double low, double high)
{
    for (double middle = 0.5 * (low + high); middle > low && middle < high; middle = 0.5 * (low + high))
        (function(middle) > 0.0 ? low : high) = middle;
    return low;
}

/// Least positive root of 1 + 3 a r^2 + 4 c r^3 + 5 b r^4, monotone between its turning points.
double LeastRoot(double a, double c, double b)
{
    const auto slope = [=](double r) { return 1.0 + r * r * (3.0 * a + r * (4.0 * c + 5.0 * b * r)); };
    // turning points: 3 a + 6 c r + 10 b r^2 = 0
    const double root = 9.0 * c * c - 30.0 * a * b, q = -(3.0 * c + std::copysign(std::sqrt(std::max(root, 0.0)), c));
    double first = q / (10.0 * b), second = 3.0 * a / q;
    if (first > second)
        std::swap(first, second);
    double low = 0.0;
    for (const double turn : {first, second, kFarthestTangent})
    {
        if (!(turn > low && turn <= kFarthestTangent) || (root < 0.0 && turn != kFarthestTangent))
            continue;
        if (!(slope(turn) > 0.0))
            return Bisect(slope, low, turn);
        low = turn;
    }
    return kInfinity;
}

} // namespace

double FoldOf(double distortion2, double distortion4, double cube)
{
    if (cube != 0.0)
    {
        const double least = LeastRoot(distortion2, cube, distortion4);
        return least * least;
    }
    // least positive root t of 1 + 3 a t + 5 b t^2
    const double a = 3.0 * distortion2, b = 5.0 * distortion4;
    const double root = a * a - 4.0 * b;
    if (root < 0.0)
        return kInfinity;
    const double divisor = -a + std::sqrt(root);
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
    const Vec3 along = chief + (Factor(lens, chief, split) / magnified - 1.0) * split.across;
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
    const double found = PictureTangent(Bend(lens, Normalized(split.across)), tangent);
    if (found < 0.0)
        return {};
    return IdealFilmPointOf(lens, split.along * lens.normal + (found / tangent) * split.across);
}

double PictureStretch(const Lens& lens, const FilmPoint& picture)
{
    if (!lens.distorts)
        return 1.0;
    const Vec3 at = IdealChiefRay(lens, picture);
    const double step = 1e-5 * Length(lens.right);
    const auto moved = [&](const Vec3& by) { return IdealChiefRay(lens, IdealFilmPoint(lens, OnFrame(lens, at + by))); };
    const Vec3 right = step * lens.axisRight, up = step * lens.axisUp;
    const Vec3 byX = (moved(right) - moved(-right)) / (2.0 * step), byY = (moved(up) - moved(-up)) / (2.0 * step);
    // inverse of the derivative's least singular value, from the eigenvalues of its square
    const double xx = Dot(byX, byX), yy = Dot(byY, byY), xy = Dot(byX, byY);
    const double least = 0.5 * (xx + yy) - std::hypot(0.5 * (xx - yy), xy);
    return 1.0 / std::sqrt(least);
}

} // namespace tilt_lens
