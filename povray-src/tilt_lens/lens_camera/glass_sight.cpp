// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tilt_lens
{

namespace
{

constexpr double kPi = 3.14159265358979323846;

constexpr int kMostSteps = 12;
constexpr double kNearEnough = 1e-4;  ///< last step, in frames: the next would be about its square
constexpr double kDifference = 1e-4;  ///< for derivatives
constexpr double kLongestStep = 0.2;

/// Part of a cell's side; CellAt() finds each point of PointOf() in its cell.
constexpr double kRounding = 1e-9;

/// Film points whose rays meet a point of the scene.
class Search
{
  public:
    Search(const GlassCamera& itsCamera, const Vec3& itsTarget) : camera(itsCamera), target(itsTarget)
    {
        const Vec3 way = Normalized(target), aside = std::fabs(way.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
        across = Normalized(Cross(way, aside));
        along = Cross(way, across);
    }

    /// By Newton's method.
    /// @param pupil  point of the pupil, as in FourGlassSamples
    /// @param near   to start with
    std::optional<FilmPoint> FilmOf(const AperturePoint& pupil, double hue, const FilmPoint& near) const
    {
        FilmPoint film = near;
        for (int i = 0; i < kMostSteps; i++)
        {
            const std::optional<FilmPoint> step = StepFrom(film, pupil, hue);
            if (!step)
                return {};
            const double length = std::hypot(step->x, step->y), shorter = std::min(1.0, kLongestStep / length);
            film = {film.x + shorter * step->x, film.y + shorter * step->y};
            if (length < kNearEnough)
                return film;
        }
        return {};
    }

  private:
    const GlassCamera& camera;
    const Vec3 target;
    Vec3 across, along;

    std::optional<FilmPoint> StepFrom(const FilmPoint& film, const AperturePoint& pupil, double hue) const
    {
        FourGlassPoints points{};
        points.wanted = points.aimed = 0xf;
        for (int i = 0; i < 4; i++)
        {
            points.x[i] = film.x + (i == 1 ? kDifference : 0.0), points.y[i] = film.y + (i == 2 ? kDifference : 0.0);
            points.u[i] = pupil.a, points.v[i] = pupil.b;
        }
        FourGlassSamples rays;
        if (camera.Aim(points, hue, rays) != points.wanted)
            return {};
        const FilmPoint miss = MissOf(rays, 0), right = MissOf(rays, 1), up = MissOf(rays, 2);
        const double xx = right.x - miss.x, xy = up.x - miss.x, yx = right.y - miss.y, yy = up.y - miss.y;
        const double factor = -kDifference / (xx * yy - xy * yx);
        const FilmPoint step{factor * (yy * miss.x - xy * miss.y), factor * (xx * miss.y - yx * miss.x)};
        return std::isfinite(step.x + step.y) ? std::optional<FilmPoint>(step) : std::nullopt;
    }

    /// Across the way to the target, scene units.
    FilmPoint MissOf(const FourGlassSamples& rays, int i) const
    {
        const Vec3 origin{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
        const Vec3 direction{rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]}, way = target - origin;
        const Vec3 miss = (Dot(way, direction) / Dot(direction, direction)) * direction - way;
        return {Dot(miss, across), Dot(miss, along)};
    }
};

} // namespace

/// Film points that see the target through the corners of traced cells, at the hues -1, 0 and 1. NaN: none found.
class GlassSight::Corners
{
  public:
    Corners(const GlassCamera& camera, const Vec3& target) : corners(kSide * kSide)
    {
        const Search search(camera, target);
        const FilmPoint ideal = IdealFilmPointOf(camera.Solved(), target).value_or(FilmPoint{0.0, 0.0});
        FilmPoint ofRow = ideal, near = ideal;
        for (int at = 0; at < kSide * kSide; at++)
        {
            const int column = at % kSide, row = at / kSide;
            const AperturePoint pupil = Aperture::Disc()(double(column) / kTraced, double(row) / kTraced);
            const std::optional<FilmPoint> green = search.FilmOf(pupil, 0.0, column == 0 ? ofRow : near);
            near = green.value_or(ideal);
            ofRow = column == 0 ? near : ofRow;
            for (int i = 0; i < 3; i++)
                corners[at][i] = (i == 1 || !camera.HasColours() ? green : search.FilmOf(pupil, i - 1.0, near)).value_or(none);
        }
    }

    /// Of a part of a traced cell.
    /// @param left, bottom, side  the part; the cell's own side is 1
    /// @param low, high           hues
    Image ImageOf(int traced, double left, double bottom, double side, double low, double high) const
    {
        FilmBox box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
        for (int i = 0; i < 4; i++)
            for (const double hue : {low, high})
            {
                const FilmPoint film = FilmAt(traced, left + i % 2 * side, bottom + i / 2 * side, hue);
                box = {std::min(box.left, film.x), std::max(box.right, film.x), std::min(box.bottom, film.y), std::max(box.top, film.y)};
            }
        return {float(box.left), float(box.right), float(box.bottom), float(box.top)};
    }

  private:
    static constexpr int kSide = kTraced + 1;
    static constexpr FilmPoint none{NAN, NAN};

    std::vector<std::array<FilmPoint, 3>> corners;  ///< row by row

    /// Interpolated; across and along the cell from 0 to 1.
    FilmPoint FilmAt(int traced, double across, double along, double hue) const
    {
        const auto* const first = &corners[traced / kTraced * kSide + traced % kTraced];
        const double hues[] = {0.5 * hue * (hue - 1.0), 1.0 - hue * hue, 0.5 * hue * (hue + 1.0)};
        const double weights[] = {(1.0 - across) * (1.0 - along), across * (1.0 - along), (1.0 - across) * along, across * along};
        FilmPoint film{0.0, 0.0};
        for (int i = 0; i < 4; i++)
            for (int colour = 0; colour < 3; colour++)
            {
                const FilmPoint& corner = first[i / 2 * kSide + i % 2][colour];
                const double weight = weights[i] * hues[colour];
                film = {film.x + weight * corner.x, film.y + weight * corner.y};
            }
        return film;
    }
};

GlassSight::GlassSight(const GlassCamera& camera, const Vec3& target) : images(camera.HasColours() ? 3 : 1)
{
    constexpr double side = 1.0 / kFine;
    const Corners corners(camera, target);
    for (std::size_t third = 0; third < images.size(); third++)
    {
        const double width = 2.0 / images.size(), low = images.size() == 1 ? 0.0 : third * width - 1.0;
        const double high = images.size() == 1 ? 0.0 : low + width;
        for (int traced = 0; traced < kTracedCount; traced++)
            images[third].traced[traced] = corners.ImageOf(traced, 0.0, 0.0, 1.0, low, high);
        for (int cell = 0; cell < kCount; cell++)
        {
            const int fine = cell % kFines;
            images[third].cells[cell] = corners.ImageOf(cell / kFines, fine % kFine * side, fine / kFine * side, side, low, high);
        }
    }
}

FilmBox GlassSight::Box() const
{
    FilmBox box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    for (const Images& third : images)
        for (const Image& image : third.traced)
            box = {std::min(box.left, double(image.left)), std::max(box.right, double(image.right)),
                   std::min(box.bottom, double(image.bottom)), std::max(box.top, double(image.top))};
    return box;
}

GlassSight::Cells GlassSight::CellsOf(const FilmBox& box, std::size_t third) const
{
    Cells cells;
    for (int traced = 0; traced < kTracedCount; traced++)
    {
        if (!images[third].traced[traced].Meets(box))
            continue;
        for (int cell = traced * kFines; cell < (traced + 1) * kFines; cell++)
            if (Shows(std::uint16_t(cell), box, third))
                cells.push_back(std::uint16_t(cell));
    }
    return cells;
}

AperturePoint GlassSight::PointOf(std::uint16_t cell, double u, double v)
{
    const int traced = cell / kFines, fine = cell % kFines;
    const auto place = [](int cells, int part, double in)
    { return (cells + (part + std::clamp(in, kRounding, 1.0 - kRounding)) / kFine) / kTraced; };
    return Aperture::Disc()(place(traced % kTraced, fine % kFine, u), place(traced / kTraced, fine / kFine, v));
}

/// Inverse of Aperture::Disc().
std::uint16_t GlassSight::CellAt(const AperturePoint& point)
{
    constexpr int side = kTraced * kFine;
    const bool sideways = std::fabs(point.a) > std::fabs(point.b);
    const double main = sideways ? point.a : point.b, other = sideways ? point.b : point.a;
    const double radius = std::copysign(std::hypot(main, other), main);
    const double across = main != 0.0 ? 4.0 / kPi * std::atan(other / main) * radius : 0.0;
    const auto place = [](double coordinate) { return std::clamp(int(0.5 * (coordinate + 1.0) * side), 0, side - 1); };
    const int column = place(sideways ? radius : across), row = place(sideways ? across : radius);
    const int traced = row / kFine * kTraced + column / kFine, fine = row % kFine * kFine + column % kFine;
    return std::uint16_t(traced * kFines + fine);
}

} // namespace tilt_lens
