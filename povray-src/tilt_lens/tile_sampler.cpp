// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tile_sampler.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

namespace tilt_lens
{

namespace
{

/// Least power of two that is not below n, but not above `most`.
std::uint32_t RoundUp(std::uint32_t n, std::uint32_t most)
{
    std::uint32_t power = 1;
    while (power < n && power < most)
        power *= 2;
    return std::min(power, most);
}

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

void SamplingAccount::Add(const SamplingAccount& other)
{
    for (const auto& entry : other.pixelsBySamples)
        pixelsBySamples[entry.first] += entry.second;
    variance += other.variance;
    notFinite += other.notFinite;
}

std::uint64_t SamplingAccount::Pixels() const
{
    std::uint64_t pixels = 0;
    for (const auto& entry : pixelsBySamples)
        pixels += entry.second;
    return pixels;
}

std::uint64_t SamplingAccount::Samples() const
{
    std::uint64_t samples = 0;
    for (const auto& entry : pixelsBySamples)
        samples += entry.first * entry.second;
    return samples;
}

std::uint32_t SamplingAccount::Most() const
{
    return pixelsBySamples.empty() ? 0 : pixelsBySamples.rbegin()->first;
}

std::uint32_t SamplingAccount::Quantile(double share) const
{
    const double wanted = share * Pixels();
    std::uint64_t below = 0;
    for (const auto& entry : pixelsBySamples)
    {
        below += entry.second;
        if (below >= wanted)
            return entry.first;
    }
    return Most();
}

double SamplingAccount::StandardError() const
{
    const std::uint64_t pixels = Pixels();
    return pixels == 0 ? 0.0 : std::sqrt(variance / pixels);
}

TileSampler::TileSampler(const SamplingLimits& limits) : limits(limits) {}

void TileSampler::Run(const Area& wanted, std::uint32_t width, std::uint32_t height, const Tracer& trace)
{
    tile = wanted;
    Area cells{tile.left - tile.left % kCell, tile.top - tile.top % kCell, 0, 0};
    cells.width = std::min(width, (tile.Right() + kCell - 1) / kCell * kCell) - cells.left;
    cells.height = std::min(height, (tile.Bottom() + kCell - 1) / kCell * kCell) - cells.top;

    held.left = cells.left == 0 ? 0 : cells.left - 1;
    held.top = cells.top == 0 ? 0 : cells.top - 1;
    held.width = std::min(width, cells.Right() + 1) - held.left;
    held.height = std::min(height, cells.Bottom() + 1) - held.top;
    pixels.assign(std::size_t(held.width) * held.height, Pixel());

    const std::uint32_t first = RoundUp(limits.min, limits.max);
    for (std::uint32_t y = held.top; y < held.Bottom(); y++)
        for (std::uint32_t x = held.left; x < held.Right(); x++)
        {
            TakeSamples(x, y, first, trace);
            At(x, y).firstSpread = Spread(At(x, y));
        }
    for (std::uint32_t y = cells.top; y < cells.Bottom(); y += kCell)
        for (std::uint32_t x = cells.left; x < cells.Right(); x += kCell)
            RunCell({x, y, std::min(kCell, cells.Right() - x), std::min(kCell, cells.Bottom() - y)}, trace);
}

/// Doubles the samples of the cell's open pixels until none is left or the limit is reached.
void TileSampler::RunCell(const Area& cell, const Tracer& trace)
{
    // first samples only, so once for all rounds
    for (std::uint32_t y = cell.top; y < cell.Bottom(); y++)
        for (std::uint32_t x = cell.left; x < cell.Right(); x++)
            At(x, y).blurredSpread = BlurredSpread(cell, x, y);

    std::uint32_t until = RoundUp(limits.min, limits.max);
    while (Judge(cell, until) && until < limits.max)
    {
        until = std::min(2 * until, limits.max);
        for (std::uint32_t y = cell.top; y < cell.Bottom(); y++)
            for (std::uint32_t x = cell.left; x < cell.Right(); x++)
                if (At(x, y).open)
                    TakeSamples(x, y, until, trace);
    }
}

void TileSampler::TakeSamples(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace)
{
    Pixel& pixel = At(x, y);
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
            pixel.firstBlur = std::max(pixel.firstBlur, traced.blur);
        Radiance& sum = pixel.half[id.index < pixel.middle ? 0 : 1];
        for (std::size_t c = 0; c < value.size(); c++)
        {
            sum[c] += value[c];
            pixel.squares[c] += Square(value[c]);
        }
    }
    pixel.samples = until;
}

/// Closes the cell's pixels that are good enough, notes how good the others are, and tells whether
/// any is left.
bool TileSampler::Judge(const Area& cell, std::uint32_t samples)
{
    if (samples < 2)
        return true;  // one sample says nothing of its error
    const double gain = PooledGain(cell), limit = UpperLimit(samples, limits.confidence);
    std::vector<std::pair<Pixel*, Radiance>> judged;
    for (std::uint32_t y = cell.top; y < cell.Bottom(); y++)
        for (std::uint32_t x = cell.left; x < cell.Right(); x++)
            if (At(x, y).open)
                judged.emplace_back(&At(x, y), NeighbourhoodSpread(cell, x, y));

    bool any = false;
    for (auto& [pixel, spread] : judged)
    {
        const Radiance mean = MeanOf(*pixel);
        bool good = limits.variance > 0.0;
        pixel->variance = 0.0;
        for (std::size_t c = 0; c < spread.size(); c++)
        {
            // above white an error is seen relative to the brightness
            const double estimate = gain * spread[c] / samples / std::max(1.0, Square(mean[c]));
            good = good && estimate * limit <= limits.variance;
            pixel->variance = std::max(pixel->variance, estimate);
        }
        pixel->open = !good;
        any = any || !good;
    }
    return any;
}

Radiance TileSampler::Spread(const Pixel& pixel)
{
    Radiance variance{};
    const double n = pixel.samples;
    for (std::size_t c = 0; c < variance.size() && n > 1.0; c++)
        variance[c] = std::max(0.0, pixel.squares[c] - Square(pixel.half[0][c] + pixel.half[1][c]) / n) / (n - 1.0);
    return variance;
}

/// Variance of the open pixels' means by their halves, over their variance if samples were
/// independent. Few noisy pixels in a cell make the ratio uncertain, so it leans towards 1 as if two
/// average pixels more had shown no gain.
double TileSampler::PooledGain(const Area& cell) const
{
    double byHalves = 0.0, independent = 0.0, squared = 0.0, n = 2.0;
    for (std::uint32_t y = cell.top; y < cell.Bottom(); y++)
        for (std::uint32_t x = cell.left; x < cell.Right(); x++)
        {
            const Pixel& pixel = At(x, y);
            if (!pixel.open)
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
Radiance TileSampler::NeighbourhoodSpread(const Area& cell, std::uint32_t x, std::uint32_t y) const
{
    Radiance spread = Spread(At(x, y)), mean{};
    int count = 0;
    for (std::uint32_t v = y == 0 ? 0 : y - 1; v <= y + 1 && v < held.Bottom(); v++)
        for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < held.Right(); u++, count++)
            AddTo(mean, cell.Has(u, v) ? Spread(At(u, v)) : At(u, v).firstSpread);
    const Radiance& blurred = At(x, y).blurredSpread;
    for (std::size_t c = 0; c < mean.size(); c++)
        spread[c] = std::max(std::max(spread[c], mean[c] / count), blurred[c]);
    return spread;
}

/// Mean variance of one sample in the first round, over the cell and the pixels beside it, of what is
/// blurred far enough to lie over this pixel too: a point covers all pixels within its blur's radius,
/// so two pixels that see it are at most twice that apart.
Radiance TileSampler::BlurredSpread(const Area& cell, std::uint32_t x, std::uint32_t y) const
{
    Radiance mean{};
    int count = 0;
    for (std::uint32_t v = std::max(cell.top, held.top + 1) - 1; v < std::min(cell.Bottom() + 1, held.Bottom()); v++)
        for (std::uint32_t u = std::max(cell.left, held.left + 1) - 1; u < std::min(cell.Right() + 1, held.Right());
             u++, count++)
        {
            const Pixel& other = At(u, v);
            const double apart = std::max(std::fabs(double(u) - x), std::fabs(double(v) - y));
            if (apart <= 2.0 * other.firstBlur)
                AddTo(mean, other.firstSpread);
        }
    for (double& channel : mean)
        channel /= count;
    return mean;
}

Radiance TileSampler::MeanOf(const Pixel& pixel)
{
    Radiance mean;
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = (pixel.half[0][c] + pixel.half[1][c]) / pixel.samples;
    return mean;
}

Radiance TileSampler::Mean(std::uint32_t x, std::uint32_t y) const { return MeanOf(At(x, y)); }

std::uint32_t TileSampler::Samples(std::uint32_t x, std::uint32_t y) const { return At(x, y).samples; }

double TileSampler::Variance(std::uint32_t x, std::uint32_t y) const { return At(x, y).variance; }

SamplingAccount TileSampler::Account() const
{
    SamplingAccount account;
    for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
        for (std::uint32_t x = tile.left; x < tile.Right(); x++)
        {
            const Pixel& pixel = At(x, y);
            account.pixelsBySamples[pixel.samples]++;
            account.variance += pixel.variance;
            account.notFinite += pixel.notFinite;
        }
    return account;
}

} // namespace tilt_lens
