// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_sight.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tilt_lens/camera/concentric.h"

namespace tilt_lens
{

namespace
{

constexpr int kMostSteps = 12;
constexpr double kNearEnough = 1e-4;  ///< last step, in frames: the next would be about its square
constexpr double kDifference = 1e-4;  ///< for derivatives
constexpr double kLongestStep = 0.2;

/// Distance of points from the border of their cell, over its side: CellAt() finds each point of PointOf() in its cell.
constexpr double kInside = 1e-9;

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
        const LensRay ray = rays.RayOf(i);
        const Vec3 &direction = ray.direction, way = target - ray.origin;
        const Vec3 miss = (Dot(way, direction) / Dot(direction, direction)) * direction - way;
        return {Dot(miss, across), Dot(miss, along)};
    }
};

/// Film points that see the target through the corners of traced cells.
class Corners
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
            const AperturePoint pupil = Aperture::Disc()(double(column) / GlassSight::kTraced, double(row) / GlassSight::kTraced);
            const std::optional<FilmPoint> green = search.FilmOf(pupil, 0.0, column == 0 ? ofRow : near);
            near = green.value_or(ideal);
            ofRow = column == 0 ? near : ofRow;
            for (int i = 0; i < 3; i++)
                corners[at][i] = (i == 1 || !camera.HasColours() ? green : search.FilmOf(pupil, i - 1.0, near)).value_or(none);
        }
    }

    /// Interpolated for the corners of all cells, row by row. NaN: none found.
    std::vector<FilmPoint> At(double hue) const
    {
        std::vector<FilmPoint> films;
        for (int row = 0; row <= GlassSight::kSide; row++)
            for (int column = 0; column <= GlassSight::kSide; column++)
                films.push_back(FilmAt(double(column) / GlassSight::kFine, double(row) / GlassSight::kFine, hue));
        return films;
    }

  private:
    static constexpr int kSide = GlassSight::kTraced + 1;
    static constexpr FilmPoint none{NAN, NAN};

    std::vector<std::array<FilmPoint, 3>> corners;  ///< row by row; at the hues -1, 0 and 1

    /// @param x, y  place, in traced cells
    FilmPoint FilmAt(double x, double y, double hue) const
    {
        const int column = std::min(int(x), GlassSight::kTraced - 1), row = std::min(int(y), GlassSight::kTraced - 1);
        const double across = x - column, along = y - row;
        const double weights[] = {(1.0 - across) * (1.0 - along), across * (1.0 - along), (1.0 - across) * along, across * along};
        const double hues[] = {0.5 * hue * (hue - 1.0), 1.0 - hue * hue, 0.5 * hue * (hue + 1.0)};
        FilmPoint film{0.0, 0.0};
        for (int i = 0; i < 4; i++)
            for (int colour = 0; colour < 3; colour++)
                if (const double weight = weights[i] * hues[colour]; weight != 0.0)
                {
                    const FilmPoint& corner = corners[(row + i / 2) * kSide + column + i % 2][colour];
                    film = {film.x + weight * corner.x, film.y + weight * corner.y};
                }
        return film;
    }
};

} // namespace

GlassSight::GlassSight(const GlassCamera& camera, const Vec3& target) : images(camera.HasColours() ? 3 : 1)
{
    const Corners corners(camera, target);
    std::vector<std::vector<FilmPoint>> films;  // at both ends of each third
    for (const double hue : camera.HasColours() ? std::vector<double>{-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0} : std::vector<double>{0.0})
        films.push_back(corners.At(hue));
    for (std::size_t third = 0; third < images.size(); third++)
        for (int cell = 0; cell < kCount; cell++)
        {
            Image& image = images[third].cells[cell];
            for (const std::size_t end : {third, std::min(third + 1, films.size() - 1)})
                for (int i = 0; i < 4; i++)
                    image.Include(films[end][(RowOf(cell) + i / 2) * (kSide + 1) + ColumnOf(cell) + i % 2]);
            images[third].traced[cell / kFines].Include(image);
            all.Include(image);
        }
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
    const auto place = [](int cells, double in) { return (cells + std::clamp(in, kInside, 1.0 - kInside)) / kSide; };
    return Aperture::Disc()(place(ColumnOf(cell), u), place(RowOf(cell), v));
}

std::uint16_t GlassSight::CellAt(const AperturePoint& point)
{
    double u, v;
    FromDisc(point.a, point.b, u, v);
    const auto place = [](double coordinate) { return std::clamp(int(coordinate * kSide), 0, kSide - 1); };
    const int column = place(u), row = place(v);
    const int traced = row / kFine * kTraced + column / kFine, fine = row % kFine * kFine + column % kFine;
    return std::uint16_t(traced * kFines + fine);
}

} // namespace tilt_lens
