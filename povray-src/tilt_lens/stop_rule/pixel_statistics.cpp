// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/pixel_statistics.h"

#include <algorithm>
#include <iterator>

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

void PixelStatistics::BeginRound(std::uint32_t until)
{
    for (std::size_t c = 0; c < std::size(sum[0]); c++)
    {
        sum[0][c] += sum[1][c];
        sum[1][c] = 0.0;
    }
    firstBuffer = samples == 0 ? until / 2 : samples;
}

void PixelStatistics::AddStratum(const SampleResult* results, std::uint32_t ofFirstBuffer, std::uint32_t count, bool emitters)
{
    if (kernels->addRadiances(results, ofFirstBuffer, count, emitters, *this))
        return;
    for (std::uint32_t i = 0; i < count; i++)
    {
        SampleResult result = results[i];
        if ((result.expectedEmission > 0.0) != emitters)
            continue;
        if (!IsFinite(result.radiance))
        {
            result.radiance = Radiance{};
            notFinite++;
        }
        kernels->addRadiances(&result, i < ofFirstBuffer, 1, emitters, *this);
    }
}

void PixelStatistics::Add(const SampleResult* results, std::uint32_t count)
{
    const std::uint32_t after = samples + count, ofFirstBuffer = samples < firstBuffer ? std::min(count, firstBuffer - samples) : 0;
    AddStratum(results, ofFirstBuffer, count, false);
    if (samples < after)
        AddStratum(results, ofFirstBuffer, count, true);
}

Radiance PixelStatistics::Variance() const
{
    Radiance variance{};
    const double n = samples, correction = n / (n - 1.0);
    for (std::size_t c = 0; c < variance.size() && samples > 1; c++)
        variance[c] = correction * Square(deviation[c]);
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
