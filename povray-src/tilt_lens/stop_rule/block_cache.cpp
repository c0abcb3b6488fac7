// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/block_cache.h"

#include <algorithm>
#include <array>

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
    const std::uint32_t left = pixels.left / Settings::blockSide, top = pixels.top / Settings::blockSide;
    const std::uint32_t right = (pixels.Right() + Settings::blockSide - 1) / Settings::blockSide;
    const std::uint32_t bottom = (pixels.Bottom() + Settings::blockSide - 1) / Settings::blockSide;
    return {left, top, right - left, bottom - top};
}

} // namespace

BlockCache::BlockCache(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered) :
    limits(limits),
    width(width),
    height(height),
    blocks(BlocksOf(rendered)),
    firstRow(blocks.top),
    toCome(std::size_t(blocks.width) * blocks.height)
{
    for (std::uint32_t row = blocks.top; row < blocks.Bottom(); row++)
        for (std::uint32_t column = blocks.left; column < blocks.Right(); column++)
            ToCome({row, column}) = Overlap(PixelsOf({row, column}), rendered);
}

bool BlockCache::IsInside(const Place& place) const
{
    return place.first >= 0 && place.second >= 0 && place.first * Settings::blockSide < height &&
           place.second * Settings::blockSide < width;
}

Area BlockCache::PixelsOf(const Place& place) const
{
    const std::uint32_t left = place.second * Settings::blockSide, top = place.first * Settings::blockSide;
    return {left, top, std::min(Settings::blockSide, width - left), std::min(Settings::blockSide, height - top)};
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
    const auto found = entries.find(place);
    if (found != entries.end())
        return found->second.block;
    std::uint32_t users = 0;
    for (std::int64_t dy = -Settings::dependencyRadius; dy <= Settings::dependencyRadius; dy++)
        for (std::int64_t dx = -Settings::dependencyRadius; dx <= Settings::dependencyRadius; dx++)
            users += HasToCome({place.first + dy, place.second + dx});
    if (users == 0)  // released while a thread looked for work
        return nullptr;
    return entries.emplace(place, Entry{std::make_shared<Block>(PixelsOf(place), width, height, limits.settings), users})
        .first->second.block;
}

void BlockCache::Finish(const std::vector<Place>& wanted, const Tracer& trace)
{
    const auto isMissing = [this](const Place& place)
    {
        const std::shared_ptr<Block> block = Get(place);
        return block && block->StepsTaken() < Block::kSteps;
    };
    std::vector<Place> missing = wanted;
    for (;;)
    {
        std::unique_lock<std::mutex> lock(mutex);
        const std::uint64_t stepsBefore = steps;
        lock.unlock();
        missing.erase(std::remove_if(missing.begin(), missing.end(), [&](const Place& place) { return !isMissing(place); }), missing.end());
        if (missing.empty())
            return;
        bool advanced = false;
        for (const Place& place : missing)
            advanced |= Advance(place, Block::kSteps, trace);
        if (advanced || AdvanceAny(trace))
            continue;
        lock.lock();
        stepTaken.wait(lock, [&] { return steps != stepsBefore; });
    }
}

/// Wakes all waiting threads, also after an interrupted step.
template<class Step>
bool BlockCache::TakeStep(const Step& step)
{
    struct Tell
    {
        BlockCache& cache;
        bool taken = true;
        ~Tell()
        {
            if (!taken)
                return;
            const std::lock_guard<std::mutex> lock(cache.mutex);
            cache.steps++;
            cache.stepTaken.notify_all();
        }
    } tell{*this};
    return tell.taken = step();
}

/// Takes steps that no other thread has begun, until the block has taken `steps`.
bool BlockCache::Advance(const Place& place, int steps, const Tracer& trace)
{
    const std::shared_ptr<Block> block = Get(place);
    if (!block || block->StepsTaken() >= steps)
        return false;
    std::array<std::shared_ptr<Block>, 9> held;
    Block::Neighbours neighbours{};
    bool advanced = false, ready = true;
    for (int i = 0; i < 9; i++)
    {
        if (i != 4 && !Block::LooksAtNeighbours(steps, limits))
            continue;
        const Place at{place.first + i / 3 - 1, place.second + i % 3 - 1};
        held[i] = i == 4 ? block : Get(at);
        neighbours[i] = held[i].get();
        if (!held[i] || held[i]->StepsTaken() >= steps - 1)
            continue;
        advanced |= Advance(at, steps - 1, trace);
        ready = ready && held[i]->StepsTaken() >= steps - 1;
    }
    if (ready)
        advanced |= TakeStep([&] { return block->TakeStep(steps - 1, neighbours, limits, trace); });
    return advanced;
}

bool BlockCache::AdvanceAny(const Tracer& trace)
{
    for (const Place& place : Window())
        if (Advance(place, Block::kSteps, trace))
            return true;
    return false;
}

std::vector<BlockCache::Place> BlockCache::Window()
{
    const std::lock_guard<std::mutex> lock(mutex);
    std::vector<Place> places;
    const auto addRow = [&](std::int64_t row)
    {
        for (std::int64_t column = blocks.left; column < blocks.Right(); column++)
            if (HasToCome({row, column}))
                places.emplace_back(row, column);
    };
    for (; places.empty() && firstRow < blocks.Bottom(); firstRow += places.empty())
        addRow(firstRow);
    for (std::int64_t row = firstRow + 1; row < std::min<std::int64_t>(blocks.Bottom(), firstRow + Settings::windowRows); row++)
        addRow(row);
    return places;
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
            for (std::int64_t dy = -Settings::dependencyRadius; dy <= Settings::dependencyRadius; dy++)
                for (std::int64_t dx = -Settings::dependencyRadius; dx <= Settings::dependencyRadius; dx++)
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
