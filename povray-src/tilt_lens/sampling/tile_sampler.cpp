// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/tile_sampler.h"

namespace tilt_lens
{

void TileSampler::Run(const Area& wanted, const Tracer& trace)
{
    tile = wanted;
    pixels.assign(std::size_t(tile.width) * tile.height, Cell::Final());
    for (std::uint32_t y = tile.top - tile.top % kCell; y < tile.Bottom(); y += kCell)
        for (std::uint32_t x = tile.left - tile.left % kCell; x < tile.Right(); x += kCell)
            RunCell(x, y, trace);
    store.Forget(tile);
}

void TileSampler::RunCell(std::uint32_t left, std::uint32_t top, const Tracer& trace)
{
    const std::shared_ptr<const Cell> held = store.Finished(left, top, trace);
    const Cell& cell = *held;
    const auto forEach = [&](const auto& visit)
    {
        for (std::uint32_t y = cell.area.top; y < cell.area.Bottom(); y++)
            for (std::uint32_t x = cell.area.left; x < cell.area.Right(); x++)
                if (tile.Has(x, y))
                    visit(x, y, At(x, y));
    };
    forEach([&](std::uint32_t x, std::uint32_t y, Cell::Final& pixel) { pixel = cell.FinalOf(x, y); });
    const Rows rows = cell.NoisyRows(store.limits);
    if (rows.IsEmpty())
        return;
    const CellStore::Block block = store.FinishedAround(left, top, trace);
    Cell::Neighbours cells;
    for (std::size_t i = 0; i < block.size(); i++)
        cells[i] = block[i].get();
    const Rebuilt rebuilt = Rebuild(Cell::SurroundingsOf(cells), rows);
    forEach([&](std::uint32_t x, std::uint32_t y, Cell::Final& pixel)
    {
        const int row = y - cell.area.top;
        const std::size_t i = row * kCell + x - cell.area.left;
        const Radiance mean = rebuilt.MeanOf(i);
        if (!rows.Has(row) || !IsLight(mean))  // no light beside what a float cannot hold
            return;
        pixel.mean = mean;
        pixel.variance *= rebuilt.remains[i];
        pixel.rebuilt = true;
    });
}

SamplingAccount TileSampler::Account() const
{
    SamplingAccount account;
    for (const Cell::Final& pixel : pixels)
    {
        account.pixelsBySamples[pixel.samples]++;
        account.variance += pixel.variance;
        account.notFinite += pixel.notFinite;
        account.aimed += pixel.aimed;
        account.rebuilt += pixel.rebuilt;
    }
    return account;
}

} // namespace tilt_lens
