// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_camera.h
/// A picture's camera: a thin lens or a lens of glass, with aperture and vignetting.
///
/// The folder lens_camera/ joins camera/ and glass/: it solves statements for either lens, and puts glass before a film.

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

/// Immutable; one instance serves all threads.
class LensCamera
{
  public:
    /// @param character  only its vignetting: Solve() has applied the rest
    /// @param deflected  true if the renderer turns rays after the lens, as for a camera with `normal`
    /// @throws OpticsError            a rim that leaves at most 1 per cent of the light in the picture's middle
    /// @throws std::invalid_argument  glass that does so
    LensCamera(std::shared_ptr<const SolvedLens> lens, const Aperture& aperture, const Character& character, bool deflected = false);

    const SolvedLens& Solved() const { return *lens; }
    const Aperture& Opening() const { return aperture; }
    /// Null for a thin lens.
    const GlassCamera* Glass() const { return std::get_if<GlassCamera>(&kind); }
    /// Not for glass, which has its own rims.
    const Vignetting& ThinVignetting() const;

    /// @name Uses of its rays
    /// @{
    /// True if a sample needs rays of several colours.
    bool HasColours() const;
    bool BendsChiefRays() const { return lens->distorts || Glass() != nullptr; }
    /// True if a sample may serve the pixels of its circle of confusion: the lens images planes onto planes, to scale, and its whole
    /// aperture is visible from everywhere.
    bool CanSpread() const;
    bool CanAimAtEmitters() const { return !deflected && Glass() == nullptr; }
    /// @}

    /// Separates the seeds that redraw blocked samples from those that a ray draws from.
    std::uint32_t SeedSalt() const { return Glass() != nullptr ? 0x476c61 : 0x52696d; }

    /// Ray through the centre of the visible opening; none if blocked.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const;

    /// Blur (optics.h) of a hit on the film point's chief ray.
    /// @param depth  along the camera's axis; infinite for no hit
    /// @param width  of the picture, pixels
    double Blur(const FilmPoint& film, double depth, double width) const;

  private:
    const std::shared_ptr<const SolvedLens> lens;
    const Aperture aperture;
    const bool deflected, hasRim;
    const std::variant<Vignetting, GlassCamera> kind;
};

/// True if POV-Ray's own picture is equal: an ideal pinhole with even light.
bool IsPlainPinhole(const SolvedLens& lens, const Character& character);

} // namespace tilt_lens

#endif
