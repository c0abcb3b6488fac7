// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/cell.h"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/chi_squared.hpp>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Few samples tell their variance badly, so it leans towards the mean of the 3 by 3 pixels around: by half after so many,
/// by the square of their number less after more, so that what is even beside noise is not sampled as long.
constexpr double kLean = 4.0;

double Lean(double samples) { return Square(kLean) / (Square(kLean) + Square(samples)); }

/// How far the true variance may lie above an estimate from n samples that leans so, with probability `confidence`.
double UpperLimit(std::uint32_t n, double lean, double confidence)
{
    // what is pooled besides (gain, what is unseen, what the reconstruction leaves) counts too: about four pixels' worth
    const double own = 1.0 - lean + lean / 9.0, others = 8.0 * Square(lean / 9.0);
    const double freedom = 4.0 * (n - 1) / (Square(own) + others);
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

/// Two channels side by side, since compilers leave five of them in five registers.
typedef double Two __attribute__((vector_size(16)));

} // namespace

void Cell::TakeFirst(const SamplingLimits& limits, const Tracer& trace)
{
    const std::lock_guard<std::mutex> lock(busy);
    if (begun)
        return;
    pixels.assign(area.width * area.height, Pixel());  // a step that was broken off begins anew
    first.clear();
    const std::uint32_t until = limits.First();
    met = 0;
    std::array<double, 4> metBy{}, taken{};  // by the quarters of the cell
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            const std::uint64_t before = met;
            TakeSamples(x, y, until, trace);
            metBy[QuarterOf(Index(x, y))] += met - before;
            taken[QuarterOf(Index(x, y))] += until;
            const Pixel& pixel = pixels[Index(x, y)];
            first.push_back({pixel.own, std::sqrt(Worst(pixel.own.variance, MeanOf(pixel))), pixel.blur});
        }
    varied = IsVaried();
    gainByHalves.fill(1.0);
    NoteGain(until);
    metShare = double(met) / until / pixels.size();
    mostMet = 0.0;
    for (std::size_t quarter = 0; quarter < taken.size(); quarter++)
        mostMet = std::max(mostMet, metBy[quarter] / std::max(1.0, taken[quarter]));
    meetsEnough = MeetsEnough({});
    if (IsWorthRebuilding(limits))
        NoteEstimates(until);
    begun = true;
}

void Cell::Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    const std::lock_guard<std::mutex> lock(busy);
    if (done)
        return;
    const std::vector<Pixel> begin = pixels;
    const std::array<double, 4> gainAtBegin = gainByHalves;
    const std::uint64_t metAtBegin = met;
    laterEstimates.reset();
    estimatedSamples = firstEstimates ? limits.First() : 0;
    meetsEnough = firstEstimates || MeetsEnough(neighbours);
    try
    {
        if (limits.variance > 0.0)  // else nobody asks
        {
            NoteBlurred(neighbours);
            NoteUsualDeviation(neighbours);
        }

        std::uint32_t until = limits.First();
        while (Judge(neighbours, limits, until))
        {
            until = std::min(2 * until, limits.max);
            for (std::uint32_t y = area.top; y < area.Bottom(); y++)
                for (std::uint32_t x = area.left; x < area.Right(); x++)
                    TakeMore(x, y, until, trace);
            NoteGain(until);
            OpenAgain(neighbours);
        }
        if (IsWorthRebuilding(limits))
            NoteEstimates(until);
    }
    catch (...)
    {
        pixels = begin;
        gainByHalves = gainAtBegin;
        met = metAtBegin;
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

/// Notes some channels of a sample, from the one numbered `first` on.
template<class Channels>
void Cell::Pixel::Add(const Radiance& value, Radiance& sum, std::size_t first)
{
    const Channels x = Load<Channels>(&value[first]), a = Load<Channels>(&least[first]), b = Load<Channels>(&most[first]);
    Store(&sum[first], Load<Channels>(&sum[first]) + x);
    Store(&squares[first], Load<Channels>(&squares[first]) + x * x);
    Store(&least[first], x < a ? x : a);
    Store(&most[first], x > b ? x : b);
}

/// For a pixel that is open. One that was opened again catches up by the rounds that it left out, so that its halves are as
/// those of others.
void Cell::TakeMore(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace)
{
    const Pixel& pixel = pixels[Index(x, y)];
    while (pixel.open && pixel.samples < until)
        TakeSamples(x, y, std::min(2 * pixel.samples, until), trace);
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
    if (pixel.samples == 0)
    {
        pixel.least.fill(HUGE_VAL);
        pixel.most.fill(-HUGE_VAL);
    }

    SampleId id{x, y, 0};
    Traced traced;
    for (id.index = pixel.samples; id.index < until; id.index++)
    {
        trace(id, traced);
        met += traced.met;
        Radiance& value = traced.light;
        if (!IsLight(value))
        {
            value = Radiance{};
            pixel.notFinite++;
        }
        if (pixel.samples == 0)
            pixel.blur = std::max(pixel.blur, traced.blur);
        Radiance& sum = pixel.half[id.index < pixel.middle ? 0 : 1];
        pixel.Add<Two>(value, sum, 0);
        pixel.Add<Two>(value, sum, 2);
        pixel.Add<double>(value, sum, 4);
        if (traced.sought > 0.0)
        {
            AddTo(pixel.aimed, value);
            pixel.aimedSamples++;
            pixel.sought = traced.sought;
        }
    }
    pixel.samples = until;
    pixel.own = VariationOf(pixel);
}

/// Closes the cell's pixels that are good enough, notes how good the others are, and tells whether
/// any is left that may have more samples.
bool Cell::Judge(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples)
{
    if (samples < 2)
        return samples < limits.max;  // one sample says nothing of its error
    const double lean = Lean(samples), caution = UpperLimit(samples, lean, limits.confidence);
    const Allowance allowed(limits, samples);
    const bool variedAround = IsVariedAround(neighbours);
    std::vector<Judged> judged;
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        Pixel& pixel = pixels[i];
        if (!pixel.open || pixel.samples < samples)
            continue;
        const Radiance mean = MeanOf(pixel);
        Radiance variance{};
        if (variedAround)
        {
            const Variation around = VariationAround(i, neighbours);
            const Radiance unseen = Unseen(pixel, around);
            for (std::size_t c = 0; c < variance.size(); c++)
            {
                const double ofSample = (1.0 - lean) * pixel.own.variance[c] + lean * around.variance[c];
                variance[c] = pixel.gain * (ofSample / samples + unseen[c]) / Brightness(mean[c]);
            }
        }
        pixel.variance = *std::max_element(variance.begin(), variance.end());
        const double unusual = std::sqrt(pixel.variance / pixel.gain * samples) / usualDeviation;
        judged.push_back({&pixel, variance, allowed(unusual) / caution});
    }
    if (IsWorthRebuilding(limits))
        CreditReconstruction(neighbours, limits, samples, judged);

    for (const Judged& one : judged)
    {
        const double left = *std::max_element(one.variance.begin(), one.variance.end());
        one.pixel->open = !(limits.variance > 0.0 && left <= one.allowed && HasSought(*one.pixel, one.allowed));
        one.pixel->allowed = one.allowed;
    }
    return std::any_of(pixels.begin(), pixels.end(), [&limits](const Pixel& pixel)
        { return pixel.open && pixel.samples < limits.max; });
}

