// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell_estimates.cpp
/// What a cell tells the reconstruction of its pixels, and what it may expect of it.

#include "tilt_lens/sampling/cell.h"

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

/// Share of the first samples of a cell and its neighbours, or of a quarter of the cell, that must have met anything: what
/// meets nothing is cheaper to sample than to rebuild, and few hits of something bright say little of what is alike.
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

/// Means over the pixels around each of some rows, as far as `kFar` from it and as far as there are any.
template<int kFar, class Values>
std::vector<Values> MeansAround(const std::vector<Values>& values, int width)
{
    const int height = int(values.size()) / width;
    const auto means = [](const std::vector<Values>& from, int along, int step, int across, int stepAcross)
    {
        std::vector<Values> to(from.size());
        for (int y = 0; y < across; y++)
            for (int x = 0; x < along; x++)
            {
                const int first = std::max(0, x - kFar), last = std::min(along - 1, x + kFar);
                Values& mean = to[y * stepAcross + x * step];
                for (int u = first; u <= last; u++)
                    for (std::size_t c = 0; c < mean.size(); c++)
                        mean[c] += from[y * stepAcross + u * step][c];
                for (double& channel : mean)
                    channel /= last - first + 1;
            }
        return to;
    };
    return means(means(values, width, 1, height, width), height, width, width, 1);
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
std::vector<Radiance> Cell::VarianceAround() const
{
    std::vector<Radiance> variance;
    for (const Pixel& pixel : pixels)
        variance.push_back(pixel.own.variance);
    return MeansAround<1>(variance, area.width);
}

/// Gain over the 5 by 5 pixels around each, as far as they are in the cell, leaning on that of its quarter as if six average
/// pixels more had shown that: nearer than it, since filters that are told too much noise blur what is no noise.
std::vector<double> Cell::GainAround() const
{
    constexpr double lean = 6.0;
    std::vector<std::array<double, 3>> noise;  // by the halves; if samples were independent; that squared
    for (const Pixel& pixel : pixels)
    {
        const double n = pixel.samples, a = pixel.middle, b = n - a;
        double byHalves = 0.0, independent = 0.0;
        for (std::size_t c = 0; c < pixel.squares.size(); c++)
        {
            byHalves += Square(pixel.half[0][c] / a - pixel.half[1][c] / b) * (a * b) / (n * n);
            independent += pixel.own.variance[c] / n;
        }
        noise.push_back({byHalves, independent, Square(independent)});
    }
    noise = MeansAround<2>(noise, area.width);
    std::vector<double> gain;
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        const auto [byHalves, independent, squared] = noise[i];
        const double before = gainByHalves[QuarterOf(i)];
        double around = before;
        if (squared > 0.0)
        {
            const double noisyPixels = 25.0 * Square(independent) / squared;
            around = (noisyPixels * byHalves / independent + lean * before) / (noisyPixels + lean);
        }
        gain.push_back(before > 0.0 ? pixels[i].gain * std::min(1.0, around) / before : 0.0);
    }
    return gain;
}

/// What is known of the pixels, for the reconstruction: the variance of the mean from the samples of a
/// pixel and of those around it in the cell.
std::unique_ptr<const Estimates> Cell::Estimated() const
{
    const bool varied = IsVaried();  // where nothing differs, there is no noise to estimate
    const std::vector<Radiance> variance = varied ? VarianceAround() : std::vector<Radiance>(pixels.size());
    const std::vector<double> gain = varied ? GainAround() : std::vector<double>(pixels.size());
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
        estimates->Set(i % area.width, i / area.width, MeanOf(pixel), halves, gain[i] * noise / pixel.samples);
    }
    estimates->RepeatEdges(area.width, area.height);
    return estimates;
}

/// Whether the first samples met enough for the reconstruction to look at the cell, for itself or for its neighbours.
bool Cell::MeetsEnough(const Neighbours& neighbours) const
{
    double sum = 0.0;
    int count = 0;
    for (const Cell* cell : neighbours)
        if (cell != nullptr)
        {
            sum += cell->metShare;
            count++;
        }
    return mostMet >= kMetShare || (count > 0 && sum >= kMetShare * count);
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
