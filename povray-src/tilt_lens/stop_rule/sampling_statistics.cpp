// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/sampling_statistics.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

void SamplingStatistics::Add(const SamplingStatistics& other)
{
    for (const auto& entry : other.pixelsBySamples)
        pixelsBySamples[entry.first] += entry.second;
    variance += other.variance;
    risk += other.risk;
    notFinite += other.notFinite;
    emitterSampled += other.emitterSampled;
    reconstructed += other.reconstructed;
    lightPoints += other.lightPoints;
    lightPointsSkipped += other.lightPointsSkipped;
    refusedRays += other.refusedRays;
}

std::uint64_t SamplingStatistics::Pixels() const
{
    std::uint64_t pixels = 0;
    for (const auto& entry : pixelsBySamples)
        pixels += entry.second;
    return pixels;
}

std::uint64_t SamplingStatistics::Samples() const
{
    std::uint64_t samples = 0;
    for (const auto& entry : pixelsBySamples)
        samples += entry.first * entry.second;
    return samples;
}

std::uint64_t SamplingStatistics::PixelsUpTo(std::uint32_t samples) const
{
    std::uint64_t pixels = 0;
    for (const auto& entry : pixelsBySamples)
        pixels += entry.first <= samples ? entry.second : 0;
    return pixels;
}

std::uint32_t SamplingStatistics::Most() const
{
    return pixelsBySamples.empty() ? 0 : pixelsBySamples.rbegin()->first;
}

std::uint32_t SamplingStatistics::Quantile(double share) const
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

double SamplingStatistics::StandardError() const
{
    const std::uint64_t pixels = Pixels();
    return pixels == 0 ? 0.0 : std::sqrt(std::max(variance, risk) / pixels);
}

} // namespace tilt_lens
