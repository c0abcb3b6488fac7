// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file character.h
/// A real lens's aberrations, as stated in a `tilt_lens` block (docs/lenses.md); off by default.

#ifndef TILT_LENS_CHARACTER_H
#define TILT_LENS_CHARACTER_H

#include <optional>

namespace tilt_lens
{

/// Solve() turns some into members of Lens; vignetting.h and aperture.h use the others directly.
struct Character
{
    double naturalVignetting = 0.0;  ///< share of the natural fall-off, 0 to 1
    double opticalVignetting = 0.0;  ///< shift of a rim before the lens over the aperture, from the film's corners; rim diameters
    std::optional<double> rimStop;   ///< f-number of that rim; absent: as wide as the aperture
    double edgeLight = 0.0;          ///< brighter at the aperture's rim (above 0) or middle (below 0)
    double distortion1 = 0.0;        ///< of r^2, r being half film widths from the lens's axis
    double distortion2 = 0.0;        ///< of r^4
    double distortionNear = 0.0;     ///< times focal length / focus distance, added to distortion1
    double fieldCurvature = 0.0;     ///< mm of the image before the film, half a film's width off the axis
    double lateralColour = 0.0;      ///< mm of the red end's image outside the blue end's there
    double axialColour = 0.0;        ///< mm of the red end's image behind the blue end's

    bool Distorts() const { return distortion1 != 0.0 || distortion2 != 0.0 || distortionNear != 0.0; }
};

/// @name Limits.
/// @{
constexpr double kMostOpticalVignetting = 2.0;
constexpr double kMostEdgeLight = 0.9;
/// @}

} // namespace tilt_lens

#endif
