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

/// Sums of the channels from number `first` on, held in registers while samples are added.
template<class Channels>
struct ChannelSums
{
    Channels sum, squares;

    TILT_LENS_INLINED void Get(const Radiance& allSum, const Radiance& allSquares, std::size_t first)
    {
        sum = Load<Channels>(&allSum[first]), squares = Load<Channels>(&allSquares[first]);
    }
    TILT_LENS_INLINED void Put(Radiance& allSum, Radiance& allSquares, std::size_t first) const
    {
        Store(&allSum[first], sum), Store(&allSquares[first], squares);
    }
    TILT_LENS_INLINED void Add(const Channels& x)
    {
        sum += x;
        squares += x * x;
    }
};

/// Adds the radiances of a run to a sum and to a sum of squares. Returns false, with nothing added, if any may be infinite or NaN.
template<class Vector>
TILT_LENS_INLINED bool AddRadiances(const SampleResult* results, std::uint32_t count, Radiance& sum, Radiance& allSquares,
                                    double& greatestEmission)
{
    constexpr std::size_t lanes = kVectorWidth<Vector>, vectors = 4 / lanes;
    ChannelSums<Vector> four[vectors];
    ChannelSums<double> last;
    for (std::size_t k = 0; k < vectors; k++)
        four[k].Get(sum, allSquares, k * lanes);
    last.Get(sum, allSquares, 4);
    double expectedEmission = 0.0;
    for (const SampleResult* result = results; result < results + count; result++)
    {
        for (std::size_t k = 0; k < vectors; k++)
            four[k].Add(Load<Vector>(&result->radiance[k * lanes]));
        last.Add(result->radiance[4]);
        expectedEmission = result->expectedEmission > expectedEmission ? result->expectedEmission : expectedEmission;
    }
    // a finite sum of squares has only finite terms
    double squares = last.squares;
    for (std::size_t k = 0; k < 4; k++)
        squares += four[k / lanes].squares[k % lanes];
    if (!std::isfinite(squares))
        return false;
    for (std::size_t k = 0; k < vectors; k++)
        four[k].Put(sum, allSquares, k * lanes);
    last.Put(sum, allSquares, 4);
    greatestEmission = expectedEmission;
    return true;
}

bool AddPlain(const SampleResult* results, std::uint32_t count, Radiance& sum, Radiance& allSquares, double& greatestEmission)
{
    return AddRadiances<Double2>(results, count, sum, allSquares, greatestEmission);
}

TILT_LENS_FOR_AVX2 bool AddByAvx2(const SampleResult* results, std::uint32_t count, Radiance& sum, Radiance& allSquares,
                                  double& greatestEmission)
{
    return AddRadiances<Double4>(results, count, sum, allSquares, greatestEmission);
}

const auto addRadiances = HasAvx2() ? AddByAvx2 : AddPlain;

/// The same for one finite sample, however large.
void AddOne(const Radiance& value, Radiance& sum, Radiance& allSquares)
{
    for (std::size_t c = 0; c < value.size(); c++)
    {
        ChannelSums<double> one;
        one.Get(sum, allSquares, c);
        one.Add(value[c]);
        one.Put(sum, allSquares, c);
    }
}

} // namespace

void PixelStatistics::BeginRound(std::uint32_t until)
{
    AddTo(sum[0], sum[1]);
    sum[1].fill(0.0);
    firstBuffer = samples == 0 ? until / 2 : samples;
}

void PixelStatistics::AddEmitterSample(const SampleResult& result)
{
    if (!(result.expectedEmission > 0.0))
        return;
    AddTo(emitterSum, result.radiance);
    emitterSamples++;
    expectedEmission = result.expectedEmission;
}

void PixelStatistics::AddToBuffer(const SampleResult* results, std::uint32_t count, Radiance& bufferSum)
{
    samples += count;
    double greatestEmission = 0.0;
    if (addRadiances(results, count, bufferSum, squares, greatestEmission))
    {
        for (std::uint32_t i = 0; greatestEmission > 0.0 && i < count; i++)
            AddEmitterSample(results[i]);
        return;
    }
    for (std::uint32_t i = 0; i < count; i++)
    {
        SampleResult result = results[i];
        if (!IsFinite(result.radiance))
        {
            result.radiance = Radiance{};
            notFinite++;
        }
        AddOne(result.radiance, bufferSum, squares);
        AddEmitterSample(result);
    }
}

void PixelStatistics::Add(const SampleResult* results, std::uint32_t count)
{
    const std::uint32_t toFirst = samples < firstBuffer ? std::min(count, firstBuffer - samples) : 0;
    if (toFirst > 0 && toFirst < count)
    {
        AddToBuffer(results, toFirst, sum[0]);
        AddToBuffer(results + toFirst, count - toFirst, sum[1]);
    }
    else
        AddToBuffer(results, count, sum[toFirst > 0 ? 0 : 1]);
}

Radiance PixelStatistics::Variance() const
{
    Radiance variance{};
    const double n = samples, atEmitters = emitterSamples;
    for (std::size_t c = 0; c < variance.size() && n > 1.0; c++)
    {
        double ofMeans = Square(sum[0][c] + sum[1][c] - emitterSum[c]) / (n - atEmitters);
        if (atEmitters > 0.0)
            ofMeans += Square(emitterSum[c]) / atEmitters;
        variance[c] = std::max(0.0, squares[c] - ofMeans) / (n - 1.0);
    }
    return variance;
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
