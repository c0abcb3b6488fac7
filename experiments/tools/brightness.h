// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file brightness.h
/// Brightness of pictures along a line and in windows, in 8-bit levels and pixels. Image coordinates from the upper
/// left corner: the middle of the first pixel is (0.5, 0.5).

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

/// Linear luminance of a pixel, Rec. 709 weights.
double Luminance(const witness::Picture& picture, int column, int row);

/// A linear value as a level from 0 to 255 of an 8-bit sRGB file, not rounded.
double Level(double linear);

/// Brightness on a straight line between two points of the image, in levels from 0 to 255 of an
/// 8-bit sRGB file, not rounded: luminance (Rec. 709 weights) at evenly spaced points, ends
/// included, bilinear between the middles of pixels.
/// @throws std::invalid_argument  for a line that leaves the picture or fewer than two points.
std::vector<double> Profile(const witness::Picture& picture, Point from, Point to, int count);

/// Mean of the absolute differences of two profiles of one length.
double AverageDifference(const std::vector<double>& a, const std::vector<double>& b);

/// Light in a window of the picture: its sum, centroid and second central moments, linear values.
struct Moments
{
    double sum = 0.0;                     ///< of the linear luminance of the pixels
    Point centroid;                       ///< pixels
    double xx = 0.0, xy = 0.0, yy = 0.0;  ///< pixels squared; x right, y down
};

/// @throws std::invalid_argument  for a window that leaves the picture or holds no light.
Moments MomentsIn(const witness::Picture& picture, int left, int top, int width, int height);

/// Ends of a bright thing on black in one row, to a fraction of a pixel: from the light left and right of a column
/// within it, in units of the light of that column.
struct Edges
{
    double left = 0.0, right = 0.0;  ///< pixels
};
Edges EdgesIn(const witness::Picture& picture, int row, int inside);

}  // namespace paper

#endif
