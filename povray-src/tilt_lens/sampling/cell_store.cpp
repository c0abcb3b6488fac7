// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/cell_store.h"

#include <algorithm>

namespace tilt_lens
{

namespace
{

/// A pixel's value looks at the finished cells beside its own, these at the first samples of theirs.
constexpr std::int64_t kReach = 2;

std::uint32_t Overlap(std::uint32_t beginA, std::uint32_t endA, std::uint32_t beginB, std::uint32_t endB)
{
    const std::uint32_t begin = std::max(beginA, beginB), end = std::min(endA, endB);
    return begin < end ? end - begin : 0;
}

std::uint32_t Overlap(const Area& a, const Area& b)
{
    return Overlap(a.left, a.Right(), b.left, b.Right()) * Overlap(a.top, a.Bottom(), b.top, b.Bottom());
}

Area CellsOf(const Area& pixels)
{
    const std::uint32_t left = pixels.left / kCell, top = pixels.top / kCell;
    return {left, top, (pixels.Right() + kCell - 1) / kCell - left, (pixels.Bottom() + kCell - 1) / kCell - top};
}

} // namespace

CellStore::CellStore(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered) :
    limits(limits), width(width), height(height), cells(CellsOf(rendered)), toCome(std::size_t(cells.width) * cells.height)
{
    for (std::uint32_t row = cells.top; row < cells.Bottom(); row++)
        for (std::uint32_t column = cells.left; column < cells.Right(); column++)
            ToCome({row, column}) = Overlap(AreaOf({row, column}), rendered);
}

bool CellStore::IsInside(const Place& place) const
{
    return place.first >= 0 && place.second >= 0 && place.first * kCell < height && place.second * kCell < width;
}

Area CellStore::AreaOf(const Place& place) const
{
    const std::uint32_t left = place.second * kCell, top = place.first * kCell;
    return {left, top, std::min(kCell, width - left), std::min(kCell, height - top)};
}

std::uint16_t& CellStore::ToCome(const Place& place)
{
    return toCome[(place.first - cells.top) * std::size_t(cells.width) + (place.second - cells.left)];
}

bool CellStore::HasToCome(const Place& place) const
{
    return place.first >= 0 && place.second >= 0 && cells.Has(place.second, place.first) &&
           const_cast<CellStore*>(this)->ToCome(place) > 0;
}

std::shared_ptr<Cell> CellStore::Get(const Place& place)
{
    if (!IsInside(place))
        return nullptr;
    const std::lock_guard<std::mutex> lock(mutex);
    Entry& entry = entries[place];
    if (!entry.cell)
    {
        entry.cell = std::make_shared<Cell>(AreaOf(place));
        for (std::int64_t dy = -kReach; dy <= kReach; dy++)
            for (std::int64_t dx = -kReach; dx <= kReach; dx++)
                entry.users += HasToCome({place.first + dy, place.second + dx});
    }
    return entry.cell;
}

std::shared_ptr<Cell> CellStore::FinishedCell(const Place& place, const Tracer& trace)
{
    const std::shared_ptr<Cell> cell = Get(place);
    if (!cell || cell->IsFinished())
        return cell;
    std::array<std::shared_ptr<Cell>, 9> held;
    Cell::Neighbours neighbours{};
    for (int i = 0; i < 9; i++)
    {
        // the plain mean of the most samples asks no neighbour
        if (i != 4 && limits.variance == 0.0)
            continue;
        held[i] = i == 4 ? cell : Get({place.first + i / 3 - 1, place.second + i % 3 - 1});
        if (held[i])
            held[i]->TakeFirst(limits, trace);
        neighbours[i] = held[i].get();
    }
    cell->Finish(neighbours, limits, trace);
    return cell;
}

std::shared_ptr<const Cell> CellStore::Finished(std::uint32_t x, std::uint32_t y, const Tracer& trace)
{
    return FinishedCell({y / kCell, x / kCell}, trace);
}

CellStore::Block CellStore::FinishedAround(std::uint32_t x, std::uint32_t y, const Tracer& trace)
{
    Block block;
    const Place place(y / kCell, x / kCell);
    for (int i = 0; i < 9; i++)
        block[i] = FinishedCell({place.first + i / 3 - 1, place.second + i % 3 - 1}, trace);
    return block;
}

void CellStore::Forget(const Area& tile)
{
    const std::lock_guard<std::mutex> lock(mutex);
    const Area own = CellsOf(tile);
    for (std::int64_t row = own.top; row < own.Bottom(); row++)
        for (std::int64_t column = own.left; column < own.Right(); column++)
        {
            std::uint16_t& left = ToCome({row, column});
            left -= Overlap(AreaOf({row, column}), tile);
            if (left > 0)
                continue;
            for (std::int64_t dy = -kReach; dy <= kReach; dy++)
                for (std::int64_t dx = -kReach; dx <= kReach; dx++)
                {
                    const auto user = entries.find({row + dy, column + dx});
                    if (user != entries.end() && --user->second.users == 0)
                        entries.erase(user);
                }
        }
}

std::size_t CellStore::Size() const
{
    const std::lock_guard<std::mutex> lock(mutex);
    return entries.size();
}

} // namespace tilt_lens
