// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharpness.h
/// The blur of a part of a picture, as the diameter of the disc that makes it out of a sharp picture; and the
/// steepness of a picture's brightness.

#ifndef PAPER_SHARPNESS_H
#define PAPER_SHARPNESS_H

#include "brightness.h"
#include "picture.h"

namespace paper
{

struct Window
{
    int left = 0, top = 0, width = 0, height = 0;  ///< pixels of the blurred picture
};

struct Blur
{
    double diameter = 0.0;  ///< pixels
    double residual = 0.0;  ///< RMS residual of the fitted disc, in parts of the contrast
};

/// The disc, at most `widest` pixels across, that brings the sharp picture nearest to the blurred one in the window:
/// least squares of linear luminance. The sharp picture may be 3, 5 ... times as wide and high. Beyond its edge its
/// last pixels go on.
/// @throws std::invalid_argument pictures of unfit sizes, a window outside, or one without contrast.
Blur BlurBetween(const witness::Picture& sharp, const witness::Picture& blurred, const Window& window, double widest);

/// Mean steepness in levels of an 8-bit sRGB file per pixel, of the pixels not farther than
/// `reach` from a line between two points.
/// @throws std::invalid_argument  for a line outside of the picture.
double MeanSteepness(const witness::Picture& picture, Point from, Point to, double reach);

}  // namespace paper

#endif
