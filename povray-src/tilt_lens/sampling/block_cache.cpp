// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/block_cache.h"

#include <algorithm>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

namespace
{

std::uint32_t Overlap(std::uint32_t beginA, std::uint32_t endA, std::uint32_t beginB, std::uint32_t endB)
{
    const std::uint32_t begin = std::max(beginA, beginB), end = std::min(endA, endB);
    return begin < end ? end - begin : 0;
}

std::uint32_t Overlap(const Area& a, const Area& b)
{
    return Overlap(a.left, a.Right(), b.left, b.Right()) * Overlap(a.top, a.Bottom(), b.top, b.Bottom());
}

Area BlocksOf(const Area& pixels)
{
    const std::uint32_t left = pixels.left / settings.blockSide, top = pixels.top / settings.blockSide;
    const std::uint32_t right = (pixels.Right() + settings.blockSide - 1) / settings.blockSide;
    const std::uint32_t bottom = (pixels.Bottom() + settings.blockSide - 1) / settings.blockSide;
    return {left, top, right - left, bottom - top};
}

} // namespace

BlockCache::BlockCache(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered) :
    limits(limits), width(width), height(height), blocks(BlocksOf(rendered)), toCome(std::size_t(blocks.width) * blocks.height)
{
    for (std::uint32_t row = blocks.top; row < blocks.Bottom(); row++)
        for (std::uint32_t column = blocks.left; column < blocks.Right(); column++)
            ToCome({row, column}) = Overlap(PixelsOf({row, column}), rendered);
}

bool BlockCache::IsInside(const Place& place) const
{
    return place.first >= 0 && place.second >= 0 && place.first * settings.blockSide < height &&
           place.second * settings.blockSide < width;
}

Area BlockCache::PixelsOf(const Place& place) const
{
    const std::uint32_t left = place.second * settings.blockSide, top = place.first * settings.blockSide;
    return {left, top, std::min(settings.blockSide, width - left), std::min(settings.blockSide, height - top)};
}

std::uint16_t& BlockCache::ToCome(const Place& place)
{
    return toCome[(place.first - blocks.top) * std::size_t(blocks.width) + (place.second - blocks.left)];
}

bool BlockCache::HasToCome(const Place& place) const
{
    return place.first >= 0 && place.second >= 0 && blocks.Has(place.second, place.first) &&
           const_cast<BlockCache*>(this)->ToCome(place) > 0;
}

std::shared_ptr<Block> BlockCache::Get(const Place& place)
{
    if (!IsInside(place))
        return nullptr;
    const std::lock_guard<std::mutex> lock(mutex);
    Entry& entry = entries[place];
    if (!entry.block)
    {
        entry.block = std::make_shared<Block>(PixelsOf(place), width, height);
        for (std::int64_t dy = -settings.dependencyRadius; dy <= settings.dependencyRadius; dy++)
            for (std::int64_t dx = -settings.dependencyRadius; dx <= settings.dependencyRadius; dx++)
                entry.users += HasToCome({place.first + dy, place.second + dx});
    }
    return entry.block;
}

std::shared_ptr<Block> BlockCache::ConvergedBlock(const Place& place, const Tracer& trace)
{
    const std::shared_ptr<Block> block = Get(place);
    if (!block || block->IsConverged())
        return block;
    std::array<std::shared_ptr<Block>, 9> held;
    Block::Neighbours neighbours{};
    for (int i = 0; i < 9; i++)
    {
        // the plain mean of the most samples asks no neighbour
        if (i != 4 && limits.variance == 0.0)
            continue;
        held[i] = i == 4 ? block : Get({place.first + i / 3 - 1, place.second + i % 3 - 1});
        if (held[i])
            held[i]->TakeFirstRound(limits, trace);
        neighbours[i] = held[i].get();
    }
    block->TakeFurtherRounds(neighbours, limits, trace);
    return block;
}

std::shared_ptr<const Block> BlockCache::Converged(std::uint32_t x, std::uint32_t y, const Tracer& trace)
{
    return ConvergedBlock({y / settings.blockSide, x / settings.blockSide}, trace);
}

BlockCache::BlockAndNeighbours BlockCache::ConvergedAround(std::uint32_t x, std::uint32_t y, const Tracer& trace)
{
    BlockAndNeighbours around;
    const Place place(y / settings.blockSide, x / settings.blockSide);
    for (int i = 0; i < 9; i++)
        around[i] = ConvergedBlock({place.first + i / 3 - 1, place.second + i % 3 - 1}, trace);
    return around;
}

void BlockCache::Release(const Area& tile)
{
    const std::lock_guard<std::mutex> lock(mutex);
    const Area own = BlocksOf(tile);
    for (std::int64_t row = own.top; row < own.Bottom(); row++)
        for (std::int64_t column = own.left; column < own.Right(); column++)
        {
            std::uint16_t& left = ToCome({row, column});
            left -= Overlap(PixelsOf({row, column}), tile);
            if (left > 0)
                continue;
            for (std::int64_t dy = -settings.dependencyRadius; dy <= settings.dependencyRadius; dy++)
                for (std::int64_t dx = -settings.dependencyRadius; dx <= settings.dependencyRadius; dx++)
                {
                    const auto user = entries.find({row + dy, column + dx});
                    if (user != entries.end() && --user->second.users == 0)
                        entries.erase(user);
                }
        }
}

std::size_t BlockCache::Size() const
{
    const std::lock_guard<std::mutex> lock(mutex);
    return entries.size();
}

} // namespace tilt_lens
