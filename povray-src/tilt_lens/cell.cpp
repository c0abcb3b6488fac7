// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "cell.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

namespace tilt_lens
{

namespace
{

/// Samples aimed at emitters that must have missed before they are believed hidden: an object fills only
/// part of the sphere around it, and that may lie over two pixels.
constexpr std::uint32_t kFewestAimed = 16;

/// Own samples that a pixel needs until they count as much as what is seen around it.
constexpr double kDoubts = 32.0;

double Square(double x) { return x * x; }

/// How far the true variance may lie above an estimate from n samples, with probability `confidence`.
double UpperLimit(std::uint32_t n, double confidence)
{
    // the neighbourhood's samples count too: about four pixels' worth
    const double freedom = 4.0 * (n - 1);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

/// The largest channel of variances, each relative to its brightness.
double Worst(const Radiance& variance, const Radiance& mean)
{
    double worst = 0.0;
    for (std::size_t c = 0; c < variance.size(); c++)
        worst = std::max(worst, variance[c] / Brightness(mean[c]));
    return worst;
}

/// What the halves' difference says of the mean of both. With a variance of n^-a, a >= 1, the halves
/// of a prefix of n differ by 2^a - 1 times the variance of their mean; and a gain that began at 1 is
/// n^(1 - a). The two together have one solution, found by iteration.
double GainOfMean(double gainByHalves, double n)
{
    double gain = std::min(1.0, gainByHalves);
    for (int i = 0; i < 4 && gain > 0.0; i++)
        gain = std::min(1.0, gainByHalves / (std::exp2(1.0 - std::log(gain) / std::log(n)) - 1.0));
    return gain;
}

} // namespace

const Cell* Holder(const Cell::Neighbours& neighbours, std::int64_t x, std::int64_t y)
{
    const Area& area = neighbours[4]->area;
    const int column = x < area.left ? 0 : x < area.Right() ? 1 : 2;
    const int row = y < area.top ? 0 : y < area.Bottom() ? 1 : 2;
    return neighbours[3 * row + column];
}

void Cell::TakeFirst(const SamplingLimits& limits, const Tracer& trace)
{
    const std::lock_guard<std::mutex> lock(busy);
    if (begun)
        return;
    pixels.assign(area.width * area.height, Pixel());  // a step that was broken off begins anew
    first.clear();
    const std::uint32_t until = limits.First();
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            TakeSamples(x, y, until, trace);
            const Pixel& pixel = pixels[Index(x, y)];
            first.push_back({pixel.spread, std::sqrt(Worst(pixel.spread, MeanOf(pixel))), pixel.blur});
        }
    gainByHalves = 1.0;
    NoteGain(until);
    if (limits.Denoises())
        firstEstimates = Estimates();
    begun = true;
}

void Cell::Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    const std::lock_guard<std::mutex> lock(busy);
    if (done)
        return;
    const std::vector<Pixel> begin = pixels;
    const double gainAtBegin = gainByHalves;
    laterEstimates.clear();
    try
    {
        if (limits.variance > 0.0)  // else nobody asks
        {
            SpreadBlurred(neighbours);
            NoteUsualDeviation(neighbours);
        }

        std::uint32_t until = limits.First();
        while (Judge(neighbours, limits, until) && until < limits.max)
        {
            until = std::min(2 * until, limits.max);
            for (std::uint32_t y = area.top; y < area.Bottom(); y++)
                for (std::uint32_t x = area.left; x < area.Right(); x++)
                    if (pixels[Index(x, y)].open)
                        TakeSamples(x, y, until, trace);
            NoteGain(until);
        }
    }
    catch (...)
    {
        pixels = begin;
        gainByHalves = gainAtBegin;
        throw;
    }
    for (const Pixel& pixel : pixels)
        final.push_back({pixel.variance, MeanOf(pixel), pixel.samples, pixel.notFinite, pixel.aimedSamples});
    pixels = std::vector<Pixel>();
    done = true;
}

/// What is usual around decides who may keep more than `variance`: not all can.
void Cell::NoteUsualDeviation(const Neighbours& neighbours)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (const Cell* cell : neighbours)
        if (cell != nullptr)
        {
            for (const First& pixel : cell->first)
                sum += pixel.deviation;
            count += cell->first.size();
        }
    usualDeviation = sum / count;
}

