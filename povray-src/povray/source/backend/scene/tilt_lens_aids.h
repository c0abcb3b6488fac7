// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_TILT_LENS_AIDS_H
#define POVRAY_BACKEND_TILT_LENS_AIDS_H

#include <string>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "base/image/colourspace.h"
#include "tilt_lens/camera/focus_aids.h"
#include "tilt_lens/lens_camera/lens_camera.h"

namespace pov
{

class TiltLensAids
{
  public:
    /// @param display  converts the scene's colours to a display's
    TiltLensAids(const tilt_lens::FocusAids& aids, const shared_ptr<const tilt_lens::LensCamera>& camera, int width, int height,
                 pov_base::GammaCurvePtr display);

    bool NeedsLight() const { return !aids.map; }

    /// @param film   the pixel's centre
    /// @param depth  along the camera's axis; infinite without a hit
    Colour Drawn(int x, int y, const tilt_lens::FilmPoint& film, double depth, const Colour& picture) const;

    std::string Describe() const;

  private:
    const tilt_lens::FocusAids aids;
    const shared_ptr<const tilt_lens::LensCamera> camera;
    const double width;
    const tilt_lens::FocusMapScale scale;
    const tilt_lens::FocusPlanes planes;
    const pov_base::GammaCurvePtr display;

    Colour Light(const tilt_lens::Rgb& shown) const;
};

} // namespace pov

#endif
