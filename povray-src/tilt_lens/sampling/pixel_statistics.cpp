// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/pixel_statistics.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

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
