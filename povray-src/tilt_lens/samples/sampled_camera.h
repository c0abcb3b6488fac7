// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampled_camera.h
/// A picture's camera with everything for its samples: limits, emitters, circles of confusion.

#ifndef TILT_LENS_SAMPLED_CAMERA_H
#define TILT_LENS_SAMPLED_CAMERA_H

#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/lens_camera/lens_camera.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/samples/emitter_sampling.h"
#include "tilt_lens/samples/lens_sampler.h"
#include "tilt_lens/samples/sampling_limits.h"

namespace tilt_lens
{

/// Immutable and thread-safe from the first sample on: a search may add emitters before.
class SampledCamera
{
  public:
    struct Picture
    {
        std::uint32_t width, height;      ///< pixels
        std::vector<Emitter> emitters{};
    };

    /// @param limits  minimum 0: the usual one
    SampledCamera(std::shared_ptr<const LensCamera> lens, const SamplingLimits& limits, const Picture& picture, std::uint32_t seed);

    const std::shared_ptr<const LensCamera> lens;

    const SamplingLimits limits;

    /// True if samples may be aimed at emitters.
    const bool aims;

    /// True if samples also serve other pixels of their circles.
    const bool spreads;

    const LensFootprint footprint;
    const LensSampler lensSampler;
    EmitterSampling emitters;

    const std::uint32_t seed;
};

} // namespace tilt_lens

#endif
