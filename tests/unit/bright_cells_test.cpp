// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/bright_cells.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace tilt_lens
{
namespace
{

/// '#' is bright at distance 1, '*' at distance 2, '.' has radiance 1, ' ' none.
BrightCells CellsOf(const std::vector<std::string>& rows)
{
    BrightCells cells(rows[0].size(), rows.size());
    for (std::size_t place = 0; place < cells.Count(); place++)
    {
        const char look = rows[place / cells.Columns()][place % cells.Columns()];
        cells[place].radiance = look == '#' || look == '*' ? 2.0f * float(Settings::searchRadiance) : look == '.' ? 1.0f : 0.0f;
        cells[place].distance = look == '*' ? 2.0f : 1.0f;
    }
    return cells;
}

std::vector<BrightCells::Places> PartsOf(const BrightCells& cells)
{
    std::vector<BrightCells::Places> parts;
    cells.ForEachPart([&](const BrightCells::Places& part) { parts.push_back(part); });
    return parts;
}

TEST(BrightCells, PartsTouchByCornersAtOneDistance)
{
    const auto parts = PartsOf(CellsOf({
        "#   *",
        " # #*",
        "  #  ",
        "#    ",
        " ## #",
    }));
    ASSERT_EQ(parts.size(), 4u);
    EXPECT_EQ(parts[0], (BrightCells::Places{0, 6, 12, 8}));
    EXPECT_EQ(parts[1], (BrightCells::Places{4, 9}));
    EXPECT_EQ(parts[2], (BrightCells::Places{15, 21, 22}));
    EXPECT_EQ(parts[3], (BrightCells::Places{24}));
}

TEST(BrightCells, RadianceAroundIsThatOfDarkCells)
{
    const BrightCells cells = CellsOf({
        "....",
        ".#* ",
        "....",
    });
    EXPECT_DOUBLE_EQ(cells.RadianceAround({5}), 1.0);
    EXPECT_DOUBLE_EQ(cells.RadianceAround({6}), 6.0 / 7.0);
    EXPECT_EQ(CellsOf({"#"}).RadianceAround({0}), 0.0);
}

TEST(BrightShares, CountSquaresAsFarAsThereAreCells)
{
    const BrightCells cells = CellsOf({
        "#  # ",
        "  ** ",
        "     ",
        "    #",
    });
    const BrightShares shares(cells);
    for (std::size_t place = 0; place < cells.Count(); place++)
        for (std::size_t reach = 0; reach < 7; reach++)
        {
            double bright = 0.0, all = 0.0;
            for (std::size_t other = 0; other < cells.Count(); other++)
            {
                const auto away = [](std::size_t a, std::size_t b) { return a > b ? a - b : b - a; };
                if (away(place % 5, other % 5) > reach || away(place / 5, other / 5) > reach)
                    continue;
                bright += cells.IsBright(other);
                all++;
            }
            EXPECT_DOUBLE_EQ(shares(place, reach), bright / all) << place << " " << reach;
        }
}

} // namespace
} // namespace tilt_lens
