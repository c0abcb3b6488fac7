// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell_store.h
/// The cells of a picture that is being rendered, shared by all its threads. A tile needs its own cells
/// and looks at those around them, which are other tiles' own: whoever needs a cell first samples it,
/// and it is kept until nobody needs it any more.

#ifndef TILT_LENS_CELL_STORE_H
#define TILT_LENS_CELL_STORE_H

#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "tilt_lens/sampling/cell.h"

namespace tilt_lens
{

class CellStore
{
  public:
    /// @param width, height  of the whole picture
    /// @param rendered  the part of it that will be asked for
    CellStore(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, const Area& rendered);

    const SamplingLimits limits;

    /// The finished cell that holds pixel (x, y). It stays while the caller holds it.
    std::shared_ptr<const Cell> Finished(std::uint32_t x, std::uint32_t y, const Tracer& trace);

    /// The same and the eight around it, row by row; null outside the picture.
    using Block = std::array<std::shared_ptr<const Cell>, 9>;
    Block FinishedAround(std::uint32_t x, std::uint32_t y, const Tracer& trace);

    /// Tells that the pixels of `tile` will not be asked for again.
    void Forget(const Area& tile);

    /// Cells held now.
    std::size_t Size() const;

  private:
    using Place = std::pair<std::int64_t, std::int64_t>;  ///< row and column of cells

    struct Entry
    {
        std::shared_ptr<Cell> cell;
        std::uint32_t users = 0;  ///< cells in reach that have pixels to come
    };

    const std::uint32_t width, height;
    const Area cells;  ///< that hold rendered pixels; counted in cells
    mutable std::mutex mutex;
    std::vector<std::uint16_t> toCome; ///< of each of `cells`: pixels that are rendered and not yet forgotten
    std::map<Place, Entry> entries;

    bool IsInside(const Place& place) const;
    Area AreaOf(const Place& place) const;
    bool HasToCome(const Place& place) const;
    std::uint16_t& ToCome(const Place& place);
    std::shared_ptr<Cell> Get(const Place& place);
    std::shared_ptr<Cell> FinishedCell(const Place& place, const Tracer& trace);
};

} // namespace tilt_lens

#endif
