// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_rays.h
/// Camera rays: a sample's index gives a film point and a lens point, by the sequence or by emitter sampling, and these give the ray. The
/// rays of a group of samples are computed together in vector registers.

#ifndef TILT_LENS_CAMERA_RAYS_H
#define TILT_LENS_CAMERA_RAYS_H

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/sampling/sampled_camera.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// The rays of a group of samples, one array per number. Relative to the lens centre, world axes, scene units.
struct CameraRays
{
    CameraSamples samples;
    OfGroup origin[3], direction[3];  ///< the direction is normalised
    OfGroup length, w;                ///< of LensRay's direction; as in LensRay

    void Put(std::uint32_t i, const LensRay& ray)
    {
        origin[0][i] = ray.origin.x, origin[1][i] = ray.origin.y, origin[2][i] = ray.origin.z;
        PutDirection(i, ray.direction);
        w[i] = ray.w;
    }

    /// @param along  need not be normalised
    void PutDirection(std::uint32_t i, const Vec3& along)
    {
        length[i] = Length(along);
        direction[0][i] = along.x / length[i], direction[1][i] = along.y / length[i], direction[2][i] = along.z / length[i];
    }
};

/// Computes the rays of a run from their samples, bit for bit as MakeRay() does.
void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays);

/// Makes the camera rays of samples, pixel by pixel.
class CameraRayBatch
{
  public:
    /// @param aims  false: samples are aimed at no emitter
    explicit CameraRayBatch(const SampledCamera& camera, bool aims = true) : camera(camera), glass(camera.lens->Glass()), aims(aims) {}

    void Make(const SampleRun& run);

    /// Makes the ray of a sample of the last run for light of one colour.
    /// @param place     of the sample in its group
    /// @param hue       see MakeColourRay()
    /// @param[out] ray  has it at position 0
    void MakeColour(std::uint32_t place, double hue, CameraRays& ray);

    /// @name Of the last run.
    /// @{
    const PixelSampler& Sampler() const { return sampler; }
    const CameraRays& Rays() const { return rays; }    ///< indexed by the samples' positions in their group
    std::uint32_t Refused() const { return refused; }  ///< rays blocked by the glass lens, of the last run or colour
    /// @}

  private:
    const SampledCamera& camera;
    const GlassCamera* const glass;  ///< null for a thin lens
    const bool aims;
    bool empty = true;  ///< no run yet
    SampleRun last{};
    PixelSampler sampler{0, 0, 0}, glassSeeds{0, 0, 0};
    EmitterSampling::Targets targets;
    SequencePoints points{};
    CameraRays rays{};
    std::uint32_t refused = 0;

    void MakeOfGlass(const SampleRun& run);
    void DrawFour(const SampleRun& run, std::uint32_t first);
};

} // namespace tilt_lens

#endif
