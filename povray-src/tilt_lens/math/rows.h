// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file rows.h
/// Some rows of a rectangle of pixels.

#ifndef TILT_LENS_ROWS_H
#define TILT_LENS_ROWS_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tilt_lens
{

/// Rows, or columns: begin <= row < end.
struct Rows
{
    int begin, end;

    int Count() const { return end - begin; }
    bool IsEmpty() const { return begin >= end; }
    bool Has(int row) const { return row >= begin && row < end; }
    /// @param height  of the rectangle
    Rows Grown(int margin, int height) const { return {std::max(0, begin - margin), std::min(height, end + margin)}; }

    /// The fewest that have all of these pixels.
    /// @param pixels  ascending indices, row by row
    static Rows Of(const std::vector<std::size_t>& pixels, std::size_t width)
    {
        return pixels.empty() ? Rows{0, 0} : Rows{int(pixels.front() / width), int(pixels.back() / width) + 1};
    }
};

} // namespace tilt_lens

#endif
