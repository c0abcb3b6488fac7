// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample_tracer.h
/// Traces a pixel's samples: docs/sampling.md, "The way of a sample".

#ifndef TILT_LENS_SAMPLE_TRACER_H
#define TILT_LENS_SAMPLE_TRACER_H

#include <cstdint>

#include "tilt_lens/samples/camera_rays.h"
#include "tilt_lens/samples/sample.h"
#include "tilt_lens/samples/sampled_camera.h"

namespace tilt_lens
{

struct Hit
{
    Radiance radiance{};
    double distance = 0.0;  ///< along the light's path, scene units; infinite without a surface
};

/// Consecutive samples of one pixel.
struct RayRange
{
    std::uint32_t place, count;  ///< first ray in CameraRays, number of rays
    std::uint32_t index;
    const PixelSampler& sequence;  ///< the pixel's; has more random numbers per sample
    bool distances;
};

/// The library's only demand on a renderer: following camera rays to their radiance.
class RayTracer
{
  public:
    virtual ~RayTracer() = default;

    /// @param hits  one per ray
    virtual void Trace(const CameraRays& rays, const RayRange& range, Hit* hits) = 0;
};

/// For one thread.
class SampleTracer
{
  public:
    /// @param aims  false: plain samples only
    SampleTracer(const SampledCamera& camera, RayTracer& rayTracer, bool aims = true) :
        camera(camera), rayTracer(rayTracer), batch(camera, aims)
    {
    }

    void Trace(const SampleRun& run, SampleResult* results);

    /// Blocked by a lens of glass since last set to 0.
    std::uint64_t refusedRays = 0;

  private:
    const SampledCamera& camera;
    RayTracer& rayTracer;
    CameraRayBatch batch;

    void TraceRays(const CameraRays& rays, std::uint32_t place, std::uint32_t index, std::uint32_t count, SampleResult* results);
    void TraceColours(std::uint32_t place, std::uint32_t index, SampleResult& result);
};

} // namespace tilt_lens

#endif
