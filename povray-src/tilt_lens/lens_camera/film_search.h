// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file film_search.h
/// Film points from which a lens of glass shows a point of the scene through given points of its pupil.
///
/// Source: C. G. Broyden, "A class of methods for solving nonlinear simultaneous equations", Mathematics of Computation 19, 1965.

#ifndef TILT_LENS_FILM_SEARCH_H
#define TILT_LENS_FILM_SEARCH_H

#include <array>
#include <cmath>

#include "tilt_lens/lens_camera/glass_camera.h"

namespace tilt_lens
{

using FourFilms = std::array<FilmPoint, 4>;
using FourApertures = std::array<AperturePoint, 4>;

class FilmSearch
{
  public:
    /// @param camera  must outlive this object
    /// @param target  relative to the lens centre, world axes, scene units
    FilmSearch(const GlassCamera& camera, const Vec3& target);

    /// About where FilmsOf() finds a film point. NaN: the middle of the pupil does not show the target.
    FilmPoint Start(const AperturePoint& pupil) const
    {
        return {middle.x + pupil.a * byA.x + pupil.b * byB.x, middle.y + pupil.a * byA.y + pupil.b * byB.y};
    }

    /// @param pupil  points as in FourGlassSamples
    /// @param films  to start with
    /// @return       NaN: none
    FourFilms FilmsOf(const FourApertures& pupil, double hue, FourFilms films) const;

  private:
    /// Derivative of the film point by the distance at which its ray misses the target.
    struct Slope
    {
        FilmPoint x, y;  ///< rows

        FilmPoint operator*(const FilmPoint& miss) const { return {x.x * miss.x + x.y * miss.y, y.x * miss.x + y.y * miss.y}; }
        void Learn(const FilmPoint& step, const FilmPoint& change);
    };

    const GlassCamera& camera;
    const Vec3 target;
    Vec3 across, along;  ///< span the plane of the misses
    FilmPoint middle{NAN, NAN};  ///< through the middle of the pupil
    FilmPoint byA{}, byB{};  ///< derivatives by the pupil's coordinates
    Slope slope;

    void FindSlope(const FilmPoint& film);
    void FindStart(const FilmPoint& near);
    FourFilms MissesOf(const FourFilms& films, const FourApertures& pupil, double hue) const;
    FilmPoint MissOf(const LensRay& ray) const;
};

} // namespace tilt_lens

#endif
