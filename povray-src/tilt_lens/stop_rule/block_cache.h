// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_cache.h
/// A picture's blocks, shared by all render threads. The first thread that needs a block samples it; the block is freed when no remaining
/// tile depends on it (docs/sampling.md, section 7).

#ifndef TILT_LENS_BLOCK_CACHE_H
#define TILT_LENS_BLOCK_CACHE_H

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tilt_lens/stop_rule/block.h"

namespace tilt_lens
{

class BlockCache
{
  public:
    /// @param width, height  whole picture, pixels
    /// @param rendered  the part that will be requested
    BlockCache(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered);

    const SamplingLimits limits;

    using Place = std::pair<std::int64_t, std::int64_t>;  ///< row and column, in blocks

    static Place PlaceOf(std::uint32_t x, std::uint32_t y) { return {y / Settings::blockSide, x / Settings::blockSide}; }

    /// Takes all steps of these blocks; ignores places outside the picture. The thread waits for others only if there are no further blocks
    /// to work ahead on.
    void Finish(const std::vector<Place>& wanted, const Tracer& trace);

    /// Null outside the picture, and if no remaining pixel depends on the block.
    std::shared_ptr<const Block> At(const Place& place) { return Get(place); }

    /// The pixels of `tile` will not be requested again.
    void Release(const Area& tile);

    std::size_t Size() const;

  private:
    struct Entry
    {
        std::shared_ptr<Block> block;
        std::uint32_t users = 0;  ///< blocks within the dependency radius with remaining pixels
    };

    const std::uint32_t width, height;
    const Area blocks;  ///< with rendered pixels; in blocks
    mutable std::mutex mutex;
    std::condition_variable stepTaken;
    std::uint64_t steps = 0;  ///< steps completed or interrupted
    std::int64_t firstRow;  ///< with remaining pixels
    std::vector<std::uint16_t> toCome;  ///< unreleased pixels of each block
    std::map<Place, Entry> entries;

    bool IsInside(const Place& place) const;
    Area PixelsOf(const Place& place) const;
    bool HasToCome(const Place& place) const;
    std::uint16_t& ToCome(const Place& place);
    std::shared_ptr<Block> Get(const Place& place);
    bool Advance(const Place& place, int steps, const Tracer& trace);
    bool AdvanceAny(const Tracer& trace);
    std::vector<Place> Window();
    template<class Step>
    bool TakeStep(const Step& step);
};

}  // namespace tilt_lens

#endif
