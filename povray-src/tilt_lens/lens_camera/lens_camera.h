// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_camera.h
/// A picture's camera: a thin lens or a lens of glass, with aperture and vignetting.
///
/// The folder lens_camera/ joins the thin lens of camera/ and the lenses of glass/: it solves statements for either, and puts glass
/// before a film.

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
    /// @param character  only its vignetting: Solve() has applied the rest.
    /// @param deflected  true if the renderer turns rays after the lens, as for a camera with `normal`.
    /// @throws OpticsError            a rim that leaves at most 1 per cent of the light in the picture's middle
    /// @throws std::invalid_argument  glass that does so
    LensCamera(std::shared_ptr<const SolvedLens> lens, const Aperture& aperture, const Character& character, bool deflected = false);

    const SolvedLens& Solved() const { return *lens; }
    const Aperture& Opening() const { return aperture; }
    /// Null for a thin lens.
    const GlassCamera* Glass() const { return std::get_if<GlassCamera>(&kind); }
    /// None for glass, whose rims are in its rays.
    const Vignetting& ThinVignetting() const;

    /// @name Uses of its rays
    /// @{
    /// True if a sample needs rays of several colours.
    bool HasColours() const;
    /// True if chief rays differ from a pinhole camera's.
    bool BendsChiefRays() const { return lens->distorts || Glass() != nullptr; }
    /// True if a sample may serve the pixels of its circle of confusion: the lens images planes onto planes, to scale, its whole
    /// aperture is visible from everywhere, and the sample's ray is the lens's.
    bool CanSpread() const;
    bool CanAimAtEmitters() const { return !deflected && Glass() == nullptr; }
    /// @}

    /// Separates the seeds (by PixelHash()) that redraw blocked samples from those that a ray draws from.
    std::uint32_t SeedSalt() const { return Glass() != nullptr ? 0x476c61 : 0x52696d; }

    /// Through the centre of the opening that the film point sees; none if blocked.
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
