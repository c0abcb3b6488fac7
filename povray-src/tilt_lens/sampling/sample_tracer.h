// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample_tracer.h
/// Takes the samples that a block asks for. A sample's way:
///
///      1. A block asks for a pixel's next samples: up to eight with consecutive indices (SampleRun, sample.h).
///      2. The pixel's sequence gives each index four coordinates in (0, 1) (PixelSampler).
///      3. They become film point and lens point (LensSampler), half aimed at small bright objects in view (EmitterSampling).
///      4. These give a ray (FindRays, GlassCamera); weight 0 if the lens blocks it.
///      5. The renderer follows it to its hit: radiance, and length of the path (RayTracer).
///      6. Radiance times weight is the result; the length gives its circle of confusion (SampleTracer, LensFootprint).
///      7. The result enters the statistics of its pixel (PixelStatistics) and of the pixels in its circle (SentSamples).
///      8. After each round the stop rule names the pixels that need more samples (UpdateConvergence).
///      9. Filters compute the pixels from the statistics of the block and its neighbours (Reconstruct).
///     10. The tile takes its blocks' pixels (TileSampler).

#ifndef TILT_LENS_SAMPLE_TRACER_H
#define TILT_LENS_SAMPLE_TRACER_H

#include <cstdint>

#include "tilt_lens/sampling/camera_rays.h"
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sampled_camera.h"

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

/// The library's only demand on a renderer: to follow camera rays, one after the other, to their radiance.
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
    /// @param aims  false: aimed at no emitter
    SampleTracer(const SampledCamera& camera, RayTracer& rayTracer, bool aims = true) :
        camera(camera), rayTracer(rayTracer), batch(camera, aims)
    {
    }

    /// @param results  one per sample; need not be initialised
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
