// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pixel_statistics.h
/// Statistics of one pixel's samples: docs/sampling.md, section 3. Two buffers sum the earlier rounds and the last one, at first its
/// halves.
///
/// Source of updates: T. F. Chan, G. H. Golub, R. J. LeVeque, "Algorithms for computing the sample variance", Amer. Statist. 37(3), 1983.

#ifndef TILT_LENS_PIXEL_STATISTICS_H
#define TILT_LENS_PIXEL_STATISTICS_H

#include <cstdint>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/math/simd.h"
#include "tilt_lens/samples/sample.h"

namespace tilt_lens
{

struct PixelSums
{
    double sum[2][5] = {};  ///< per buffer
    float deviation[5] = {};  ///< root mean square, from the mean of the stratum: plain or emitter samples
    float emitterMean[5] = {};
    std::uint32_t samples = 0, emitterSamples = 0;
    float expectedEmission = 0.0f;
};

class PixelStatistics : private PixelSums
{
  public:
    /// The round ends before sample number `until`.
    void BeginRound(std::uint32_t until);
    /// Counts a non-finite sample as black.
    void Add(const SampleResult* results, std::uint32_t count);
    void Add(const SampleResult& result) { Add(&result, 1); }

    std::uint32_t Samples() const { return samples; }
    std::uint32_t EmitterSamples() const { return emitterSamples; }
    std::uint32_t NotFinite() const { return notFinite; }
    double ExpectedEmission() const { return expectedEmission; }

    Radiance Mean() const;
    /// One sample's variance within the strata; 0 for fewer than two.
    Radiance Variance() const;
    /// Pure noise.
    Radiance DualBufferDifference() const;
    std::uint32_t FirstBufferSamples() const { return firstBuffer; }

  private:
    std::uint32_t firstBuffer = 0, notFinite = 0;

    void AddStratum(const SampleResult* results, std::uint32_t ofFirstBuffer, std::uint32_t count, bool emitters);
};

} // namespace tilt_lens

#endif
