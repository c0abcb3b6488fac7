// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file character.h
/// A real lens's aberrations, as stated in a `tilt_lens` block.

#ifndef TILT_LENS_CHARACTER_H
#define TILT_LENS_CHARACTER_H

#include <optional>

namespace tilt_lens
{

struct Character
{
    double naturalVignetting = 0.0;  ///< share, 0 to 1
    double opticalVignetting = 0.0;  ///< shift of a rim before the lens at the film's corners, in rim diameters
    std::optional<double> rimStop;   ///< f-number of that rim; absent: as wide as the aperture
    double edgeLight = 0.0;          ///< positive: brighter at the aperture's rim; negative: in its middle
    double distortion1 = 0.0;        ///< factor of r^2; r: distance from the lens's axis in half film widths
    double distortion2 = 0.0;        ///< factor of r^4
    double distortionNear = 0.0;     ///< times focal length / focus distance, added to distortion1
    double fieldCurvature = 0.0;     ///< mm by which the image half a film's width off the axis lies before the film
    double lateralColour = 0.0;      ///< mm between the images of the spectrum's ends there, positive if red is outside
    double axialColour = 0.0;        ///< mm by which the red end's image lies behind the blue end's

    bool Distorts() const { return distortion1 != 0.0 || distortion2 != 0.0 || distortionNear != 0.0; }
};

constexpr double kMostOpticalVignetting = 2.0;
constexpr double kMostEdgeLight = 0.9;

} // namespace tilt_lens

#endif
