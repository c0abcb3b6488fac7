// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample_record.h
/// Keeps traced samples, so that a block can be sampled again without tracing.

#ifndef TILT_LENS_SAMPLE_RECORD_H
#define TILT_LENS_SAMPLE_RECORD_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/samples/sample.h"

namespace tilt_lens
{

class SampleRecord
{
  public:
    /// @param mostSent  number of a pixel's samples, its first, that are spread
    SampleRecord(const Area& area, std::uint32_t mostSent) : area(area), mostSent(mostSent), pixels(area.Size()) {}

    /// False, with nothing copied, unless all samples are recorded.
    bool Get(const SampleRun& run, SampleResult* results) const;
    /// As Get(); missing samples are traced and recorded. Each pixel's samples must be requested in order.
    void GetOrTrace(const SampleRun& run, SampleResult* results, const Tracer& trace);

    std::uint64_t Samples() const { return samples; }

    static std::size_t BytesOf(double samples, std::uint32_t mostSent);

  private:
    struct Recorded
    {
        Radiance radiance;
        double expectedEmission;
    };
    struct Pixel
    {
        std::vector<Recorded> samples;
        std::vector<CircleOfConfusion> circles;  ///< of the samples that are spread
    };

    const Area area;
    const std::uint32_t mostSent;
    std::vector<Pixel> pixels;
    std::uint64_t samples = 0;
};

} // namespace tilt_lens

#endif
