// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_camera.h
/// A thin lens or a lens of glass, with aperture and vignetting.
///
/// The folder lens_camera/ joins camera/ and glass/.

#ifndef TILT_LENS_LENS_CAMERA_H
#define TILT_LENS_LENS_CAMERA_H

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "tilt_lens/camera/vignetting.h"
#include "tilt_lens/lens_camera/glass_camera.h"

namespace tilt_lens
{

/// Immutable, thread-safe.
class LensCamera
{
  public:
    /// @param character  only its vignetting. Solve() has applied the rest.
    /// @param deflected  true if the renderer turns rays afterwards (camera with `normal`)
    /// @throws OpticsError  if a rim leaves at most 1 per cent of the middle's light
    /// @throws std::invalid_argument  if glass does so
    LensCamera(std::shared_ptr<const SolvedLens> lens, const Aperture& aperture, const Character& character, bool deflected = false);

    const SolvedLens& Solved() const { return *lens; }
    const Aperture& Opening() const { return aperture; }
    /// Null for a thin lens.
    const GlassCamera* Glass() const { return std::get_if<GlassCamera>(&kind); }
    /// Not for glass, which has its own rims.
    const Vignetting& ThinVignetting() const;

    /// @name Uses of its rays
    /// @{
    bool HasColours() const;
    bool BendsChiefRays() const { return lens->distorts || Glass() != nullptr; }
    /// True if the lens images planes onto planes, to scale, with its whole aperture visible.
    bool CanSpread() const;
    bool CanAimAtEmitters() const { return !deflected; }
    /// False if first samples cannot be aimed, or if they come through glass and serve no other pixels.
    bool NeedsFewFirstSamples() const { return CanAimAtEmitters() && Glass() == nullptr; }
    /// @}

    /// Separates the seeds for redrawing blocked samples from a ray's own.
    std::uint32_t SeedSalt() const { return Glass() != nullptr ? 0x476c61 : 0x52696d; }

    /// Ray through the centre of the visible opening; none if blocked.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const;

    /// Blur (optics.h) of a hit on the chief ray.
    /// @param depth  along the camera's axis; infinite for no hit
    /// @param width  of the picture, pixels
    double Blur(const FilmPoint& film, double depth, double width) const;

  private:
    const std::shared_ptr<const SolvedLens> lens;
    const Aperture aperture;
    const bool deflected, hasRim;
    const std::variant<Vignetting, GlassCamera> kind;
};

/// True if POV-Ray's own picture is equal.
bool IsPlainPinhole(const SolvedLens& lens, const Character& character);

} // namespace tilt_lens

#endif
