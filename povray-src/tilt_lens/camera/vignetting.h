// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file vignetting.h
/// Light fall-off towards the picture's edges. The centre keeps its brightness.
///
/// Natural vignetting: for a chief ray C, z the film's normal and t the lens's, irradiance falls with
///
///     (z.C) (t.C) / |C|^4,
///
/// which is cos^4 if both are parallel.
///
/// Optical vignetting: a rim at the distance h before the lens hides a part of the aperture. A ray meets the rim's plane at m l + e, with
///
///     e = (h / t.D) D across t,   m = 1 - (h / t.D) w         (D, w, l as in ray.h),
///
/// so a film point sees a disc of the aperture.

#ifndef TILT_LENS_VIGNETTING_H
#define TILT_LENS_VIGNETTING_H

#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"

namespace tilt_lens
{

/// Immutable, thread-safe.
class Vignetting
{
  public:
    Vignetting() = default;

    /// @throws OpticsError  the rim leaves at most 1 per cent of the light in the picture's middle
    Vignetting(std::shared_ptr<const Lens> lens, const Aperture& aperture, const Character& character);

    bool None() const { return natural == 0.0 && rimDistance == 0.0; }

    /// Natural fall-off, times the exposure that restores the centre's brightness.
    double Brightness(const FilmPoint& film) const;

    /// Share of the aperture's light that passes, to within 0.001.
    double OpenShare(const FilmPoint& film) const;

    bool Passes(const FilmPoint& film, const AperturePoint& point) const;

    /// Draws the open lens point of (u, v), or else a random one with the same density.
    /// @return  sample weight; 0 without light
    double DrawPoint(const Aperture& aperture, const FilmPoint& film, double u, double v, std::uint32_t seed, AperturePoint& point) const;

    /// Relative to that without the rim.
    double DrawDensity(const FilmPoint& film) const;

    /// Scene units; 0 without a rim.
    double RimRadius() const { return rimRadius; }
    double RimDistance() const { return rimDistance; }

  private:
    /// Points p of the aperture with |m p + e| <= radius, e = (a, b).
    struct Opening
    {
        double m, a, b, radius;

        double Left(const AperturePoint& point) const
        {
            const double x = m * point.a + a, y = m * point.b + b;
            return radius * radius - x * x - y * y;
        }
    };

    std::shared_ptr<const Lens> lens;
    double natural = 0.0;
    double rimDistance = 0.0, rimRadius = 0.0;
    double middle = 1.0;  ///< natural fall-off in the centre
    double exposure = 1.0;  ///< inverse of the open share there
    std::vector<float> open;  ///< table over the frame

    double Falloff(const FilmPoint& film) const;
    Opening OpeningFor(const FilmPoint& film) const;
    void Tabulate(const Aperture& aperture);
};

} // namespace tilt_lens

#endif
