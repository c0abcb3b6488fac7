// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file recorded_sample.h
/// A sample in the file that record_samples writes and replay_samples reads.

#ifndef TILT_LENS_RECORDED_SAMPLE_H
#define TILT_LENS_RECORDED_SAMPLE_H

#include <algorithm>
#include <cstdint>

#include "tilt_lens/sampling/sample.h"

namespace tilt_lens
{

struct RecordedSample
{
    std::uint16_t x, y, index, hit;
    float radiance[5], blurRadius, expectedEmission;

    RecordedSample() = default;
    RecordedSample(const SampleId& id, const SampleResult& result) :
        x(id.x), y(id.y), index(id.index), hit(result.hit), blurRadius(result.blurRadius),
        expectedEmission(result.expectedEmission)
    {
        std::copy(result.radiance.begin(), result.radiance.end(), radiance);
    }

    SampleResult Result() const
    {
        SampleResult result;
        std::copy(radiance, radiance + 5, result.radiance.begin());
        result.blurRadius = blurRadius;
        result.expectedEmission = expectedEmission;
        result.hit = hit != 0;
        return result;
    }
};

} // namespace tilt_lens

#endif
