// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample.h
/// What the sampler asks of a tracer for one sample, and what it gets.

#ifndef TILT_LENS_SAMPLE_H
#define TILT_LENS_SAMPLE_H

#include <cstdint>
#include <functional>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/reconstruction/spread.h"

namespace tilt_lens
{

/// Identifies one sample of one pixel.
struct SampleId
{
    std::uint32_t x, y;   ///< pixel in the whole picture
    std::uint32_t index;  ///< 0, 1, ... in the order taken
};

/// What the ray of one sample has found.
struct SampleResult
{
    Radiance radiance;
    double blurRadius = 0.0;        ///< of the surface that was hit, pixels; 0: it is sharp, or nothing was hit
    double expectedEmission = 0.0;  ///< of an emitter-sampled sample: what its emitters bring the pixel if nothing hides
                                    ///< them (emitter_sampling.h); 0 for any other sample
    CircleOfConfusion circle;       ///< of the surface that was hit, in the whole picture

    /// A sharp surface of this radiance.
    SampleResult& operator=(const Radiance& value)
    {
        *this = SampleResult();
        radiance = value;
        return *this;
    }
};

/// Traces one sample, that which PixelSampler(id.x, id.y, seed) gives for id.index.
using Tracer = std::function<void(const SampleId& id, SampleResult& result)>;

} // namespace tilt_lens

#endif
