// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/tile_sampler.h"

namespace tilt_lens
{

void TileSampler::Run(const Area& wanted, const Tracer& trace)
{
    tile = wanted;
    pixels.assign(tile.Size(), PixelResult());
    risk = 0.0;
    std::vector<BlockCache::Place> places;
    for (std::uint32_t y = tile.top - tile.top % Settings::blockSide; y < tile.Bottom(); y += Settings::blockSide)
        for (std::uint32_t x = tile.left - tile.left % Settings::blockSide; x < tile.Right(); x += Settings::blockSide)
            places.push_back(BlockCache::PlaceOf(x, y));
    cache.Finish(places, trace);
    for (const BlockCache::Place& place : places)
        CopyResults(*cache.At(place));
    cache.Release(tile);
}

void TileSampler::CopyResults(const Block& block)
{
    for (std::uint32_t y = block.area.top; y < block.area.Bottom(); y++)
        for (std::uint32_t x = block.area.left; x < block.area.Right(); x++)
            if (tile.Has(x, y))
            {
                const PixelResult& result = pixels[tile.IndexOf(x, y)] = block.ResultOf(x, y);
                risk += block.RiskOverVariance() * result.variance;
            }
}

SamplingStatistics TileSampler::Statistics() const
{
    SamplingStatistics statistics;
    statistics.risk = risk;
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
