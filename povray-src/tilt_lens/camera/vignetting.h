// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file vignetting.h
/// How much less light the outer parts of a picture get. A picture stays as bright in its middle as without.
///
/// Natural vignetting is geometry: a film point sees the lens smaller and slantwise. For a chief ray C on the film's side, z the
/// film's normal and t the lens's, light falls with
///
///     (z.C) (t.C) / |C|^4
///
/// which is the fourth power of the cosine where both are parallel, and has the true angles and distance of a lens that is
/// turned or a frame that is shifted.
///
/// Optical vignetting is a second stop: a rim at a distance before the lens that covers a part of the aperture from film points
/// beside the axis. A ray meets the plane of the rim, at the distance h along the lens's axis, at m l + e, with
///
///     e = (h / t.D) D across t,   m = 1 - (h / t.D) w         (D, w, l as in ray.h)
///
/// so that a film point sees a disc of the aperture: what the rim leaves open. Samples are drawn in what is open and weighted
/// with its share of the aperture, so that an even surface stays free of noise.

#ifndef TILT_LENS_VIGNETTING_H
#define TILT_LENS_VIGNETTING_H

#include <cstdint>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

/// Immutable: threads share it.
class Vignetting
{
  public:
    /// None.
    Vignetting() = default;

    /// @throws OpticsError  the rim leaves (almost) no light in the middle of the picture
    Vignetting(const Lens& lens, const Aperture& aperture, const Character& character);

    bool None() const { return natural == 0.0 && rimDistance == 0.0; }

    /// Brightness at a film point over that of the middle, without what the rim covers, and with the exposure that makes up for
    /// what it covers in the middle.
    double Brightness(const FilmPoint& film) const;

    /// Share of the aperture's light that the rim leaves open for a film point: bilinear in a table of the frame, right to 0.001.
    double OpenShare(const FilmPoint& film) const;

    /// Whether the rim lets a lens point's light through to a film point.
    bool Passes(const FilmPoint& film, const AperturePoint& point) const;

    /// A lens point that the rim leaves open, from the sequence's own if that is, else from random numbers: each point that is
    /// open is as likely as in the aperture.
    /// @param seed   of the random numbers
    /// @param[out] point
    /// @return the weight of the sample; 0 for a film point that sees nothing
    double DrawPoint(const Aperture& aperture, const FilmPoint& film, double u, double v, std::uint32_t seed,
                     AperturePoint& point) const;

    /// How much likelier DrawPoint() makes an open point of the aperture than it is without the rim.
    double DrawDensity(const FilmPoint& film) const;

    /// Radius and distance of the rim, scene units; 0 where there is none.
    double RimRadius() const { return rimRadius; }
    double RimDistance() const { return rimDistance; }

  private:
    /// The disc of the aperture that the rim leaves open, in aperture coordinates: of the points p with |m p + e| <= radius.
    struct Opening
    {
        double m, a, b, radius;

        double Left(const AperturePoint& point) const
        {
            const double x = m * point.a + a, y = m * point.b + b;
            return radius * radius - x * x - y * y;
        }
    };

    Lens lens;
    double natural = 0.0;
    double rimDistance = 0.0, rimRadius = 0.0;
    double middle = 1.0;    ///< natural fall-off in the middle of the picture
    double exposure = 1.0;  ///< inverse of what the rim leaves open there
    std::vector<float> open;  ///< shares at the points of a grid over the frame, row by row

    double Falloff(const FilmPoint& film) const;
    Opening OpeningFor(const FilmPoint& film) const;
    void Tabulate(const Aperture& aperture);
};

} // namespace tilt_lens

#endif
