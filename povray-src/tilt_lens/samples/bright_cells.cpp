// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/bright_cells.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

template<class Visit>
void BrightCells::ForEachNeighbour(std::size_t place, const Visit& visit) const
{
    const std::size_t column = place % columns, row = place / columns;
    for (std::size_t y = row > 0 ? row - 1 : 0; y <= std::min(row + 1, rows - 1); y++)
        for (std::size_t x = column > 0 ? column - 1 : 0; x <= std::min(column + 1, columns - 1); x++)
            if (x != column || y != row)
                visit(y * columns + x);
}

BrightCells::Places BrightCells::ConnectedTo(std::size_t first, std::vector<bool>& seen) const
{
    const double distance = cells[first].distance;
    Places found{first};
    seen[first] = true;
    for (std::size_t i = 0; i < found.size(); i++)
        ForEachNeighbour(found[i], [&](std::size_t next)
        {
            if (seen[next] || !IsBright(next) || !(std::fabs(cells[next].distance - distance) <= 0.1 * distance))
                return;
            seen[next] = true;
            found.push_back(next);
        });
    return found;
}

double BrightCells::RadianceAround(const Places& part) const
{
    double sum = 0.0, count = 0.0;
    for (const std::size_t place : part)
        ForEachNeighbour(place, [&](std::size_t next)
        {
            if (IsBright(next))
                return;
            sum += cells[next].radiance;
            count += 1.0;
        });
    return count > 0.0 ? sum / count : 0.0;
}

BrightShares::BrightShares(const BrightCells& cells) : columns(cells.Columns()), rows(cells.Rows()), sums((columns + 1) * (rows + 1))
{
    for (std::size_t row = 0; row < rows; row++)
    {
        std::uint32_t ofRow = 0;
        for (std::size_t column = 0; column < columns; column++)
        {
            ofRow += cells.IsBright(row * columns + column);
            sums[(row + 1) * (columns + 1) + column + 1] = sums[row * (columns + 1) + column + 1] + ofRow;
        }
    }
}

double BrightShares::operator()(std::size_t place, std::size_t reach) const
{
    const std::size_t column = place % columns, row = place / columns;
    const std::size_t left = column - std::min(column, reach), right = std::min(columns, column + reach + 1);
    const std::size_t top = row - std::min(row, reach), bottom = std::min(rows, row + reach + 1);
    const auto upTo = [this](std::size_t y, std::size_t x) { return double(sums[y * (columns + 1) + x]); };
    const double bright = upTo(bottom, right) - upTo(top, right) - upTo(bottom, left) + upTo(top, left);
    return bright / double((right - left) * (bottom - top));
}

}  // namespace tilt_lens
