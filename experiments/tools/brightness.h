// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file brightness.h
/// Brightness in 8-bit levels. Pixels from the upper left corner: the first's middle is (0.5, 0.5).

#ifndef PAPER_BRIGHTNESS_H
#define PAPER_BRIGHTNESS_H

#include <vector>

#include "picture.h"

namespace paper
{

struct Point
{
    double x = 0.0, y = 0.0;  ///< pixels
};

/// Linear, Rec. 709 weights.
double Luminance(const witness::Picture& picture, int column, int row);

/// 0 to 255 of sRGB, not rounded.
double Level(double linear);

/// In levels, not rounded: Rec. 709 luminance at even steps, ends included, bilinear.
/// @throws std::invalid_argument the line leaves the picture, or fewer than two points
std::vector<double> Profile(const witness::Picture& picture, Point from, Point to, int count);

double AverageDifference(const std::vector<double>& a, const std::vector<double>& b);

struct Moments
{
    double sum = 0.0;                     ///< linear luminance
    Point centroid;                       ///< pixels
    double xx = 0.0, xy = 0.0, yy = 0.0;  ///< pixels squared; x right, y down
};

/// @throws std::invalid_argument the window leaves the picture or holds no light
Moments MomentsIn(const witness::Picture& picture, int left, int top, int width, int height);

/// In one row on black, to a fraction of a pixel, in units of the light of a column within.
struct Edges
{
    double left = 0.0, right = 0.0;  ///< pixels
};
Edges EdgesIn(const witness::Picture& picture, int row, int inside);

} // namespace paper

#endif
