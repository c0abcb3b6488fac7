// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_camera.h
/// The camera of a picture: a thin lens or a lens of glass, with its aperture and vignetting. Sampler and renderer ask it for rays and for
/// what may be done with their samples.
///
/// The folder lens_camera/ joins the thin lens of camera/ and the lenses of glass/: it solves statements for either, and puts glass before
/// a film.

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

/// Immutable. One instance serves all threads of a picture.
class LensCamera
{
  public:
    /// @param character  only vignetting is taken from it: Solve() has applied the rest
    /// @param deflected  true if the renderer turns each ray aside after the lens, as POV-Ray does for a camera with `normal`
    /// @throws OpticsError            a rim that leaves at most 1 per cent of the light in the middle of the picture
    /// @throws std::invalid_argument  glass that does so
    LensCamera(std::shared_ptr<const SolvedLens> lens, const Aperture& aperture, const Character& character, bool deflected = false);

    const SolvedLens& Solved() const { return *lens; }
    const Aperture& Opening() const { return aperture; }
    /// Null for a thin lens.
    const GlassCamera* Glass() const { return std::get_if<GlassCamera>(&kind); }
    /// Vignetting of a thin lens; none for a lens of glass, whose rims are in its rays.
    const Vignetting& ThinVignetting() const;

    /// @name What may be done with its rays
    /// @{
    /// True if a sample needs one ray for each of several colours.
    bool HasColours() const;
    /// True if chief rays differ from those of a pinhole camera.
    bool BendsChiefRays() const { return lens->distorts || Glass() != nullptr; }
    /// True if a sample may serve the pixels of its circle of confusion: the lens images planes onto planes, to scale, its whole aperture
    /// is visible from everywhere, and the sample's ray is the lens's.
    bool CanSpread() const;
    /// True if rays can be aimed at emitters.
    bool CanAimAtEmitters() const { return !deflected && Glass() == nullptr; }
    /// @}

    /// Tells apart the seeds (by PixelHash()) with which blocked samples are drawn again from those that a ray draws from.
    std::uint32_t SeedSalt() const { return Glass() != nullptr ? 0x476c61 : 0x52696d; }

    /// Ray through the centre of the opening that the film point sees; none where that is blocked.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const;

    /// Blur (optics.h) of a hit that the film point's chief ray shows.
    /// @param depth  along the camera's axis; infinite for no hit
    /// @param width  of the picture, pixels
    double Blur(const FilmPoint& film, double depth, double width) const;

  private:
    const std::shared_ptr<const SolvedLens> lens;
    const Aperture aperture;
    const bool deflected, hasRim;
    const std::variant<Vignetting, GlassCamera> kind;
};

/// True for a lens whose picture is POV-Ray's own: an ideal pinhole with even light.
bool IsPlainPinhole(const SolvedLens& lens, const Character& character);

}  // namespace tilt_lens

#endif
