// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_camera.h
/// Camera rays through a lens of glass, moved about its front principal point (docs/optics.md, "Through glass").
///
/// Samples are uniform over the passing directions: drawn from tabulated ellipses (pupil_view.h), again if blocked. The weight contains the
/// open share, so a uniform surface has no noise.

#ifndef TILT_LENS_GLASS_CAMERA_H
#define TILT_LENS_GLASS_CAMERA_H

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/pupil_view.h"
#include "tilt_lens/lens_camera/glass_film.h"
#include "tilt_lens/lens_camera/solve.h"

namespace tilt_lens
{

struct GlassSample
{
    LensRay ray;
    double weight;  ///< of the radiance; 0: nothing to trace
    std::uint32_t refused;  ///< blocked rays drawn before
};

/// Immutable, thread-safe.
class GlassCamera
{
  public:
    /// @param lens      with glass
    /// @param aperture  uniform brightness; within the unit disc
    /// @param natural   share of the natural light fall-off, 0 to 1
    /// @throws std::invalid_argument  if at most 1 per cent of the stop is open in the picture's middle
    GlassCamera(std::shared_ptr<const SolvedLens> lens, const Aperture& aperture, double natural);

    /// At the d line.
    void Draw(const FourGlassPoints& points, FourGlassSamples& samples) const
    {
        DrawThrough({&glass, &glass, &glass, &glass}, points, samples);
    }

    GlassSample Draw(const FilmPoint& film, double u, double v, std::uint32_t seed) const;

    /// The share that the rims block is the d line's, so uniform grey has no colour.
    /// @param hues  of the first three points, -1 (blue end) to 1 (red end)
    void DrawColours(const FourGlassPoints& points, const std::array<double, 3>& hues, FourGlassSamples& samples) const;

    /// Rays through aimed points alone: neither rims nor the stop block them.
    /// @return  one bit per ray
    unsigned int Aim(const FourGlassPoints& points, double hue, FourGlassSamples& samples) const;

    bool HasColours() const { return colours.has_value(); }

    /// None if blocked.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const;

    double Brightness(const FilmPoint& film) const;

    /// Share of the stop's light that passes the rims.
    double OpenShare(const FilmPoint& film) const;

    /// Share of the ellipse BoundsAt() whose rays pass.
    double PassingShare(const FilmPoint& film) const;

    const Lens& Solved() const { return *lens; }

    /// Lens frame, mm.
    Vec3 FilmInLens(const FilmPoint& film) const { return frame.Place(film.x, film.y); }

    PupilEllipse BoundsAt(const FilmPoint& film) const;

  private:
    std::shared_ptr<const SolvedLens> lens;
    GlassLens glass;  ///< with the aperture's shape
    std::optional<GlassOfColours> colours;  ///< none: one wavelength
    Aperture disc = Aperture::Disc();
    GlassFilm frame;
    std::vector<PupilNode> nodes;

    void PlaceFilm();
    void Tabulate();
    void FillUnseen();
    PupilNode NodeAt(const FilmPoint& film, std::optional<PupilPoint>& near) const;
    PupilNode Between(const FilmPoint& film) const;  ///< without `passing`
    double Between(const FilmPoint& film, double PupilNode::* number) const;
    PupilEllipse BoundsOf(const PupilNode& node, const Vec3& place) const;
    const GlassLens& LensOf(double hue) const { return colours ? colours->Of(hue) : glass; }
    unsigned int DrawRays(const GlassLens::Four& lenses, const FourGlassPoints& points, const FourPupils& pupils, unsigned int waiting,
                          FourGlassRays& drawn, FourGlassSamples& samples) const;
    void DrawThrough(const GlassLens::Four& lenses, const FourGlassPoints& points, FourGlassSamples& samples) const;
};

}  // namespace tilt_lens

#endif
