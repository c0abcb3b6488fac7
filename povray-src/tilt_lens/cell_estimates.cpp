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

/// Share of the first samples of a cell, or of it and its neighbours, that must have met anything: what meets nothing is
/// cheaper to sample than to rebuild, and few hits of something bright say little of what is alike.
constexpr double kMetShare = 1.0 / 6.0;

/// Samples a pixel that met anything which are enough else.
constexpr double kEnoughMet = 32.0;

/// Rows with less than this share of the variance that is asked for are as good as without noise.
constexpr double kNoticed = 1.0 / 32.0;

/// Whether a pixel's noise is less than half of its brightness.
bool IsKnown(const Estimates& estimates, std::size_t pixel)
{
    double light = 0.0;
    for (const CellPlane& mean : estimates.mean)
        light += double(mean[pixel]) * mean[pixel];
    return estimates.noise[pixel] <= 0.25 * light;
}

} // namespace

/// Takes from the variances of pixels what the reconstruction will take: of what their own samples
/// show, not of what is only feared because neighbours saw it.
void Cell::CreditReconstruction(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples,
                                std::vector<Judged>& judged)
{
    const auto isGood = [](const Radiance& variance, const Judged& one)
    {
        return *std::max_element(variance.begin(), variance.end()) <= one.allowed;
    };
    if (std::none_of(judged.begin(), judged.end(), [&](const Judged& one)
        { return one.pixel->remains < kCounts && !isGood(one.variance, one); }))
        return;
    NoteEstimates(samples);
    const Estimates& estimates = *LastEstimates();
    const auto placeOf = [&](const Judged& one)
    {
        const std::size_t i = one.pixel - pixels.data();
        return i / area.width * kCell + i % area.width;
    };
    const auto credited = [&](const Judged& one)
    {
        const std::size_t place = placeOf(one);
        Radiance variance = one.variance;
        // a few hits of something bright say little of how often it is hit
        if (one.pixel->remains >= kCounts || !IsKnown(estimates, place))
            return variance;
        for (std::size_t c = 0; c < variance.size(); c++)
        {
            const double seen = one.pixel->gain * one.pixel->own.variance[c] / samples / Brightness(estimates.mean[c][place]);
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
    const CellPlane remains = Remains(neighbours, samples == limits.First());
    for (Judged& one : judged)
    {
        one.pixel->remains = remains[placeOf(one)];
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
std::unique_ptr<const Estimates> Cell::Estimated() const
{
    const bool varied = IsVaried();  // where nothing differs, there is no noise to estimate
    const std::array<Radiance, kCell * kCell> variance = varied ? VarianceAround() : std::array<Radiance, kCell * kCell>{};
    auto estimates = std::make_unique<Estimates>();
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        const Pixel& pixel = pixels[i];
        Radiance halves{};
        double noise = 0.0;
        for (std::size_t c = 0; varied && c < halves.size(); c++)
        {
            noise += variance[i][c];
            halves[c] = pixel.half[0][c] / pixel.middle - pixel.half[1][c] / (pixel.samples - pixel.middle);
        }
        estimates->Set(i % area.width, i / area.width, MeanOf(pixel), halves, pixel.gain * noise / pixel.samples);
    }
    estimates->RepeatEdges(area.width, area.height);
    return estimates;
}

/// Whether the first samples met enough for the reconstruction to look at the cell, for itself or for its neighbours.
bool Cell::MeetsEnough(const Neighbours& neighbours)
{
    double sum = 0.0;
    int count = 0;
    for (const Cell* cell : neighbours)
        if (cell != nullptr)
        {
            sum += cell->metShare;
            count++;
        }
    return sum >= kMetShare * count;
}

/// Whether the samples so far did.
bool Cell::IsWorthRebuilding(const SamplingLimits& limits) const
{
    return limits.Denoises() && (meetsEnough || met >= kEnoughMet * pixels.size());
}

/// Of the samples taken so far. After the first round neighbours look at what was noted in it.
void Cell::NoteEstimates(std::uint32_t samples)
{
    if (samples == estimatedSamples)
        return;
    (begun ? laterEstimates : firstEstimates) = Estimated();
    estimatedSamples = samples;
}

/// @param estimatesOf  a cell's pixels; null where they are not known: the cell is left out
template<class EstimatesOf>
Surroundings Cell::Gather(const Neighbours& cells, const EstimatesOf& estimatesOf)
{
    std::array<const Estimates*, 9> known;
    std::transform(cells.begin(), cells.end(), known.begin(), [&](const Cell* cell)
        { return cell != nullptr ? estimatesOf(*cell) : nullptr; });
    return Surroundings(known);
}

/// What share of the pixels' variances the reconstruction will leave, as far as the cell and the first samples of its
/// neighbours tell; once it has more samples itself, the cell alone: noise of theirs would pass for its own error.
CellPlane Cell::Remains(const Neighbours& neighbours, bool afterFirst) const
{
    const Surroundings around = Gather(neighbours, [this, afterFirst](const Cell& cell)
    {
        return &cell == this ? LastEstimates() : afterFirst ? cell.firstEstimates.get() : nullptr;
    });
    return Rebuild(around).remains;
}

/// From the first to the last with noise that is noticed beside what is asked for.
Rows Cell::NoisyRows(const SamplingLimits& limits) const
{
    Rows rows{int(area.height), 0};
    if (LastEstimates() == nullptr)
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
    return Gather(cells, [](const Cell& cell) { return cell.LastEstimates(); });
}

} // namespace tilt_lens
