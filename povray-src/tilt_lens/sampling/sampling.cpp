// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/sampling.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

std::uint32_t SamplingLimits::First() const
{
    std::uint32_t power = 1;
    while (power < min && power < max)
        power *= 2;
    return std::min(power, max);
}

double Allowance::operator()(double unusual) const
{
    // written so that a pixel among those without any noise, 0/0, may keep as much as one among its like
    const double rare = kMost * std::sqrt(std::max(1.0, unusual / kFew));
    const double most = unusual > 1.0 ? std::min({unusual, rare, kMostOfFew}) : 1.0;
    const double least = unusual < 1.0 ? std::max(kLeast, kLeastWhereEven * unusual) : kLeastWhereEven;
    return variance * std::clamp(proportional, least, most);
}

void SamplingAccount::Add(const SamplingAccount& other)
{
    for (const auto& entry : other.pixelsBySamples)
        pixelsBySamples[entry.first] += entry.second;
    variance += other.variance;
    notFinite += other.notFinite;
    aimed += other.aimed;
    rebuilt += other.rebuilt;
    lightPoints += other.lightPoints;
    lightPointsLeft += other.lightPointsLeft;
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

std::uint64_t SamplingAccount::PixelsUpTo(std::uint32_t samples) const
{
    std::uint64_t pixels = 0;
    for (const auto& entry : pixelsBySamples)
        pixels += entry.first <= samples ? entry.second : 0;
    return pixels;
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

} // namespace tilt_lens
