// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file pixel_statistics.h
/// Statistics of one pixel's samples: docs/sampling.md, section 3. Two buffers sum the earlier rounds and the last one, at first its
/// halves.
///
/// Sources: dual buffers as in F. Rousselle, C. Knaus, M. Zwicker, "Adaptive rendering with non-local means filtering", ACM Trans. Graph.
/// 31(6), 2012; the variance of stratified samples as in W. G. Cochran, "Sampling Techniques", 1977, chapter 5.

#ifndef TILT_LENS_PIXEL_STATISTICS_H
#define TILT_LENS_PIXEL_STATISTICS_H

#include <array>
#include <cstdint>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/math/simd.h"
#include "tilt_lens/sampling/sample.h"

namespace tilt_lens
{

class PixelStatistics
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
    /// One sample's variance; 0 for fewer than two. Only deviations within the two strata, plain and emitter samples, count.
    Radiance Variance() const;
    /// Pure noise.
    Radiance DualBufferDifference() const;
    std::uint32_t FirstBufferSamples() const { return firstBuffer; }

  private:
    std::array<Radiance, 2> sum{};  ///< per buffer
    Radiance squares{};
    Radiance emitterSum{};
    std::uint32_t samples = 0;
    std::uint32_t firstBuffer = 0;
    std::uint32_t emitterSamples = 0, notFinite = 0;
    double expectedEmission = 0.0;

    void AddToBuffer(const SampleResult* results, std::uint32_t count, Radiance& bufferSum);
    void AddEmitterSample(const SampleResult& result);
};

} // namespace tilt_lens

#endif
