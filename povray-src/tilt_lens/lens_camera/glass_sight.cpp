// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_sight.h"

#include <cmath>

#include "tilt_lens/camera/concentric.h"
#include "tilt_lens/lens_camera/film_search.h"

namespace tilt_lens
{

namespace
{

/// Distance of points from the border of their cell, over its side: CellAt() finds each point of PointOf() in its cell.
constexpr double kInside = 1e-9;

/// Film points that see the target through the corners of traced cells, row by row.
class Corners
{
  public:
    Corners(const GlassCamera& camera, const Vec3& target)
    {
        const FilmSearch search(camera, target);
        for (int first = 0; first < kSide * kSide; first += 4)
        {
            FourApertures pupil;
            FourFilms start;
            for (int i = 0; i < 4; i++)
            {
                const int at = first + i;  // the last ones are beyond the last row
                pupil[i] = Aperture::Disc()(double(at % kSide) / GlassSight::kTraced,
                                            std::min(1.0, double(at / kSide) / GlassSight::kTraced));
                start[i] = search.Start(pupil[i]);
            }
            const FourFilms green = search.FilmsOf(pupil, 0.0, start);
            const FourFilms blue = camera.HasColours() ? search.FilmsOf(pupil, -1.0, green) : green;
            const FourFilms red = camera.HasColours() ? search.FilmsOf(pupil, 1.0, green) : green;
            for (int i = 0; i < 4; i++)
                corners.push_back({blue[i], green[i], red[i]});
        }
    }

    /// Interpolated for the corners of all cells, row by row. NaN: none found.
    std::vector<FilmPoint> At(double hue) const
    {
        std::vector<FilmPoint> traced, films;
        for (const std::array<FilmPoint, 3>& corner : corners)
            traced.push_back(Mean(corner, {0.5 * hue * (hue - 1.0), 1.0 - hue * hue, 0.5 * hue * (hue + 1.0)}));
        for (int row = 0; row <= GlassSight::kSide; row++)
            for (int column = 0; column <= GlassSight::kSide; column++)
                films.push_back(Between(traced, column, row));
        return films;
    }

  private:
    static constexpr int kSide = GlassSight::kTraced + 1;

    std::vector<std::array<FilmPoint, 3>> corners;  ///< at the hues -1, 0 and 1

    /// Those of weight 0 may be NaN.
    template<std::size_t kNumber>
    static FilmPoint Mean(const std::array<FilmPoint, kNumber>& films, const std::array<double, kNumber>& weights)
    {
        FilmPoint mean{0.0, 0.0};
        for (std::size_t i = 0; i < kNumber; i++)
            if (weights[i] != 0.0)
                mean = {mean.x + weights[i] * films[i].x, mean.y + weights[i] * films[i].y};
        return mean;
    }

    /// @param column, row  in cells
    static FilmPoint Between(const std::vector<FilmPoint>& traced, int column, int row)
    {
        constexpr int fine = GlassSight::kFine, last = GlassSight::kTraced - 1;
        const int left = std::min(column / fine, last), top = std::min(row / fine, last);
        const double right = double(column - left * fine) / fine, down = double(row - top * fine) / fine;
        const FilmPoint* const first = &traced[top * kSide + left];
        return Mean<4>({first[0], first[1], first[kSide], first[kSide + 1]},
                       {(1.0 - right) * (1.0 - down), right * (1.0 - down), (1.0 - right) * down, right * down});
    }
};

/// Even bits of a number below 1024.
constexpr int EvenBits(int number)
{
    const int pairs = (number & 0x111) | (number & 0x044) >> 1, fours = (pairs & 0x303) | (pairs & 0x030) >> 2;
    return (fours & 0x00f) | (fours & 0x300) >> 4;
}

/// The inverse, with odd bits of 0.
constexpr int Spread(int bits)
{
    const int fours = (bits & 0x00f) | (bits & 0x010) << 4, pairs = (fours & 0x303) | (fours & 0x00c) << 2;
    return (pairs & 0x111) | (pairs & 0x222) << 1;
}

constexpr int ColumnOf(int number)
{
    return EvenBits(number);
}

constexpr int RowOf(int number)
{
    return EvenBits(number >> 1);
}

constexpr int NumberOf(int column, int row)
{
    return Spread(column) | Spread(row) << 1;
}

} // namespace

GlassSight::GlassSight(const GlassCamera& camera, const Vec3& target) : trees(camera.HasColours() ? 3 : 1)
{
    const Corners corners(camera, target);
    std::vector<std::vector<FilmPoint>> films;  // at both ends of each third
    for (const double hue : camera.HasColours() ? std::vector<double>{-1.0, -1.0 / 3.0, 1.0 / 3.0, 1.0} : std::vector<double>{0.0})
        films.push_back(corners.At(hue));
    for (std::size_t third = 0; third < trees.size(); third++)
    {
        Tree& tree = trees[third];
        for (int row = 0; row < kSide; row++)
            for (int column = 0; column < kSide; column++)
            {
                Image& image = tree[kFirstCell + NumberOf(column, row)];
                for (const std::size_t end : {third, std::min(third + 1, films.size() - 1)})
                    for (int i = 0; i < 4; i++)
                        image.Include(films[end][(row + i / 2) * (kSide + 1) + column + i % 2]);
            }
        for (int node = int(tree.size()) - 1; node > 0; node--)
            tree[(node - 1) / 4].Include(tree[node]);
    }
}

FilmBox GlassSight::Box() const
{
    Image all;
    for (const Tree& tree : trees)
        all.Include(tree[0]);
    return {all.left, all.right, all.bottom, all.top};
}

/// Adds cells of a part of the pupil.
/// @param node  the part
void GlassSight::Collect(const FilmBox& box, std::size_t third, int node, Cells& cells) const
{
    if (!trees[third][node].Meets(box))
        return;
    if (node >= kFirstCell)
        return cells.push_back(std::uint16_t(node - kFirstCell));
    for (int quarter = 4 * node + 1; quarter <= 4 * node + 4; quarter++)
        Collect(box, third, quarter, cells);
}

GlassSight::Cells GlassSight::CellsOf(const FilmBox& box, std::size_t third) const
{
    Cells cells;
    Collect(box, third, 0, cells);
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
    return std::uint16_t(NumberOf(place(u), place(v)));
}

} // namespace tilt_lens
