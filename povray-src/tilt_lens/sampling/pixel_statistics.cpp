// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/pixel_statistics.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

namespace
{

void AddOne(const Radiance& value, Radiance& sum, Radiance& allSquares)
{
    for (std::size_t c = 0; c < value.size(); c++)
    {
        sum[c] += value[c];
        allSquares[c] += value[c] * value[c];
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
    if (kernels->addRadiances(results, count, bufferSum.data(), squares.data(), greatestEmission))
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
