// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampling_statistics.h
/// What a set of pixels cost and how good they are: the numbers of the report after a render.

#ifndef TILT_LENS_SAMPLING_STATISTICS_H
#define TILT_LENS_SAMPLING_STATISTICS_H

#include <cstdint>
#include <map>

namespace tilt_lens
{

struct SamplingStatistics
{
    std::map<std::uint32_t, std::uint64_t> pixelsBySamples;  ///< samples of a pixel -> pixels
    double variance = 0.0;                                   ///< sum over pixels, largest channel each
    std::uint64_t notFinite = 0;                             ///< samples with a channel that is not finite
    std::uint64_t emitterSampled = 0;                        ///< samples that were sent at emitters
    std::uint64_t reconstructed = 0;                         ///< pixels that the reconstruction has filtered
    std::uint64_t lightPoints = 0;                           ///< points of area lights that were asked for
    std::uint64_t lightPointsSkipped = 0;                    ///< and those beside them that were not
    std::uint64_t refusedRays = 0;                           ///< that a lens of glass let not through, of all that were tried

    void Add(const SamplingStatistics& other);
    std::uint64_t Pixels() const;
    std::uint64_t Samples() const;
    /// Pixels with that many samples or fewer.
    std::uint64_t PixelsUpTo(std::uint32_t samples) const;
    std::uint32_t Most() const;
    /// Samples that `share` of the pixels did not exceed.
    std::uint32_t Quantile(double share) const;
    /// Root of the mean estimated variance.
    double StandardError() const;
};

} // namespace tilt_lens

#endif
