// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Emitter sampling through a lens of glass.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tilt_lens/samples/emitter_sampling.h"

namespace tilt_lens
{

namespace
{

constexpr double beyond = 2.0;  ///< the pupil, a unit disc: no ray

/// Radius, pixels, above which cells are those of the whole pixel: exact ones would cost more than they save.
constexpr double largeImage = 1.0;

std::size_t ThirdOf(const EmitterSampling::Targets::Target& target, double hue)
{
    const double thirds = double(target.cells.size());
    return std::size_t(std::clamp(0.5 * (hue + 1.0) * thirds, 0.0, thirds - 1.0));
}

} // namespace

EmitterSampling::Box EmitterSampling::PixelsOf(const FilmBox& film) const
{
    return {(film.left + 0.5) * plain.width, (film.right + 0.5) * plain.width, (0.5 - film.top) * plain.height,
            (0.5 - film.bottom) * plain.height};
}

/// Cells through which a film point sees the target: of an image smaller than a pixel, some of the pixel's.
/// @param[out] some  space for them
const GlassSight::Cells& EmitterSampling::CellsAt(const Targets::Target& target, const FilmPoint& film, double hue,
                                                  GlassSight::Cells& some) const
{
    const Kept& emitter = kept[target.emitter];
    const std::size_t third = ThirdOf(target, hue);
    const GlassSight::Cells& all = target.cells[third];
    if (emitter.imageRadius > largeImage)
        return all;
    const double across = emitter.imageRadius / plain.width, along = emitter.imageRadius / plain.height;
    const FilmBox box{film.x - across, film.x + across, film.y - along, film.y + along};
    some.clear();
    std::copy_if(all.begin(), all.end(), std::back_inserter(some),
                 [&](std::uint16_t cell) { return emitter.sight->Shows(cell, box, third); });
    return some;
}

EmitterSampling::Choice EmitterSampling::Choose(const Targets& targets, const FilmPoint& film, double u, double v, double hue) const
{
    const Targets::Target* const target = TargetOf(targets, u);
    if (target == nullptr)
        return {u, v, false};
    GlassSight::Cells some;
    const GlassSight::Cells& cells = CellsAt(*target, film, hue, some);
    const double emission = targets.emission * plain.camera->Glass()->OpenShare(film), place = u * cells.size();
    if (cells.empty())
        return {beyond, beyond, true, emission};
    const AperturePoint point = GlassSight::PointOf(cells[std::size_t(place)], place - std::floor(place), v);
    return {point.a, point.b, true, emission};
}

double EmitterSampling::OverPlain(const Targets& targets, const FilmPoint& film, const AperturePoint& pupil, double hue) const
{
    if (std::hypot(pupil.a, pupil.b) >= beyond)
        return 0.0;
    // plain samples are even over the part of the pupil that passes
    const double passing = plain.camera->Glass()->PassingShare(film) * GlassSight::kCount;
    const std::uint16_t cell = GlassSight::CellAt(pupil);
    double density = 1.0 - targets.share;
    const auto hold = [cell](const GlassSight::Cells& cells) { return std::binary_search(cells.begin(), cells.end(), cell); };
    GlassSight::Cells some;
    for (const Targets::Target& target : targets.targets)
        if (hold(target.cells[ThirdOf(target, hue)]))  // few do: CellsAt() costs more
            if (const GlassSight::Cells& cells = CellsAt(target, film, hue, some); hold(cells))
                density += target.share * passing / cells.size();
    return 1.0 / density;
}

/// Cells through which the pixel sees the target; false if there are none.
bool EmitterSampling::FindCells(std::uint32_t x, std::uint32_t y, Targets::Target& target) const
{
    const Kept& emitter = kept[target.emitter];
    if (!emitter.sight)
        return true;
    const double margin = emitter.imageRadius;
    const FilmPoint upperLeft = FilmPointAt(x - margin, y - margin, plain.width, plain.height);
    const FilmPoint lowerRight = FilmPointAt(x + 1.0 + margin, y + 1.0 + margin, plain.width, plain.height);
    for (std::size_t third = 0; third < emitter.sight->Thirds(); third++)
    {
        target.cells.push_back(emitter.sight->CellsOf({upperLeft.x, lowerRight.x, lowerRight.y, upperLeft.y}, third));
        if (target.cells.back().empty())
            return false;
    }
    return true;
}

} // namespace tilt_lens
