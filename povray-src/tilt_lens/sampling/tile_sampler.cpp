// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/tile_sampler.h"

#include <algorithm>
#include <array>

namespace tilt_lens
{

void TileSampler::Run(const Area& wanted, const Tracer& trace)
{
    tile = wanted;
    pixels.assign(tile.Size(), PixelResult());
    std::vector<BlockCache::Place> own, noisy, around;
    for (std::uint32_t y = tile.top - tile.top % settings.blockSide; y < tile.Bottom(); y += settings.blockSide)
        for (std::uint32_t x = tile.left - tile.left % settings.blockSide; x < tile.Right(); x += settings.blockSide)
            own.push_back(BlockCache::PlaceOf(x, y));
    cache.Converge(own, trace);
    for (const BlockCache::Place& place : own)
    {
        const std::shared_ptr<const Block> block = cache.At(place);
        ForEachPixelOf(*block, [&](std::uint32_t x, std::uint32_t y, PixelResult& pixel) { pixel = block->ResultOf(x, y); });
        if (block->NoisyRows(cache.limits).IsEmpty())
            continue;
        noisy.push_back(place);
        for (int i = 0; i < 9; i++)
            around.emplace_back(place.first + i / 3 - 1, place.second + i % 3 - 1);
    }
    cache.Converge(around, trace);
    for (const BlockCache::Place& place : noisy)
        ReconstructBlock(place);
    cache.Release(tile);
}

/// Reconstructs a block that has converged, as have its neighbours.
void TileSampler::ReconstructBlock(const BlockCache::Place& place)
{
    std::array<const BlockStatistics*, 9> statistics{};
    PaddedSpread::Sent spread{};
    std::array<std::shared_ptr<const Block>, 9> around;
    for (int i = 0; i < 9; i++)
        if ((around[i] = cache.At({place.first + i / 3 - 1, place.second + i % 3 - 1})))
        {
            statistics[i] = around[i]->Statistics();
            spread[i] = around[i]->Spread();
        }
    const Block& block = *around[4];
    const Rows rows = block.NoisyRows(cache.limits);
    const std::shared_ptr<const PaddedSpread> received = PaddedSpread::Of(spread, block.FirstSamples());
    const PaddedBlock padded(statistics);
    if (cache.limits.max == 1 && !received)
        return;
    const ReconstructedBlock reconstructed =
        cache.limits.max == 1 ? SpreadEstimates(padded, *received) : Reconstruct(padded, received.get(), rows);
    ForEachPixelOf(block, [&](std::uint32_t x, std::uint32_t y, PixelResult& pixel)
    {
        const int row = y - block.area.top;
        const std::size_t i = row * settings.blockSide + x - block.area.left;
        const Radiance mean = reconstructed.MeanOf(i);
        if (!rows.Has(row) || !IsFinite(mean))  // beside what a float cannot hold
            return;
        pixel.mean = mean;
        pixel.variance = pixel.undetected + reconstructed.residualVarianceRatio[i] * (pixel.variance - pixel.undetected);
        pixel.reconstructed = true;
    });
}

/// Calls with the place and the result of each of the block's pixels that lie in the tile.
template<class Visit>
void TileSampler::ForEachPixelOf(const Block& block, const Visit& visit)
{
    for (std::uint32_t y = block.area.top; y < block.area.Bottom(); y++)
        for (std::uint32_t x = block.area.left; x < block.area.Right(); x++)
            if (tile.Has(x, y))
                visit(x, y, pixels[tile.IndexOf(x, y)]);
}

SamplingStatistics TileSampler::Statistics() const
{
    SamplingStatistics statistics;
    for (const PixelResult& pixel : pixels)
    {
        statistics.pixelsBySamples[pixel.samples]++;
        statistics.variance += pixel.variance;
        statistics.notFinite += pixel.notFinite;
        statistics.emitterSampled += pixel.emitterSamples;
        statistics.reconstructed += pixel.reconstructed;
    }
    return statistics;
}

} // namespace tilt_lens
