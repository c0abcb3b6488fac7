// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file character.h
/// What a real lens does otherwise than an ideal one, as a `tilt_lens` block says it: docs/lenses.md. All is off by default.

#ifndef TILT_LENS_CHARACTER_H
#define TILT_LENS_CHARACTER_H

#include <optional>

namespace tilt_lens
{

/// Items of the block. Where they go into the solved Lens is told in optics.h; vignetting.h and aperture.h take the others
/// as they are.
struct Character
{
    double naturalVignetting = 0.0;  ///< share of the natural fall-off of light, 0 to 1
    double opticalVignetting = 0.0;  ///< lens diameters by which a rim before the lens covers it towards the film's corners
    std::optional<double> rimStop;   ///< f-number of that rim; without one it is as wide as the aperture
    double edgeLight = 0.0;          ///< light gathers at the rim of the aperture (above 0) or in its middle (below 0)
    double distortion1 = 0.0;        ///< of the squared distance from the lens's axis, in half widths of the film
    double distortion2 = 0.0;        ///< of its fourth power
    double distortionNear = 0.0;     ///< by which distortion1 is greater where the focal length over the distance of the focus is 1
    double fieldCurvature = 0.0;     ///< mm by which the image lies before the film half a film's width beside the axis
    double lateralColour = 0.0;      ///< mm by which the red end's image lies farther out than the blue end's there
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
