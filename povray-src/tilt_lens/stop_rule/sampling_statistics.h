// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampling_statistics.h
/// Cost and quality of pixels, for the report after a render.

#ifndef TILT_LENS_SAMPLING_STATISTICS_H
#define TILT_LENS_SAMPLING_STATISTICS_H

#include <cstdint>
#include <map>

namespace tilt_lens
{

struct SamplingStatistics
{
    std::map<std::uint32_t, std::uint64_t> pixelsBySamples;
    double variance = 0.0;                                   ///< sum over the pixels, mean of the colours
    double risk = 0.0;                                       ///< the same, bias included; chance may make it smaller
    std::uint64_t notFinite = 0;
    std::uint64_t emitterSampled = 0;
    std::uint64_t reconstructed = 0;
    std::uint64_t lightPoints = 0;                           ///< sampled points of area lights
    std::uint64_t lightPointsSkipped = 0;                    ///< of these
    std::uint64_t refusedRays = 0;                           ///< blocked by a glass lens, of all tried

    void Add(const SamplingStatistics& other);
    std::uint64_t Pixels() const;
    std::uint64_t Samples() const;
    std::uint64_t PixelsUpTo(std::uint32_t samples) const;
    std::uint32_t Most() const;
    std::uint32_t Quantile(double share) const;
    /// Root of the pixels' mean square error: of the noise, or of noise and bias if this is more.
    double StandardError() const;
};

} // namespace tilt_lens

#endif
