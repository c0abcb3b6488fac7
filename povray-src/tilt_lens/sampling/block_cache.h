// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_cache.h
/// The blocks of a picture that is being rendered, shared by all its threads. A tile needs its own blocks and looks at those
/// around them, which are other tiles' own: whoever needs a block first samples it, and it is kept until nobody needs it any
/// more (docs/sampling.md, section 10).

#ifndef TILT_LENS_BLOCK_CACHE_H
#define TILT_LENS_BLOCK_CACHE_H

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tilt_lens/sampling/block.h"

namespace tilt_lens
{

class BlockCache
{
  public:
    /// @param width, height  of the whole picture
    /// @param rendered  the part of it that will be asked for
    BlockCache(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered);

    const SamplingLimits limits;

    using Place = std::pair<std::int64_t, std::int64_t>;  ///< row and column of blocks

    static Place PlaceOf(std::uint32_t x, std::uint32_t y) { return {y / settings.blockSide, x / settings.blockSide}; }

    /// Takes steps until the blocks at these places, those that lie in the picture, have taken all. While other threads take what is
    /// missing, this one takes whatever else will be asked for; it waits only where there is none.
    void Finish(const std::vector<Place>& wanted, const Tracer& trace);

    /// The block at a place; null outside the picture, and where no pixel to come depends on it. It stays while the caller holds it.
    std::shared_ptr<const Block> At(const Place& place) { return Get(place); }

    /// Tells that the pixels of `tile` will not be asked for again.
    void Release(const Area& tile);

    /// Blocks held now.
    std::size_t Size() const;

  private:
    struct Entry
    {
        std::shared_ptr<Block> block;
        std::uint32_t users = 0;  ///< blocks within the dependency radius that have pixels to come
    };

    const std::uint32_t width, height;
    const Area blocks;  ///< that hold rendered pixels; counted in blocks
    mutable std::mutex mutex;
    std::condition_variable stepTaken;
    std::uint64_t steps = 0;  ///< that were taken or broken off
    std::int64_t firstRow;             ///< of blocks with pixels to come
    std::vector<std::uint16_t> toCome; ///< of each of `blocks`: pixels that are rendered and not yet released
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

} // namespace tilt_lens

#endif
