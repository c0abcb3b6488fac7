// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file bright_cells.h
/// A sharp picture made of cells, and the parts of it that are brighter than `Settings::searchRadiance`.

#ifndef TILT_LENS_BRIGHT_CELLS_H
#define TILT_LENS_BRIGHT_CELLS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

class BrightCells
{
  public:
    struct Cell
    {
        float radiance = 0.0f;  ///< brightest channel, 1 is white
        float distance = 0.0f;  ///< length of the light path, scene units
        bool known = false;     ///< shows an emitter that the camera has already
    };
    using Places = std::vector<std::size_t>;

    BrightCells() = default;
    BrightCells(std::size_t columns, std::size_t rows) : columns(columns), rows(rows), cells(columns * rows) {}

    std::size_t Columns() const { return columns; }
    std::size_t Rows() const { return rows; }
    std::size_t Count() const { return cells.size(); }
    Cell& operator[](std::size_t place) { return cells[place]; }  ///< row by row
    const Cell& operator[](std::size_t place) const { return cells[place]; }

    bool IsBright(std::size_t place) const { return cells[place].radiance > Settings::searchRadiance; }

    /// Calls `visit(part)` for bright cells side by side, at nearly the same distance.
    template<class Visit>
    void ForEachPart(const Visit& visit) const
    {
        std::vector<bool> seen(cells.size());
        for (std::size_t place = 0; place < cells.size(); place++)
            if (IsBright(place) && !seen[place])
                visit(ConnectedTo(place, seen));
    }

    /// Mean radiance of the dark cells beside a part.
    double RadianceAround(const Places& part) const;

  private:
    std::size_t columns = 0, rows = 0;
    std::vector<Cell> cells;

    template<class Visit>
    void ForEachNeighbour(std::size_t place, const Visit& visit) const;
    Places ConnectedTo(std::size_t first, std::vector<bool>& seen) const;
};

/// The shares of bright cells in squares.
class BrightShares
{
  public:
    explicit BrightShares(const BrightCells& cells);

    /// In the square of 2 `reach` + 1 cells about a place, as far as there are cells.
    double operator()(std::size_t place, std::size_t reach) const;

  private:
    const std::size_t columns, rows;
    std::vector<std::uint32_t> sums;  ///< bright cells above and to the left, by columns + 1
};

}  // namespace tilt_lens

#endif
