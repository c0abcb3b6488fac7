// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tile_sampler.h
/// Samples one tile's pixels by way of their blocks (block.h).

#ifndef TILT_LENS_TILE_SAMPLER_H
#define TILT_LENS_TILE_SAMPLER_H

#include <cstdint>
#include <vector>

#include "tilt_lens/stop_rule/block_cache.h"
#include "tilt_lens/stop_rule/sampling_statistics.h"

namespace tilt_lens
{

class TileSampler
{
  public:
    explicit TileSampler(BlockCache& cache) : cache(cache) {}

    /// Samples a tile inside the picture; once per tile.
    void Run(const Area& tile, const Tracer& trace);

    /// @name Valid after Run, for pixels of the tile.
    /// @{
    Radiance Mean(std::uint32_t x, std::uint32_t y) const
    {
        const auto& mean = At(x, y).mean;
        return {mean[0], mean[1], mean[2], mean[3], mean[4]};
    }
    std::uint32_t Samples(std::uint32_t x, std::uint32_t y) const { return At(x, y).samples; }
    double Variance(std::uint32_t x, std::uint32_t y) const { return At(x, y).variance; }  ///< as in PixelResult
    SamplingStatistics Statistics() const;
    /// @}

  private:
    BlockCache& cache;
    Area tile{};
    std::vector<PixelResult> pixels;
    double risk = 0.0;  ///< sum over the pixels, as in SamplingStatistics

    void CopyResults(const Block& block);
    const PixelResult& At(std::uint32_t x, std::uint32_t y) const { return pixels[tile.IndexOf(x, y)]; }
};

} // namespace tilt_lens

#endif
