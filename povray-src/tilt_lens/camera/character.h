// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file character.h
/// Aberrations of a real lens, as stated in a `tilt_lens` block (docs/lenses.md). All are off by default.

#ifndef TILT_LENS_CHARACTER_H
#define TILT_LENS_CHARACTER_H

#include <optional>

namespace tilt_lens
{

/// Items of the block. Solve() turns some into members of Lens; vignetting.h and aperture.h use the others directly.
struct Character
{
    double naturalVignetting = 0.0;  ///< share of the natural light fall-off, 0 to 1
    double opticalVignetting = 0.0;  ///< shift of a rim before the lens over the aperture, seen from the film's corners; rim diameters
    std::optional<double> rimStop;   ///< f-number of that rim; if absent, it is as wide as the aperture
    double edgeLight = 0.0;          ///< brighter at the rim of the aperture (above 0) or in its middle (below 0)
    double distortion1 = 0.0;        ///< coefficient of r^2, r being the distance from the lens's axis in half widths of the film
    double distortion2 = 0.0;        ///< coefficient of r^4
    double distortionNear = 0.0;     ///< added to distortion1 in proportion to focal length / focus distance
    double fieldCurvature = 0.0;     ///< mm by which the image lies before the film, half a film's width off the axis
    double lateralColour = 0.0;      ///< mm by which the red end's image is farther out than the blue end's there
    double axialColour = 0.0;        ///< mm by which the red end's image lies behind the blue end's

    bool Distorts() const { return distortion1 != 0.0 || distortion2 != 0.0 || distortionNear != 0.0; }
};

/// @name Limits of the items.
/// @{
constexpr double kMostOpticalVignetting = 2.0;
constexpr double kMostEdgeLight = 0.9;
/// @}

} // namespace tilt_lens

#endif