void Cell::TakeSamples(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace)
{
    Pixel& pixel = pixels[Index(x, y)];
    for (std::size_t c = 0; c < pixel.squares.size(); c++)
    {
        pixel.half[0][c] += pixel.half[1][c];
        pixel.half[1][c] = 0.0;
    }
    pixel.middle = pixel.samples == 0 ? until / 2 : pixel.samples;

    SampleId id{x, y, 0};
    const PixelSampler sampler(x, y, 0);
    Traced traced;
    for (id.index = pixel.samples; id.index < until; id.index++)
    {
        trace(id, sampler(id.index), traced);
        Radiance& value = traced.light;
        if (!IsLight(value))
        {
            value = Radiance{};
            pixel.notFinite++;
        }
        if (pixel.samples == 0)
            pixel.blur = std::max(pixel.blur, traced.blur);
        Radiance& sum = pixel.half[id.index < pixel.middle ? 0 : 1];
        for (std::size_t c = 0; c < value.size(); c++)
        {
            sum[c] += value[c];
            pixel.squares[c] += Square(value[c]);
        }
        if (traced.aimed)
        {
            AddTo(pixel.aimed, value);
            pixel.aimedSamples++;
        }
    }
    pixel.samples = until;
    pixel.spread = Spread(pixel);
}

/// Closes the cell's pixels that are good enough, notes how good the others are, and tells whether
/// any is left.
bool Cell::Judge(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples)
{
    if (samples < 2)
        return true;  // one sample says nothing of its error
    const double caution = UpperLimit(samples, limits.confidence);
    const std::vector<Radiance> around = SpreadAround(neighbours);
    std::vector<Judged> judged;
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        Pixel& pixel = pixels[i];
        if (!pixel.open)
            continue;
        Radiance variance = DoubtedSpread(pixel, around[i]);
        const Radiance mean = MeanOf(pixel);
        const double unusual = std::sqrt(Worst(variance, mean)) / usualDeviation;
        for (std::size_t c = 0; c < variance.size(); c++)
            variance[c] *= pixel.gain / samples / Brightness(mean[c]);
        pixel.variance = *std::max_element(variance.begin(), variance.end());
        judged.push_back({&pixel, variance, limits.Allowed(samples, unusual) / caution});
    }
    if (limits.Denoises())
    {
        if (samples > limits.First())
            laterEstimates = Estimates();
        CreditReconstruction(neighbours, judged);
    }

    bool any = false;
    for (const Judged& one : judged)
    {
        const double left = *std::max_element(one.variance.begin(), one.variance.end());
        const std::uint32_t aimed = one.pixel->aimedSamples;
        const bool tried = aimed == 0 || aimed >= kFewestAimed;
        one.pixel->open = !(limits.variance > 0.0 && left <= one.allowed && tried);
        any = any || one.pixel->open;
    }
    return any;
}

Radiance Cell::Spread(const Pixel& pixel)
{
    Radiance variance{};
    const double n = pixel.samples, aimed = pixel.aimedSamples;
    for (std::size_t c = 0; c < variance.size() && n > 1.0; c++)
    {
        const double sum = pixel.half[0][c] + pixel.half[1][c];
        double between = Square(sum - pixel.aimed[c]) / (n - aimed);
        if (aimed > 0.0)
            between += Square(pixel.aimed[c]) / aimed;
        variance[c] = std::max(0.0, pixel.squares[c] - between) / (n - 1.0);
    }
    return variance;
}

/// Variance of the open pixels' means by their halves, over their variance if samples were
/// independent. Few noisy pixels in a cell make the ratio uncertain, so it leans towards what was known
/// before, as if two average pixels more had shown that.
double Cell::GainByHalves(double before) const
{
    double byHalves = 0.0, independent = 0.0, squared = 0.0;
    for (const Pixel& pixel : pixels)
    {
        if (!pixel.open || pixel.samples < 2)
            continue;
        const double n = pixel.samples, a = pixel.middle, b = n - a;
        const Radiance& spread = pixel.spread;
        double ofPixel = 0.0;
        for (std::size_t c = 0; c < spread.size(); c++)
        {
            byHalves += Square(pixel.half[0][c] / a - pixel.half[1][c] / b) * (a * b) / (n * n);
            ofPixel += spread[c] / n;
        }
        independent += ofPixel;
        squared += Square(ofPixel);
    }
    if (!(independent > 0.0))
        return before;
    const double noisyPixels = Square(independent) / squared, lean = 2.0;
    return (noisyPixels * byHalves / independent + lean * before) / (noisyPixels + lean);
}

/// After a round: how much less than that of independent samples the open pixels' noise is.
void Cell::NoteGain(std::uint32_t samples)
{
    gainByHalves = std::min(1.0, GainByHalves(gainByHalves));
    const double gain = GainOfMean(gainByHalves, std::max(2u, samples));
    for (Pixel& pixel : pixels)
        if (pixel.open)
            pixel.gain = gain;
}

