// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharpness.h
/// Blur as the diameter of a disc; steepness of brightness.

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

/// At most `widest` pixels across, by least squares of linear luminance in the window. The sharp picture may be 3, 5 ... times finer;
/// beyond its edge its last pixels go on.
/// @throws std::invalid_argument unfit sizes, a window outside, or without contrast
Blur BlurBetween(const witness::Picture& sharp, const witness::Picture& blurred, const Window& window, double widest);

/// Levels of 8-bit sRGB per pixel, within `reach` of a line.
/// @throws std::invalid_argument a line outside the picture
double MeanSteepness(const witness::Picture& picture, Point from, Point to, double reach);

} // namespace paper

#endif
