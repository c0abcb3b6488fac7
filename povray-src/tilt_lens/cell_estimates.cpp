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

/// The reconstruction is counted on where it leaves less than this share of the variance. What it leaves elsewhere is
/// as uncertain as what it would save.
constexpr double kCounts = 0.5;

/// Rays that finding out what it leaves takes the time of, about: two for each pixel of a cell.
constexpr double kWorth = 2.0 * kCell * kCell;

/// Samples a pixel that must have met anything, if most of the first ones did not: what meets nothing is cheaper to
/// sample than to rebuild, and few hits of something bright say little of what is alike.
constexpr double kEnoughMet = 32.0;

/// Rows with less than this share of the variance that is asked for are as good as without noise.
constexpr double kNoticed = 1.0 / 32.0;

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

} // namespace

/// Takes from the variances of pixels what the reconstruction will take: of what their own samples
/// show, not of what is only feared because neighbours saw it.
void Cell::CreditReconstruction(const Neighbours& neighbours, std::uint32_t samples, std::vector<Judged>& judged)
{
    const auto isGood = [](const Radiance& variance, const Judged& one)
    {
        return *std::max_element(variance.begin(), variance.end()) <= one.allowed;
    };
    if (std::none_of(judged.begin(), judged.end(), [&](const Judged& one)
        { return one.pixel->remains < kCounts && !isGood(one.variance, one); }))
        return;
    NoteEstimates(samples);
    const std::vector<Estimate>& estimates = LastEstimates();
    const auto credited = [&](const Judged& one)
    {
        const Estimate& estimate = estimates[one.pixel - pixels.data()];
        Radiance variance = one.variance;
        // a few hits of something bright say little of how often it is hit
        if (one.pixel->remains >= kCounts || !IsKnown(estimate))
            return variance;
        for (std::size_t c = 0; c < variance.size(); c++)
        {
            const double seen = one.pixel->gain * one.pixel->own.variance[c] / samples / Brightness(estimate.mean[c]);
            variance[c] -= (1.0 - one.pixel->remains) * std::min(seen, variance[c]);
        }
        return variance;
    };
    // Only where it may save enough rays: the less noise, the better pixels are told apart, so that no more
    // than in the round before is to be hoped for.
    const auto hoped = std::count_if(judged.begin(), judged.end(), [&](const Judged& one)
        { return !isGood(one.variance, one) && isGood(credited(one), one); });
    if (hoped * samples < kWorth)
        return;
    const CellPlane remains = Remains(neighbours);
    for (Judged& one : judged)
    {
        const std::size_t i = one.pixel - pixels.data();
        one.pixel->remains = remains[i / area.width * kCell + i % area.width];
        one.variance = credited(one);
    }
}

/// Mean variance of one sample over the 3 by 3 pixels around each, as far as they are in the cell.
std::array<Radiance, kCell * kCell> Cell::VarianceAround() const
{
    std::array<Radiance, kCell * kCell> around{};
    std::array<std::array<Radiance, kCell>, kCell + 2> rows{};  // sums of three pixels side by side
    for (std::uint32_t y = 0; y < area.height; y++)
        for (std::uint32_t x = 0; x < area.width; x++)
            for (std::uint32_t u = x > 0 ? x - 1 : 0; u < std::min(x + 2, area.width); u++)
                AddTo(rows[y + 1][x], pixels[y * area.width + u].own.variance);
    for (std::uint32_t y = 0; y < area.height; y++)
        for (std::uint32_t x = 0; x < area.width; x++)
        {
            const int columns = 1 + (x > 0) + (x + 1 < area.width), lines = 1 + (y > 0) + (y + 1 < area.height);
            const double share = 1.0 / (columns * lines);
            Radiance& mean = around[y * area.width + x];
            for (std::size_t c = 0; c < mean.size(); c++)
                mean[c] = share * (rows[y][x][c] + rows[y + 1][x][c] + rows[y + 2][x][c]);
        }
    return around;
}

