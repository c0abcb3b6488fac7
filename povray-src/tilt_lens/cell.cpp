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

double Square(double x) { return x * x; }

bool IsLight(const Radiance& value)
{
    return std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
}

/// How far the true variance may lie above an estimate from n samples, with probability `confidence`.
double UpperLimit(std::uint32_t n, double confidence)
{
    // the neighbourhood's samples count too: about four pixels' worth
    const double freedom = 4.0 * (n - 1);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

/// Whether a pixel's noise is less than half of its brightness.
bool IsKnown(const Estimate& estimate)
{
    double noise = 0.0, light = 0.0;
    for (std::size_t c = 0; c < estimate.mean.size(); c++)
    {
        noise += estimate.variance[c];
        light += Square(estimate.mean[c]);
    }
    return noise <= 0.25 * light;
}

void AddTo(Radiance& sum, const Radiance& value)
{
    for (std::size_t c = 0; c < sum.size(); c++)
        sum[c] += value[c];
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
            first.push_back({Spread(pixel), pixel.blur});
        }
    if (limits.Denoises())
    {
        const double gain = PooledGain();
        for (Pixel& pixel : pixels)
            pixel.gain = gain;
        firstEstimates = Estimates();
    }
    begun = true;
}

void Cell::Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    const std::lock_guard<std::mutex> lock(busy);
    if (done)
        return;
    const std::vector<Pixel> begin = pixels;
    try
    {
        if (limits.variance > 0.0)  // else nobody asks
            SpreadBlurred(neighbours);

        std::uint32_t until = limits.First();
        while (Judge(neighbours, limits, until) && until < limits.max)
        {
            until = std::min(2 * until, limits.max);
            for (std::uint32_t y = area.top; y < area.Bottom(); y++)
                for (std::uint32_t x = area.left; x < area.Right(); x++)
                    if (pixels[Index(x, y)].open)
                        TakeSamples(x, y, until, trace);
        }
    }
    catch (...)
    {
        pixels = begin;
        throw;
    }
    for (const Pixel& pixel : pixels)
        final.push_back({pixel.variance, MeanOf(pixel), pixel.samples, pixel.notFinite, pixel.aimedSamples});
    if (limits.Denoises())
        finalEstimates = Estimates();
    pixels = std::vector<Pixel>();
    done = true;
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
}

/// Closes the cell's pixels that are good enough, notes how good the others are, and tells whether
/// any is left.
bool Cell::Judge(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples)
{
    if (samples < 2)
        return true;  // one sample says nothing of its error
    const double gain = PooledGain(), allowed = limits.variance / UpperLimit(samples, limits.confidence);
    std::vector<Judged> judged;
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            Pixel& pixel = pixels[Index(x, y)];
            if (!pixel.open)
                continue;
            pixel.gain = gain;
            judged.push_back({&pixel, NeighbourhoodSpread(neighbours, x, y)});
            Radiance& variance = judged.back().variance;
            const Radiance mean = MeanOf(pixel);
            for (std::size_t c = 0; c < variance.size(); c++)
                // above white an error is seen relative to the brightness
                variance[c] *= gain / samples / std::max(1.0, Square(mean[c]));
            pixel.variance = *std::max_element(variance.begin(), variance.end());
        }
    if (limits.Denoises())
        CreditReconstruction(neighbours, allowed, judged);

    bool any = false;
    for (const Judged& one : judged)
    {
        const double left = *std::max_element(one.variance.begin(), one.variance.end());
        const std::uint32_t aimed = one.pixel->aimedSamples;
        const bool tried = aimed == 0 || aimed >= kFewestAimed;
        one.pixel->open = !(limits.variance > 0.0 && left <= allowed && tried);
        any = any || one.pixel->open;
    }
    return any;
}

