// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file frame_table.h
/// Tables of what changes slowly over the frame: as many places in a row as in a column, from the upper left corner to the
/// lower right one, row by row. Between places, values are linear.

#ifndef TILT_LENS_FRAME_TABLE_H
#define TILT_LENS_FRAME_TABLE_H

#include <algorithm>
#include <cstddef>

#include "tilt_lens/camera/film_point.h"

namespace tilt_lens
{

/// Where a film point lies in a table.
struct TablePlace
{
    std::size_t at;      ///< of the four places around it the upper left one
    double right, down;  ///< how far it lies from there towards the next places, 0 to 1
};

/// The film point that a place stands for.
/// @param side  places in a row and in a column
inline FilmPoint FilmPointOfPlace(int side, int row, int column)
{
    return {double(column) / (side - 1) - 0.5, 0.5 - double(row) / (side - 1)};
}

/// Film points beside the frame count as the nearest one within: pretrace looks a little past the frame.
inline TablePlace PlaceOf(int side, const FilmPoint& film)
{
    const int last = side - 2;
    const double x = (film.x + 0.5) * (side - 1), y = (0.5 - film.y) * (side - 1);
    const int column = std::clamp(int(x), 0, last), row = std::clamp(int(y), 0, last);
    return {std::size_t(row) * side + column, std::clamp(x - column, 0.0, 1.0), std::clamp(y - row, 0.0, 1.0)};
}

} // namespace tilt_lens

#endif
