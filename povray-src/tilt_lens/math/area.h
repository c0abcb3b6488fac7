// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file area.h
/// Rectangles of pixels.
///
/// The folder math/ knows neither lens nor film.

#ifndef TILT_LENS_AREA_H
#define TILT_LENS_AREA_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

/// (0, 0) is the whole picture's upper left corner.
struct Area
{
    std::uint32_t left, top, width, height;

    std::uint32_t Right() const { return left + width; }
    std::uint32_t Bottom() const { return top + height; }
    std::size_t Size() const { return std::size_t(width) * height; }
    bool Has(std::uint32_t x, std::uint32_t y) const { return x >= left && x < Right() && y >= top && y < Bottom(); }
    std::size_t IndexOf(std::uint32_t x, std::uint32_t y) const { return (y - top) * std::size_t(width) + (x - left); }
};

} // namespace tilt_lens

#endif
