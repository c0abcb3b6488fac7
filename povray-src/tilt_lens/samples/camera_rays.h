// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_rays.h
/// Camera rays from film points and lens points, a group at a time in vector registers.

#ifndef TILT_LENS_CAMERA_RAYS_H
#define TILT_LENS_CAMERA_RAYS_H

#include <array>

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/samples/sampled_camera.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// A group's rays, relative to the lens centre; world axes, scene units.
struct CameraRays
{
    CameraSamples samples;
    OfGroup origin[3], direction[3];  ///< direction is normalised
    OfGroup length, w;                ///< as in LensRay; its direction's length

    void Put(std::uint32_t i, const LensRay& ray)
    {
        origin[0][i] = ray.origin.x, origin[1][i] = ray.origin.y, origin[2][i] = ray.origin.z;
        PutDirection(i, ray.direction);
        w[i] = ray.w;
    }

    /// @param along  of any length
    void PutDirection(std::uint32_t i, const Vec3& along)
    {
        length[i] = Length(along);
        direction[0][i] = along.x / length[i], direction[1][i] = along.y / length[i], direction[2][i] = along.z / length[i];
    }
};

/// Bit for bit as MakeRay().
void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays);

class CameraRayBatch
{
  public:
    /// @param aims  false: plain samples only
    explicit CameraRayBatch(const SampledCamera& camera, bool aims = true) : camera(camera), glass(camera.lens->Glass()), aims(aims) {}

    void Make(const SampleRun& run);

    /// @param place      of the sample in its group
    /// @param hues       see MakeColourRay()
    /// @param[out] made  at the first three positions
    void MakeColours(std::uint32_t place, const std::array<double, 3>& hues, CameraRays& made);

    /// @name Valid for the last run
    /// @{
    const PixelSampler& Sampler() const { return sampler; }
    const CameraRays& Rays() const { return rays; }    ///< by place in the group
    std::uint32_t Refused() const { return refused; }  ///< blocked by the glass lens, last run or colours
    /// @}

  private:
    const SampledCamera& camera;
    const GlassCamera* const glass;
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
    void PutPoint(std::uint32_t place, double hue, std::uint32_t i, FourGlassPoints& four);
    void Weigh(std::uint32_t place, double hue, std::uint32_t i, FourGlassSamples& four) const;
};

} // namespace tilt_lens

#endif