Variation Cell::VariationOf(const Pixel& pixel)
{
    Variation own;
    const double n = pixel.samples, aimed = pixel.aimedSamples;
    for (std::size_t c = 0; c < own.variance.size() && n > 1.0; c++)
    {
        const double sum = pixel.half[0][c] + pixel.half[1][c], mean = sum / n;
        double between = Square(sum - pixel.aimed[c]) / (n - aimed);
        if (aimed > 0.0)
            between += Square(pixel.aimed[c]) / aimed;
        own.variance[c] = std::max(0.0, pixel.squares[c] - between) / (n - 1.0);
        own.leap[c] = Square(std::max(pixel.most[c] - mean, mean - pixel.least[c]));
    }
    return own;
}

/// For each quarter: variance of its open pixels' means by their halves, over their variance if samples were
/// independent. Few noisy pixels make the ratio uncertain, so it leans towards what was known
/// before, as if two average pixels more had shown that.
std::array<double, 4> Cell::GainsByHalves() const
{
    std::array<double, 4> byHalves{}, independent{}, squared{};
    for (std::size_t i = 0; i < pixels.size(); i++)
    {
        const Pixel& pixel = pixels[i];
        if (!pixel.open || pixel.samples < 2)
            continue;
        const std::size_t quarter = QuarterOf(i);
        const double n = pixel.samples, a = pixel.middle, b = n - a;
        const Radiance& spread = pixel.own.variance;
        double ofPixel = 0.0;
        for (std::size_t c = 0; c < spread.size(); c++)
        {
            byHalves[quarter] += Square(pixel.half[0][c] / a - pixel.half[1][c] / b) * (a * b) / (n * n);
            ofPixel += spread[c] / n;
        }
        independent[quarter] += ofPixel;
        squared[quarter] += Square(ofPixel);
    }
    std::array<double, 4> gains = gainByHalves;
    for (std::size_t q = 0; q < gains.size(); q++)
        if (independent[q] > 0.0)
        {
            const double noisyPixels = Square(independent[q]) / squared[q], lean = 2.0;
            gains[q] = (noisyPixels * byHalves[q] / independent[q] + lean * gains[q]) / (noisyPixels + lean);
        }
    return gains;
}

/// After a round: how much less than that of independent samples the open pixels' noise is.
void Cell::NoteGain(std::uint32_t samples)
{
    gainByHalves = GainsByHalves();
    std::array<double, 4> gain;
    for (std::size_t quarter = 0; quarter < gain.size(); quarter++)
    {
        gainByHalves[quarter] = std::min(1.0, gainByHalves[quarter]);
        gain[quarter] = GainOfMean(gainByHalves[quarter], std::max(2u, samples));
    }
    for (std::size_t i = 0; i < pixels.size(); i++)
        if (pixels[i].open)
            pixels[i].gain = gain[QuarterOf(i)];
}

Radiance Cell::MeanOf(const Pixel& pixel)
{
    Radiance mean;
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = (pixel.half[0][c] + pixel.half[1][c]) / pixel.samples;
    return mean;
}

} // namespace tilt_lens
