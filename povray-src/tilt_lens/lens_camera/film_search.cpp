// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/film_search.h"

#include <algorithm>

namespace tilt_lens
{

namespace
{

constexpr int kMostSteps = 12;
constexpr double kNearEnough = 1e-5;  ///< last step, in frames: the next would be much shorter
constexpr double kDifference = 1e-4;  ///< for derivatives
constexpr double kLongestStep = 0.2;
constexpr double kSideRadius = 0.7;   ///< pupil points whose film points give the derivatives by the pupil's coordinates
constexpr double kLeastShare = 0.1;   ///< a slope learns only from a step that has this share of the predicted effect

constexpr FilmPoint kNone{NAN, NAN};

double Dot(const FilmPoint& a, const FilmPoint& b)
{
    return a.x * b.x + a.y * b.y;
}

bool IsFinite(const FilmPoint& film)
{
    return std::isfinite(film.x + film.y);
}

} // namespace

FilmSearch::FilmSearch(const GlassCamera& itsCamera, const Vec3& itsTarget) : camera(itsCamera), target(itsTarget)
{
    const Vec3 way = Normalized(target), aside = std::fabs(way.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    across = Normalized(Cross(way, aside));
    along = Cross(way, across);
    const FilmPoint ideal = IdealFilmPointOf(camera.Solved(), target).value_or(FilmPoint{0.0, 0.0});
    FindSlope(ideal);
    FindStart(ideal);
}

FourFilms FilmSearch::FilmsOf(const FourApertures& pupil, double hue, FourFilms films) const
{
    std::array<Slope, 4> slopes{slope, slope, slope, slope};
    FourFilms steps{}, misses{};
    std::array<bool, 4> found{}, waiting;
    std::transform(films.begin(), films.end(), waiting.begin(), [](const FilmPoint& film) { return IsFinite(film); });
    for (int tries = 0; tries < kMostSteps && waiting != std::array<bool, 4>{}; tries++)
    {
        const FourFilms before = misses;
        misses = MissesOf(films, pupil, hue);
        for (int i = 0; i < 4; i++)
        {
            if (!waiting[i])
                continue;
            if (tries > 0)
                slopes[i].Learn(steps[i], {misses[i].x - before[i].x, misses[i].y - before[i].y});
            const FilmPoint step = slopes[i] * misses[i];
            const double length = std::sqrt(Dot(step, step)), shorter = -std::min(1.0, kLongestStep / length);
            found[i] = length < kNearEnough;
            waiting[i] = length >= kNearEnough;  // neither if there is no ray
            if (!waiting[i] && !found[i])
                continue;
            steps[i] = {shorter * step.x, shorter * step.y};
            films[i] = {films[i].x + steps[i].x, films[i].y + steps[i].y};
        }
    }
    for (int i = 0; i < 4; i++)
        films[i] = found[i] ? films[i] : kNone;
    return films;
}

/// Broyden's update of the inverse derivative.
/// @param change  of the miss, by the step
void FilmSearch::Slope::Learn(const FilmPoint& step, const FilmPoint& change)
{
    const FilmPoint predicted = *this * change, back{step.x * x.x + step.y * y.x, step.x * x.y + step.y * y.y};
    const double length = Dot(step, predicted);
    if (!(std::fabs(length) > kLeastShare * Dot(step, step)))
        return;
    const double byX = (step.x - predicted.x) / length, byY = (step.y - predicted.y) / length;
    x = {x.x + byX * back.x, x.y + byX * back.y};
    y = {y.x + byY * back.x, y.y + byY * back.y};
}

/// Through the middle of the pupil, by differences.
void FilmSearch::FindSlope(const FilmPoint& film)
{
    const FourFilms misses = MissesOf({film, {film.x + kDifference, film.y}, {film.x, film.y + kDifference}, film}, {}, 0.0);
    const double xx = misses[1].x - misses[0].x, xy = misses[2].x - misses[0].x;
    const double yx = misses[1].y - misses[0].y, yy = misses[2].y - misses[0].y;
    const double factor = kDifference / (xx * yy - xy * yx);
    slope = {{factor * yy, -factor * xy}, {-factor * yx, factor * xx}};
}

void FilmSearch::FindStart(const FilmPoint& near)
{
    middle = FilmsOf({}, 0.0, {near, near, near, near})[0];
    const FourApertures sides{{{kSideRadius, 0.0}, {-kSideRadius, 0.0}, {0.0, kSideRadius}, {0.0, -kSideRadius}}};
    const FourFilms films = FilmsOf(sides, 0.0, {middle, middle, middle, middle});
    const auto derivative = [](const FilmPoint& high, const FilmPoint& low)
    {
        const FilmPoint by{0.5 / kSideRadius * (high.x - low.x), 0.5 / kSideRadius * (high.y - low.y)};
        return IsFinite(by) ? by : FilmPoint{0.0, 0.0};
    };
    byA = derivative(films[0], films[1]);
    byB = derivative(films[2], films[3]);
}

/// Across the way to the target, scene units; NaN: no ray.
FourFilms FilmSearch::MissesOf(const FourFilms& films, const FourApertures& pupil, double hue) const
{
    FourGlassPoints points{};
    for (int i = 0; i < 4; i++)
    {
        points.u[i] = pupil[i].a, points.v[i] = pupil[i].b;
        if (!IsFinite(films[i]))
            continue;
        points.x[i] = films[i].x, points.y[i] = films[i].y;
        points.wanted |= 1u << i;
    }
    points.aimed = points.wanted;
    FourGlassSamples rays;
    const unsigned int made = camera.Aim(points, hue, rays) & points.wanted;
    FourFilms misses;
    for (int i = 0; i < 4; i++)
        misses[i] = (made >> i & 1u) != 0 ? MissOf(rays.RayOf(i)) : kNone;
    return misses;
}

FilmPoint FilmSearch::MissOf(const LensRay& ray) const
{
    const Vec3 way = target - ray.origin;
    const Vec3 miss = (Dot(way, ray.direction) / Dot(ray.direction, ray.direction)) * ray.direction - way;
    return {Dot(miss, across), Dot(miss, along)};
}

} // namespace tilt_lens
