// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file frame_table.h
/// Square tables over the frame: row by row from the upper left corner, bilinear in between.

#ifndef TILT_LENS_FRAME_TABLE_H
#define TILT_LENS_FRAME_TABLE_H

#include <cstddef>

#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

struct TablePlace
{
    std::size_t at;
    double right, down;
};

inline FilmPoint FilmPointOfPlace(int side, int row, int column)
{
    return {double(column) / (side - 1) - 0.5, 0.5 - double(row) / (side - 1)};
}

/// Clamped to the frame, since radiosity's pretrace leaves it.
TILT_LENS_INLINED TablePlace PlaceOf(int side, const FilmPoint& film)
{
    const int last = side - 2;
    const double x = (film.x + 0.5) * (side - 1), y = (0.5 - film.y) * (side - 1);
    const int column = Clamp(int(x), 0, last), row = Clamp(int(y), 0, last);
    return {std::size_t(row) * side + column, Clamp(x - column, 0.0, 1.0), Clamp(y - row, 0.0, 1.0)};
}

} // namespace tilt_lens

#endif
