// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_aids.h
/// The focus aids of one picture: what becomes of a pixel that one ray through the lens centre found.

#ifndef POVRAY_BACKEND_TILT_LENS_AIDS_H
#define POVRAY_BACKEND_TILT_LENS_AIDS_H

#include <string>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "base/image/colourspace.h"
#include "tilt_lens/camera/focus_aids.h"

namespace pov
{

class TiltLensAids
{
  public:
    /// @param display  takes the colours of the scene to those of a display, or is neutral
    TiltLensAids(const tilt_lens::FocusAids& aids, const tilt_lens::Lens& lens, int width, int height,
                 pov_base::GammaCurvePtr display);

    /// Whether the light of the scene shows in the pixel; false where only distances count.
    bool NeedsLight() const { return !aids.map; }

    /// The pixel with the aids in it.
    /// @param chief, T  the ray through the pixel's middle, and what it met: T * chief, or T infinite
    Colour Drawn(int x, int y, const tilt_lens::Vec3& chief, double T, const Colour& picture) const;

    /// One line for the report before the render.
    std::string Describe() const;

  private:
    const tilt_lens::FocusAids aids;
    const tilt_lens::Lens lens;
    const double width;
    const tilt_lens::FocusMapScale scale;
    const tilt_lens::FocusPlanes planes;
    const pov_base::GammaCurvePtr display;

    Colour Light(const tilt_lens::Rgb& shown) const;
};

} // namespace pov

#endif
