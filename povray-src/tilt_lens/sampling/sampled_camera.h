// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampled_camera.h
/// A picture's camera as its samples need it, and the rules that depend on the camera alone: may samples be aimed at emitters, and may they
/// serve other pixels?

#ifndef TILT_LENS_SAMPLED_CAMERA_H
#define TILT_LENS_SAMPLED_CAMERA_H

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/glass/glass_camera.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/sampling/emitter_sampling.h"
#include "tilt_lens/sampling/lens_sampler.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Immutable: threads share it.
class SampledCamera
{
  public:
    /// The picture and its scene.
    struct Picture
    {
        std::uint32_t width, height;      ///< pixels
        bool deflectsRays = false;        ///< the renderer deflects rays that have left the lens, as POV-Ray does by a camera's `normal`
        std::vector<Emitter> emitters{};  ///< of the scene
    };

    /// @param limits    with a minimum of 0 for the usual one
    /// @param aperture  of the lens
    /// @throws std::invalid_argument, OpticsError  as GlassCamera and Vignetting
    SampledCamera(const Lens& lens, const Aperture& aperture, const Statement& statement, const SamplingLimits& limits,
                  const Picture& picture);

    const std::unique_ptr<const GlassCamera> glass;  ///< makes the rays of a lens of glass; else null

    /// True if samples may be aimed at emitters: glass and a renderer that deflects rays would make them miss.
    const bool aims;

    /// With `blur_samples`' usual minimum in place of 0.
    const SamplingLimits limits;

    /// True if samples also serve the other pixels of their circles of confusion. The footprint describes these circles only for a lens that
    /// images planes onto planes, to scale and in one colour, whose whole aperture is visible from everywhere, and for rays that go straight
    /// on.
    const bool spreads;

    const LensFootprint footprint;
    const LensSampler lensSampler;
    const EmitterSampling emitters;

    /// Of the sampling pattern.
    const std::uint32_t seed;

    const Lens& GetLens() const { return lensSampler.lens; }

    /// Ray through the middle of the lens; none if glass blocks it.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const
    {
        return glass ? glass->MiddleRay(film) : LensRay{Vec3{}, ChiefRay(GetLens(), film), 0.0};
    }
};

} // namespace tilt_lens

#endif
