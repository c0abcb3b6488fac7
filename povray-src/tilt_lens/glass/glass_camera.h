// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_camera.h
/// Camera rays through a lens of glass that is tilted, swung and shifted as a whole about its front principal point.
///
/// The film point of the picture's point (x, y) lies where that of an ideal lens does, moved by the lens's separation of principal
/// points along the lens's axis: then the plane of sharp focus, tilt, swing and shift mean what they mean for the ideal
/// lens, to first order, and what differs is what the glass does.
///
/// Samples are drawn evenly in the directions that pass (pupil_view.h): from an ellipse around them, which a table knows for
/// each place of the frame; a direction that the lens refuses is drawn again. What share of the directions the rims leave
/// open is in the sample's weight, so that an even surface has no noise, as for an ideal lens with optical_vignetting.

#ifndef TILT_LENS_GLASS_CAMERA_H
#define TILT_LENS_GLASS_CAMERA_H

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/film_point.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/pupil_view.h"

namespace tilt_lens
{

/// A sample's ray.
struct GlassSample
{
    LensRay ray;
    double weight;          ///< of its radiance; 0: there is nothing to trace
    std::uint32_t refused;  ///< rays before it that the lens let not through
};

/// Film points, and what draws their samples' directions, side by side.
struct FourGlassPoints
{
    double x[4], y[4];      ///< film points
    double u[4], v[4];      ///< in [0, 1)
    std::uint32_t seed[4];  ///< of the random numbers that directions are drawn again with
    unsigned int wanted;    ///< a bit for each of them that a sample is wanted of, the lowest for the first
};

/// Their samples; as GlassSample and LensRay have them.
struct FourGlassSamples
{
    double origin[3][4], direction[3][4], w[4], weight[4];
    std::uint32_t refused[4];
};

/// Immutable: threads share it.
class GlassCamera
{
  public:
    /// @param lens      with glass
    /// @param aperture  a shape of even brightness within the unit disc
    /// @param natural   share of the natural fall-off of light, 0 to 1
    /// @throws std::invalid_argument  the lens leaves (almost) no light in the middle of the picture
    GlassCamera(const Lens& lens, const Aperture& aperture, double natural);

    /// Of light of the d line.
    void Draw(const FourGlassPoints& points, FourGlassSamples& samples) const { DrawThrough(*glass, points, samples); }

    /// One of them.
    /// @param u, v, seed  as FourGlassPoints has them
    GlassSample Draw(const FilmPoint& film, double u, double v, std::uint32_t seed) const { return DrawThrough(*glass, film, u, v, seed); }

    /// The same for light of one colour, of a lens with dispersion. How much of it the rims cover is taken as for the d line, so that
    /// an even grey surface has no colour.
    /// @param hue  its place in the spectrum, from -1 (blue end) to 1 (red end)
    GlassSample DrawColour(const FilmPoint& film, double u, double v, std::uint32_t seed, double hue) const
    {
        return DrawThrough(lens.glassOfColours->Of(hue), film, u, v, seed);
    }

    /// Whether rays of several colours must be traced.
    bool HasColours() const { return lens.glassOfColours != nullptr; }

    /// A ray through the middle of what the film point sees; nothing where that is covered.
    std::optional<LensRay> MiddleRay(const FilmPoint& film) const;

    /// Brightness of a film point over that of the middle of the picture.
    double Brightness(const FilmPoint& film) const;

    /// Share of the stop's light that the rims leave open.
    double OpenShare(const FilmPoint& film) const;

    /// In the lens's frame, mm.
    Vec3 FilmInLens(const FilmPoint& film) const { return filmMiddle + film.x * filmRight + film.y * filmUp; }

    /// Around the directions that a film point sees.
    PupilEllipse BoundsAt(const FilmPoint& film) const;

  private:
    /// Places of the table in a row and in a column of the frame; odd, so that the middle is one. Between them the share that is
    /// open is linear: where it bends by 4 over the frame, 1/8 of that over the squared number of steps is missed, 1/2000.
    static constexpr int kTableSide = 33;

    /// A place of the frame. The ellipse's centre counts from the paraxial aim, so that it changes little from place to place.
    struct Node
    {
        double l = 0.0, m = 0.0, radial = 0.0, tangential = 0.0;
        double open = 0.0;     ///< share that the rims leave open
        double natural = 0.0;  ///< illumination of the film by the stop alone, relative
        bool seen = false;
    };

    Lens lens;
    std::shared_ptr<const GlassLens> glass;
    Aperture aperture, disc = Aperture::Disc();
    double natural;
    Vec3 axisX, axisY;                      ///< of the lens, world, unit length
    Vec3 filmMiddle, filmRight, filmUp;     ///< lens frame, mm
    std::vector<Node> nodes;                ///< row by row
    double middleOpen = 1.0, middleNatural = 1.0;

    void PlaceFilm();
    void Tabulate();
    void FillUnseen();
    Node NodeAt(const FilmPoint& film, std::optional<PupilPoint>& near) const;
    Node Between(const FilmPoint& film) const;
    PupilEllipse BoundsOf(const Node& node, const Vec3& place) const;
    /// @param open, natural  of a Node
    template<class Number>
    TILT_LENS_INLINED Number BrightnessOf(const Number& open, const Number& itsNatural) const
    {
        const Number even = Number() + 1.0, falloff = natural == 0.0 ? even : 1.0 - natural + natural * itsNatural / middleNatural;
        return falloff * open / middleOpen;
    }

    template<class Number>
    LensRayOf<Number> ToWorld(const Number& x, const Number& y, const GlassRayOf<Number>& ray) const;
    struct FourPupils;
    template<class Vector>
    struct Interpolation;
    template<class Vector>
    void FindPupils(const FourGlassPoints& points, FourPupils& pupils) const;
    template<class Vector>
    static unsigned int Aim(const FourPupils& pupils, const double* a, const double* b, FourGlassRays& rays);
    template<class Vector>
    unsigned int DrawRays(const GlassLens& colour, const FourGlassPoints& points, const FourPupils& pupils, unsigned int waiting,
                          FourGlassRays& drawn, std::uint32_t (&refused)[4]) const;
    template<class Vector>
    void DrawBy(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const;
    void DrawPlainly(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const;
    void DrawByAvx2(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const;
    void DrawThrough(const GlassLens& colour, const FourGlassPoints& points, FourGlassSamples& samples) const;
    GlassSample DrawThrough(const GlassLens& colour, const FilmPoint& film, double u, double v, std::uint32_t seed) const;
};

} // namespace tilt_lens

#endif
