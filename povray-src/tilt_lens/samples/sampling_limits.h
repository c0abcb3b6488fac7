// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampling_limits.h
/// `blur_samples MIN, MAX`, `variance`, `confidence` and `denoise` of a camera, with their defaults.

#ifndef TILT_LENS_SAMPLING_LIMITS_H
#define TILT_LENS_SAMPLING_LIMITS_H

#include <algorithm>
#include <cstdint>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

struct SamplingLimits
{
    std::uint32_t min = Settings::firstSamplesAlone, max = 1024;  ///< samples per pixel, 1 <= min <= max
    double variance = 1e-4;             ///< of a pixel's value, relative to SquaredScale
    double confidence = 0.9;            ///< probability that the variance is lower, (0, 1)
    bool denoise = false;               ///< filter noise (reconstruction.h)

    Settings settings = DefaultSettings();

    /// Samples per pixel: min, rounded up to a power of two, at most max.
    std::uint32_t FirstRound() const
    {
        std::uint32_t power = 1;
        while (power < min && power < max)
            power *= 2;
        return std::min(power, max);
    }

    /// Alternately 3/2 and 4/3 times as many samples, so that every second round ends at a power of two; twice as many where less would
    /// split a stratum.
    std::uint32_t NextRound(std::uint32_t samples) const
    {
        const bool power = (samples & (samples - 1)) == 0;
        const std::uint32_t more = samples / (power ? 2 : 3);
        return std::min(max, samples + (settings.halfRounds && more >= Settings::emitterStratum ? more : samples));
    }

    /// Samples can be aimed at emitters only if each pixel has a whole stratum.
    bool AllowAims() const { return FirstRound() >= Settings::emitterStratum; }

    /// @param few  true if the lens needs few
    void SetUsualMinimum(bool few) { min = std::min(max, few && Denoises() ? Settings::firstSamples : Settings::firstSamplesAlone); }

    /// `variance 0` disables the reconstruction.
    bool Denoises() const { return denoise && variance > 0.0; }
};

}  // namespace tilt_lens

#endif