/// What is known of the pixels, for the reconstruction: the variance of the mean from the samples of a
/// pixel and of those around it in the cell.
std::vector<Estimate> Cell::Estimates() const
{
    const bool varied = IsVaried();  // where nothing differs, there is no noise to estimate
    const std::array<Radiance, kCell * kCell> variance = varied ? VarianceAround() : std::array<Radiance, kCell * kCell>{};
    std::vector<Estimate> estimates(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        const Pixel& pixel = pixels[i];
        const Radiance mean = MeanOf(pixel);
        Estimate& estimate = estimates[i];
        estimate.samples = pixel.samples;
        std::copy(mean.begin(), mean.end(), estimate.mean.begin());
        for (std::size_t c = 0; varied && c < mean.size(); c++)
        {
            estimate.variance[c] = pixel.gain * variance[i][c] / pixel.samples;
            estimate.halves[c] = pixel.half[0][c] / pixel.middle - pixel.half[1][c] / (pixel.samples - pixel.middle);
        }
    }
    return estimates;
}

/// Whether the samples so far met enough for the reconstruction to look at the cell, for itself or for its neighbours.
bool Cell::IsWorthRebuilding(const SamplingLimits& limits) const
{
    const double enough = begun ? kEnoughMet : std::min(kEnoughMet, 0.5 * limits.First());
    return limits.Denoises() && (!firstEstimates.empty() || met >= enough * pixels.size());
}

/// Of the samples taken so far.
void Cell::NoteEstimates(std::uint32_t samples)
{
    if (samples == estimatedSamples)
        return;
    (estimatedSamples == 0 ? firstEstimates : laterEstimates) = Estimates();
    estimatedSamples = samples;
}

/// @param estimatesOf  a cell's pixels; none where there are none yet or the cell is left out
template<class EstimatesOf>
Surroundings Cell::Gather(const Neighbours& cells, const EstimatesOf& estimatesOf)
{
    constexpr std::int64_t border = Surroundings::kBorder, end = kCell + border;
    const std::int64_t left = cells[4]->area.left, top = cells[4]->area.top;
    Surroundings around(std::all_of(cells.begin(), cells.end(), [&](const Cell* cell)
        { return cell != nullptr && estimatesOf(*cell).size() == kCell * kCell; }));
    for (const Cell* cell : cells)
    {
        if (cell == nullptr)
            continue;
        const std::vector<Estimate>& estimates = estimatesOf(*cell);
        if (estimates.empty())
            continue;
        const Area& area = cell->area;
        for (std::int64_t y = std::max(area.top - top, -border); y < std::min(area.Bottom() - top, end); y++)
            for (std::int64_t x = std::max(area.left - left, -border); x < std::min(area.Right() - left, end); x++)
                around.Set(x, y, estimates[cell->Index(x + left, y + top)]);
    }
    return around;
}

/// What share of the pixels' variances the reconstruction will leave, as far as the first samples of
/// the neighbours tell.
CellPlane Cell::Remains(const Neighbours& neighbours) const
{
    const Surroundings around = Gather(neighbours, [this](const Cell& cell) -> const std::vector<Estimate>&
    {
        return &cell == this ? LastEstimates() : cell.firstEstimates;
    });
    return Rebuild(around, false).remains;
}

/// From the first to the last with noise that is noticed beside what is asked for.
Rows Cell::NoisyRows(const SamplingLimits& limits) const
{
    Rows rows{int(area.height), 0};
    if (LastEstimates().empty())
        return rows;
    for (int y = 0; y < int(area.height); y++)
    {
        double variance = 0.0;
        for (std::uint32_t x = 0; x < area.width; x++)
            variance += final[y * area.width + x].variance;
        if (variance > kNoticed * limits.variance * area.width)
            rows = {std::min(rows.begin, y), y + 1};
    }
    return rows;
}

Surroundings Cell::SurroundingsOf(const Neighbours& cells)
{
    return Gather(cells, [](const Cell& cell) -> const std::vector<Estimate>& { return cell.LastEstimates(); });
}

} // namespace tilt_lens
