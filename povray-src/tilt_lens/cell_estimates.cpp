// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell_estimates.cpp
/// What a cell tells the reconstruction of its pixels, and what it may expect of it.

#include "cell.h"

#include <algorithm>

namespace tilt_lens
{

namespace
{

/// Whether a pixel's noise is less than half of its brightness.
bool IsKnown(const Estimate& estimate)
{
    double noise = 0.0, light = 0.0;
    for (std::size_t c = 0; c < estimate.mean.size(); c++)
    {
        noise += estimate.variance[c];
        light += double(estimate.mean[c]) * estimate.mean[c];
    }
    return noise <= 0.25 * light;
}

template<class Channels>
bool IsNothing(const Channels& channels)
{
    return std::all_of(channels.begin(), channels.end(), [](auto x) { return x == 0; });
}

} // namespace

/// Takes from the variances of pixels what the reconstruction will take: of what their own samples
/// show, not of what is only feared because neighbours saw it.
void Cell::CreditReconstruction(const Neighbours& neighbours, std::vector<Judged>& judged) const
{
    const std::vector<Estimate>& estimates = LastEstimates();
    const auto credited = [&](const Judged& one, std::size_t c, double share)
    {
        const Estimate& estimate = estimates[one.pixel - pixels.data()];
        // a few hits of something bright say little of how often it is hit
        if (!IsKnown(estimate))
            return one.variance[c];
        const double seen = estimate.variance[c] / Brightness(estimate.mean[c]);
        return one.variance[c] - share * std::min(seen, one.variance[c]);
    };
    // only where it makes a difference
    const bool matters = std::any_of(judged.begin(), judged.end(), [&](const Judged& one)
    {
        bool good = true, canBeGood = true;
        for (std::size_t c = 0; c < one.variance.size(); c++)
        {
            good = good && one.variance[c] <= one.allowed;
            canBeGood = canBeGood && credited(one, c, 1.0 - kLeastRemains) <= one.allowed;
        }
        return !good && canBeGood;
    });
    if (!matters)
        return;
    const CellPlane remains = Remains(neighbours);
    for (Judged& one : judged)
    {
        const std::size_t i = one.pixel - pixels.data();
        const double share = 1.0 - remains[i / area.width * kCell + i % area.width];
        for (std::size_t c = 0; c < one.variance.size(); c++)
            one.variance[c] = credited(one, c, share);
    }
}

/// What is known of the pixels, for the reconstruction: the variance of the mean from the samples of a
/// pixel and of those around it in the cell.
std::vector<Estimate> Cell::Estimates() const
{
    std::vector<Estimate> estimates(pixels.size());
    const bool noisy = !std::all_of(pixels.begin(), pixels.end(), [](const Pixel& pixel) { return IsNothing(pixel.spread); });
    for (std::uint32_t y = 0; y < area.height; y++)
        for (std::uint32_t x = 0; x < area.width; x++)
        {
            Radiance sum{};
            int count = 0;
            for (std::uint32_t v = y == 0 ? 0 : y - 1; noisy && v <= y + 1 && v < area.height; v++)
                for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < area.width; u++, count++)
                    AddTo(sum, pixels[v * area.width + u].spread);
            const Pixel& pixel = pixels[y * area.width + x];
            const Radiance mean = MeanOf(pixel);
            Estimate& estimate = estimates[y * area.width + x];
            estimate.samples = pixel.samples;
            for (std::size_t c = 0; c < sum.size(); c++)
            {
                estimate.mean[c] = mean[c];
                if (noisy)
                    estimate.variance[c] = pixel.gain * sum[c] / count / pixel.samples;
                if (pixel.samples > 1)
                    estimate.halves[c] = pixel.half[0][c] / pixel.middle - pixel.half[1][c] / (pixel.samples - pixel.middle);
            }
        }
    return estimates;
}

/// @param estimateOf  of a cell's pixel by its index
template<class EstimateOf>
Surroundings Cell::Gather(const Neighbours& cells, const EstimateOf& estimateOf)
{
    constexpr std::int64_t border = Surroundings::kBorder, end = kCell + border;
    const std::int64_t left = cells[4]->area.left, top = cells[4]->area.top;
    Surroundings around;
    for (const Cell* cell : cells)
    {
        if (cell == nullptr)
            continue;
        const Area& area = cell->area;
        for (std::int64_t y = std::max(area.top - top, -border); y < std::min(area.Bottom() - top, end); y++)
            for (std::int64_t x = std::max(area.left - left, -border); x < std::min(area.Right() - left, end); x++)
                around.Set(x, y, estimateOf(*cell, cell->Index(x + left, y + top)));
    }
    return around;
}

/// What share of the pixels' variances the reconstruction will leave, as far as the first samples of
/// the neighbours tell.
CellPlane Cell::Remains(const Neighbours& neighbours) const
{
    const Surroundings around = Gather(neighbours, [this](const Cell& cell, std::size_t i) -> const Estimate&
    {
        return (&cell == this ? LastEstimates() : cell.firstEstimates)[i];
    });
    return Rebuild(around, false).remains;
}

bool Cell::IsNoiseless() const
{
    return std::all_of(LastEstimates().begin(), LastEstimates().end(),
                       [](const Estimate& estimate) { return IsNothing(estimate.variance); });
}

Surroundings Cell::SurroundingsOf(const Neighbours& cells)
{
    return Gather(cells, [](const Cell& cell, std::size_t i) -> const Estimate& { return cell.LastEstimates()[i]; });
}

} // namespace tilt_lens
