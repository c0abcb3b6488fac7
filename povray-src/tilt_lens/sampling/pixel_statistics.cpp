// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/pixel_statistics.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// What is summed of some channels, from the one numbered `first` on; it stays in registers while samples are added.
template<class Channels>
struct ChannelSums
{
    Channels sum, squares, least, most;

    void Add(const Radiance& value, std::size_t first)
    {
        const Channels x = Load<Channels>(&value[first]);
        sum += x;
        squares += x * x;
        least = x < least ? x : least;
        most = x > most ? x : most;
    }
};

} // namespace

void SampleVariation::Merge(const SampleVariation& other)
{
    for (std::size_t c = 0; c < variance.size(); c++)
    {
        variance[c] += other.variance[c];
        maxSquaredDeviation[c] = std::max(maxSquaredDeviation[c], other.maxSquaredDeviation[c]);
    }
}

void PixelStatistics::BeginRound(std::uint32_t until)
{
    AddTo(sum[0], sum[1]);
    sum[1].fill(0.0);
    roundBegin = samples;
    firstBuffer = samples == 0 ? until / 2 : samples;
    if (samples == 0)
    {
        least.fill(HUGE_VAL);
        most.fill(-HUGE_VAL);
    }
}

/// Adds to sums, squares and extremes, three channels after two.
/// @param checked  whether all samples are finite; if not and one may be none, changes nothing and returns false
bool PixelStatistics::AddRadiances(const SampleResult* results, std::uint32_t count, Radiance& bufferSum, bool checked)
{
    const auto load = [&](auto& sums, std::size_t first)
    {
        using Channels = decltype(sums.sum);
        sums = {Load<Channels>(&bufferSum[first]), Load<Channels>(&squares[first]), Load<Channels>(&least[first]),
                Load<Channels>(&most[first])};
    };
    const auto store = [&](const auto& sums, std::size_t first)
    {
        Store(&bufferSum[first], sums.sum);
        Store(&squares[first], sums.squares);
        Store(&least[first], sums.least);
        Store(&most[first], sums.most);
    };
    ChannelSums<Double2> redGreen, blueFilter;
    ChannelSums<double> transmit;
    load(redGreen, 0);
    load(blueFilter, 2);
    load(transmit, 4);
    for (std::uint32_t i = 0; i < count; i++)
    {
        redGreen.Add(results[i].radiance, 0);
        blueFilter.Add(results[i].radiance, 2);
        transmit.Add(results[i].radiance, 4);
    }
    // a sum of squares that was and stays finite has got finite ones only
    const Double2 four = redGreen.squares + blueFilter.squares;
    if (!checked && !std::isfinite(four[0] + four[1] + transmit.squares))
        return false;
    store(redGreen, 0);
    store(blueFilter, 2);
    store(transmit, 4);
    samples += count;
    return true;
}

/// A sample that may be infinite or no number.
void PixelStatistics::AddOne(const SampleResult& result, Radiance& bufferSum)
{
    SampleResult finite = result;
    if (!IsFinite(result.radiance))
    {
        finite.radiance = Radiance{};
        notFinite++;
    }
    AddRadiances(&finite, 1, bufferSum, true);
    if (result.expectedEmission > 0.0)
        AddTo(emitterSum, finite.radiance);
}

void PixelStatistics::AddToBuffer(const SampleResult* results, std::uint32_t count, Radiance& bufferSum)
{
    const bool finite = AddRadiances(results, count, bufferSum, false);
    for (std::uint32_t i = 0; i < count; i++)
    {
        if (!finite)
            AddOne(results[i], bufferSum);
        if (!(results[i].expectedEmission > 0.0))
            continue;
        if (finite)
            AddTo(emitterSum, results[i].radiance);
        emitterSamples++;
        expectedEmission = results[i].expectedEmission;
    }
}

void PixelStatistics::Add(const SampleResult* results, std::uint32_t count)
{
    if (roundBegin == 0)
        for (std::uint32_t i = 0; i < count; i++)
            blurRadius = std::max(blurRadius, results[i].blurRadius);
    const std::uint32_t toFirst = samples < firstBuffer ? std::min(count, firstBuffer - samples) : 0;
    if (toFirst > 0)
        AddToBuffer(results, toFirst, sum[0]);
    if (count > toFirst)
        AddToBuffer(results + toFirst, count - toFirst, sum[1]);
}

/// The variance of one sample, where a fixed share of them is sent at emitters: only differences among these and among the
/// others count.
void PixelStatistics::EndRound()
{
    variation = SampleVariation();
    const double n = samples, atEmitters = emitterSamples;
    for (std::size_t c = 0; c < squares.size() && n > 1.0; c++)
    {
        const double all = sum[0][c] + sum[1][c], mean = all / n;
        double ofMeans = Square(all - emitterSum[c]) / (n - atEmitters);
        if (atEmitters > 0.0)
            ofMeans += Square(emitterSum[c]) / atEmitters;
        variation.variance[c] = std::max(0.0, squares[c] - ofMeans) / (n - 1.0);
        variation.maxSquaredDeviation[c] = Square(std::max(most[c] - mean, mean - least[c]));
    }
}

Radiance PixelStatistics::Mean() const
{
    Radiance mean;
    for (std::size_t c = 0; c < mean.size(); c++)
        mean[c] = (sum[0][c] + sum[1][c]) / samples;
    return mean;
}

Radiance PixelStatistics::DualBufferDifference() const
{
    Radiance difference;
    for (std::size_t c = 0; c < difference.size(); c++)
        difference[c] = sum[0][c] / firstBuffer - sum[1][c] / (samples - firstBuffer);
    return difference;
}

} // namespace tilt_lens