/// Takes from the variances of pixels what the reconstruction will take: of what their own samples
/// show, not of what is only feared because neighbours saw it.
void Cell::CreditReconstruction(const Neighbours& neighbours, double allowed, std::vector<Judged>& judged) const
{
    const std::vector<Estimate> estimates = Estimates();
    const auto credited = [&](const Judged& one, std::size_t c, double share)
    {
        // a few hits of something bright say little of how often it is hit
        if (!IsKnown(estimates[one.pixel - pixels.data()]))
            return one.variance[c];
        const double brightness = std::max(1.0, Square(estimates[one.pixel - pixels.data()].mean[c]));
        const double seen = estimates[one.pixel - pixels.data()].variance[c] / brightness;
        return one.variance[c] - share * std::min(seen, one.variance[c]);
    };
    // only where it makes a difference
    const bool matters = std::any_of(judged.begin(), judged.end(), [&](const Judged& one)
    {
        bool good = true, canBeGood = true;
        for (std::size_t c = 0; c < one.variance.size(); c++)
        {
            good = good && one.variance[c] <= allowed;
            canBeGood = canBeGood && credited(one, c, 1.0 - kLeastRemains) <= allowed;
        }
        return !good && canBeGood;
    });
    if (!matters)
        return;
    const std::array<float, kCell * kCell> remains = Remains(neighbours, estimates);
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
    std::vector<Radiance> spread;
    for (const Pixel& pixel : pixels)
        spread.push_back(Spread(pixel));
    for (std::uint32_t y = 0; y < area.height; y++)
        for (std::uint32_t x = 0; x < area.width; x++)
        {
            Radiance sum{};
            int count = 0;
            for (std::uint32_t v = y == 0 ? 0 : y - 1; v <= y + 1 && v < area.height; v++)
                for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < area.width; u++, count++)
                    AddTo(sum, spread[v * area.width + u]);
            const Pixel& pixel = pixels[y * area.width + x];
            const Radiance mean = MeanOf(pixel);
            Estimate& estimate = estimates[y * area.width + x];
            estimate.samples = pixel.samples;
            for (std::size_t c = 0; c < sum.size(); c++)
            {
                estimate.mean[c] = mean[c];
                estimate.variance[c] = pixel.gain * sum[c] / count / pixel.samples;
                if (pixel.samples > 1)
                    estimate.halves[c] = pixel.half[0][c] / pixel.middle - pixel.half[1][c] / (pixel.samples - pixel.middle);
            }
        }
    return estimates;
}

/// What share of the pixels' variances the reconstruction will leave, as far as the first samples of
/// the neighbours tell.
std::array<float, kCell * kCell> Cell::Remains(const Neighbours& neighbours, const std::vector<Estimate>& own) const
{
    Surroundings around;
    for (int y = -Surroundings::kBorder; y < int(kCell) + Surroundings::kBorder; y++)
        for (int x = -Surroundings::kBorder; x < int(kCell) + Surroundings::kBorder; x++)
        {
            const std::int64_t u = std::int64_t(area.left) + x, v = std::int64_t(area.top) + y;
            const Cell* holder = Holder(neighbours, u, v);
            if (holder == this)
                around.Set(x, y, own[Index(u, v)]);
            else if (holder != nullptr && holder->area.Has(u, v))
                around.Set(x, y, holder->FirstEstimate(u, v));
        }
    if (around.Noiseless())
    {
        std::array<float, kCell * kCell> all;
        all.fill(1.0f);
        return all;
    }
    return Rebuild(around, false).remains;
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
/// independent. Few noisy pixels in a cell make the ratio uncertain, so it leans towards 1 as if two
/// average pixels more had shown no gain.
double Cell::PooledGain() const
{
    double byHalves = 0.0, independent = 0.0, squared = 0.0, n = 2.0;
    for (const Pixel& pixel : pixels)
    {
        if (!pixel.open || pixel.samples < 2)
            continue;
        n = pixel.samples;
        const double a = pixel.middle, b = n - a;
        const Radiance spread = Spread(pixel);
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
        return 1.0;
    const double noisyPixels = Square(independent) / squared, lean = 2.0;
    return GainOfMean((noisyPixels * byHalves / independent + lean) / (noisyPixels + lean), n);
}

/// Variance of one sample: the pixel's own, or the mean around it where that is larger. Neighbours
/// outside the cell count by their first samples.
Radiance Cell::NeighbourhoodSpread(const Neighbours& neighbours, std::uint32_t x, std::uint32_t y) const
{
    const Pixel& pixel = pixels[Index(x, y)];
    Radiance spread = Spread(pixel), mean{};
    int count = 0;
    for (std::int64_t v = std::int64_t(y) - 1; v <= std::int64_t(y) + 1; v++)
        for (std::int64_t u = std::int64_t(x) - 1; u <= std::int64_t(x) + 1; u++)
        {
            const Cell* holder = Holder(neighbours, u, v);
            if (holder == nullptr || !holder->area.Has(u, v))
                continue;
            AddTo(mean, holder == this ? Spread(pixels[Index(u, v)]) : holder->FirstOf(u, v).spread);
            count++;
        }
    for (std::size_t c = 0; c < mean.size(); c++)
        spread[c] = std::max(std::max(spread[c], mean[c] / count), pixel.blurredSpread[c]);
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
