// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tile_sampler.h
/// The pixels of one tile: sampled by its cells (cell.h), rebuilt from them and those around
/// (reconstruction.h).

#ifndef TILT_LENS_TILE_SAMPLER_H
#define TILT_LENS_TILE_SAMPLER_H

#include <cstdint>
#include <vector>

#include "tilt_lens/sampling/cell_store.h"
#include "tilt_lens/sampling/sampling.h"

namespace tilt_lens
{

class TileSampler
{
  public:
    /// @param store  of the picture, shared with its other tiles' samplers
    explicit TileSampler(CellStore& store) : store(store) {}

    /// Samples a tile, which lies inside the picture. No tile may be asked for twice.
    void Run(const Area& tile, const Tracer& trace);

    /// @name Results for a pixel of the tile, after Run.
    /// @{
    Radiance Mean(std::uint32_t x, std::uint32_t y) const { return At(x, y).mean; }
    std::uint32_t Samples(std::uint32_t x, std::uint32_t y) const { return At(x, y).samples; }
    double Variance(std::uint32_t x, std::uint32_t y) const { return At(x, y).variance; }  ///< as Cell::Final has it
    SamplingAccount Account() const;                                                       ///< of the tile
    /// @}

  private:
    CellStore& store;
    Area tile{};
    std::vector<Cell::Final> pixels;

    void RunCell(std::uint32_t left, std::uint32_t top, const Tracer& trace);
    Cell::Final& At(std::uint32_t x, std::uint32_t y) { return pixels[(y - tile.top) * std::size_t(tile.width) + x - tile.left]; }
    const Cell::Final& At(std::uint32_t x, std::uint32_t y) const { return const_cast<TileSampler*>(this)->At(x, y); }
};

} // namespace tilt_lens

#endif
