// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file recorded_sample.h
/// From record_samples, for replay_samples.

#ifndef TILT_LENS_RECORDED_SAMPLE_H
#define TILT_LENS_RECORDED_SAMPLE_H

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "tilt_lens/samples/sample.h"

namespace tilt_lens
{

struct RecordedSample
{
    std::uint16_t x, y;
    std::uint32_t index;
    float radiance[5], expectedEmission;
    float circle[7];

    RecordedSample() = default;
    RecordedSample(const SampleId& id, const SampleResult& result) :
        x(id.x), y(id.y), index(id.index), expectedEmission(result.expectedEmission)
    {
        const CircleOfConfusion& from = result.circle;
        const float numbers[] = {from.x, from.y, from.xa, from.xb, from.ya, from.yb, from.weight};
        std::copy(std::begin(numbers), std::end(numbers), circle);
        std::copy(result.radiance.begin(), result.radiance.end(), radiance);
    }

    SampleResult Result(const LensFootprint& lens) const
    {
        SampleResult result;
        std::copy(radiance, radiance + 5, result.radiance.begin());
        result.expectedEmission = expectedEmission;
        result.circle = {circle[0], circle[1], circle[2], circle[3], circle[4], circle[5], &lens, circle[6]};
        return result;
    }
};

} // namespace tilt_lens

#endif
