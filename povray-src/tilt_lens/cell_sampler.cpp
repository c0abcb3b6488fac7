// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "cell_sampler.h"

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

/// How far the true variance may lie above an estimate from n samples, with probability `confidence`.
double UpperLimit(std::uint32_t n, double confidence)
{
    // the neighbourhood's samples count too: about four pixels' worth
    const double freedom = 4.0 * (n - 1);
    return freedom / boost::math::quantile(boost::math::chi_squared(freedom), 1.0 - confidence);
}

} // namespace

void SamplingAccount::Add(const SamplingAccount& other)
{
    for (const auto& entry : other.pixelsBySamples)
        pixelsBySamples[entry.first] += entry.second;
    variance += other.variance;
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

CellSampler::CellSampler(const SamplingLimits& limits) : limits(limits) {}

void CellSampler::Run(std::uint32_t cellLeft, std::uint32_t cellTop, std::uint32_t cellWidth,
                      std::uint32_t cellHeight, const Tracer& trace)
{
    left = cellLeft;
    top = cellTop;
    width = cellWidth;
    height = cellHeight;
    pixels.assign(std::size_t(width) * height, Pixel());
    for (std::uint32_t until = RoundUp(limits.min, limits.max);; until = std::min(2 * until, limits.max))
    {
        bool any = false;
        for (std::uint32_t i = 0; i < pixels.size(); i++)
            if (pixels[i].open)
            {
                TakeSamples(i, until, trace);
                any = true;
            }
        if (!any)
            return;
        Judge();
        if (until == limits.max)
            return;
    }
}

void CellSampler::TakeSamples(std::uint32_t index, std::uint32_t until, const Tracer& trace)
{
    Pixel& pixel = pixels[index];
    for (std::size_t c = 0; c < pixel.squares.size(); c++)
    {
        pixel.half[0][c] += pixel.half[1][c];
        pixel.half[1][c] = 0.0;
    }
    pixel.middle = pixel.samples == 0 ? until / 2 : pixel.samples;

    SampleId id{left + index % width, top + index / width, 0};
    const PixelSampler sampler(id.x, id.y, 0);
    Radiance value;
    for (id.index = pixel.samples; id.index < until; id.index++)
    {
        trace(id, sampler(id.index), value);
        Radiance& sum = pixel.half[id.index < pixel.middle ? 0 : 1];
        for (std::size_t c = 0; c < value.size(); c++)
        {
            sum[c] += value[c];
            pixel.squares[c] += Square(value[c]);
        }
    }
    pixel.samples = until;
}

/// Closes the pixels that are good enough and notes how good all are.
void CellSampler::Judge()
{
    std::vector<Radiance> variances(pixels.size());
    for (std::size_t i = 0; i < pixels.size(); i++)
        variances[i] = SampleVariance(pixels[i]);
    const double gain = PooledGain();
    for (std::uint32_t i = 0; i < pixels.size(); i++)
    {
        Pixel& pixel = pixels[i];
        if (!pixel.open || pixel.samples < 2)
            continue;
        const Radiance spread = NeighbourhoodVariance(i, variances);
        const Radiance mean = Mean(i % width, i / width);
        const double limit = UpperLimit(pixel.samples, limits.confidence);
        bool good = limits.variance > 0.0;
        pixel.variance = 0.0;
        for (std::size_t c = 0; c < spread.size(); c++)
        {
            const double estimate = gain * spread[c] / pixel.samples;
            // above white an error is seen relative to the brightness
            good = good && estimate * limit <= limits.variance * std::max(1.0, Square(mean[c]));
            pixel.variance = std::max(pixel.variance, estimate);
        }
        pixel.open = !good;
    }
}

Radiance CellSampler::SampleVariance(const Pixel& pixel) const
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
double CellSampler::PooledGain() const
{
    double byHalves = 0.0, independent = 0.0, squared = 0.0;
    for (const Pixel& pixel : pixels)
    {
        if (!pixel.open || pixel.samples < 2)
            continue;
        const double n = pixel.samples, a = pixel.middle, b = n - a;
        const Radiance variance = SampleVariance(pixel);
        double ofPixel = 0.0;
        for (std::size_t c = 0; c < variance.size(); c++)
        {
            byHalves += Square(pixel.half[0][c] / a - pixel.half[1][c] / b) * (a * b) / (n * n);
            ofPixel += variance[c] / n;
        }
        independent += ofPixel;
        squared += Square(ofPixel);
    }
    if (!(independent > 0.0))
        return 1.0;
    const double noisyPixels = Square(independent) / squared, lean = 2.0;
    return std::min(1.0, (noisyPixels * byHalves / independent + lean) / (noisyPixels + lean));
}

/// Variance of one sample: the pixel's own, or the mean around it where that is larger.
Radiance CellSampler::NeighbourhoodVariance(std::uint32_t index, const std::vector<Radiance>& variances) const
{
    const std::uint32_t x = index % width, y = index / width;
    Radiance mean{};
    int count = 0;
    for (std::uint32_t v = y == 0 ? 0 : y - 1; v <= y + 1 && v < height; v++)
        for (std::uint32_t u = x == 0 ? 0 : x - 1; u <= x + 1 && u < width; u++, count++)
            for (std::size_t c = 0; c < mean.size(); c++)
                mean[c] += variances[v * width + u][c];
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = std::max(variances[index][c], mean[c] / count);
    return mean;
}

Radiance CellSampler::Mean(std::uint32_t x, std::uint32_t y) const
{
    const Pixel& pixel = pixels[y * width + x];
    Radiance mean;
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = (pixel.half[0][c] + pixel.half[1][c]) / pixel.samples;
    return mean;
}

std::uint32_t CellSampler::Samples(std::uint32_t x, std::uint32_t y) const
{
    return pixels[y * width + x].samples;
}

double CellSampler::Variance(std::uint32_t x, std::uint32_t y) const
{
    return pixels[y * width + x].variance;
}

} // namespace tilt_lens