/// Mean variance of one sample over the 3 by 3 pixels around each of the cell's. Pixels outside the cell count by
/// their first samples, where there are neighbours.
std::vector<Radiance> Cell::SpreadAround(const Neighbours& neighbours) const
{
    const std::int64_t width = area.width, height = area.height;
    std::array<std::array<Radiance, kCell>, kCell + 2> rows{};  // sums of three pixels side by side
    for (std::int64_t v = -1; v <= height; v++)
    {
        std::array<Radiance, kCell + 2> row{};
        for (std::int64_t u = -1; u <= width; u++)
        {
            if (u >= 0 && u < width && v >= 0 && v < height)
                row[u + 1] = pixels[v * width + u].spread;
            else if (const Cell* holder = Holder(neighbours, area.left + u, area.top + v))
                row[u + 1] = holder->FirstOf(area.left + u, area.top + v).spread;
        }
        for (std::int64_t u = 0; u < width; u++)
            for (std::size_t c = 0; c < row[u].size(); c++)
                rows[v + 1][u][c] = row[u][c] + row[u + 1][c] + row[u + 2][c];
    }
    std::vector<Radiance> around(pixels.size());
    for (std::int64_t y = 0; y < height; y++)
        for (std::int64_t x = 0; x < width; x++)
        {
            const int columns = 1 + (x > 0 || neighbours[3]) + (x + 1 < width || neighbours[5]);
            const int lines = 1 + (y > 0 || neighbours[1]) + (y + 1 < height || neighbours[7]);
            Radiance& mean = around[y * width + x];
            for (std::size_t c = 0; c < mean.size(); c++)
                mean[c] = (rows[y][x][c] + rows[y + 1][x][c] + rows[y + 2][x][c]) / (columns * lines);
        }
    return around;
}

/// Variance of one sample: the pixel's own, or, as long as its samples are few, towards the mean around it
/// where that is larger.
Radiance Cell::DoubtedSpread(const Pixel& pixel, const Radiance& around)
{
    Radiance spread = pixel.spread;
    const double doubt = kDoubts / (kDoubts + pixel.samples);
    for (std::size_t c = 0; c < spread.size(); c++)
        spread[c] += doubt * std::max(0.0, std::max(around[c], pixel.blurredSpread[c]) - spread[c]);
    return spread;
}

/// Notes for each pixel the mean variance of one sample in the first round, over the cell and the pixels
/// beside it, of what is blurred far enough to lie over this pixel too: a point covers all pixels within
/// its blur's radius, so two pixels that see it are at most twice that apart.
void Cell::SpreadBlurred(const Neighbours& neighbours)
{
    Radiance everywhere{};  // of what is blurred over the whole cell
    int count = 0;
    for (std::int64_t v = std::int64_t(area.top) - 1; v <= area.Bottom(); v++)
        for (std::int64_t u = std::int64_t(area.left) - 1; u <= area.Right(); u++)
        {
            const Cell* holder = Holder(neighbours, u, v);
            if (holder == nullptr || !holder->area.Has(u, v))
                continue;
            count++;
            const First& other = holder->FirstOf(u, v);
            if (2.0 * other.blur >= kCell)
                AddTo(everywhere, other.spread);
            else
                SpreadOver(u, v, 2.0 * other.blur, other.spread);
        }
    for (Pixel& pixel : pixels)
        for (std::size_t c = 0; c < everywhere.size(); c++)
            pixel.blurredSpread[c] = (pixel.blurredSpread[c] + everywhere[c]) / count;
}

/// Adds to the cell's pixels that are no farther from (x, y) than `reach` columns and rows.
void Cell::SpreadOver(std::int64_t x, std::int64_t y, double reach, const Radiance& spread)
{
    if (std::all_of(spread.begin(), spread.end(), [](double channel) { return channel == 0.0; }))
        return;
    const std::int64_t most = std::int64_t(reach);
    for (std::int64_t v = std::max<std::int64_t>(area.top, y - most); v <= y + most && v < area.Bottom(); v++)
        for (std::int64_t u = std::max<std::int64_t>(area.left, x - most); u <= x + most && u < area.Right(); u++)
            AddTo(pixels[Index(u, v)].blurredSpread, spread);
}

Radiance Cell::MeanOf(const Pixel& pixel)
{
    Radiance mean;
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = (pixel.half[0][c] + pixel.half[1][c]) / pixel.samples;
    return mean;
}

} // namespace tilt_lens
