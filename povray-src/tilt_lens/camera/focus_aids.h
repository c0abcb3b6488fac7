// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file focus_aids.h
/// What the focus aids draw over a picture that is sharp throughout: the tint of focus_peaking, the
/// colours and the scale of focus_map, the surfaces of show_planes. Pure functions of the pixel in the
/// whole picture, so that neither threads nor tiles nor sub-images change one.
///
/// Colours that are made up here are as a display shows them (sRGB, 0 to 1); the caller takes them into
/// the scene's own light. Blur is BlurDiameter() of optics.h: pixels, positive before the plane of sharp focus.

#ifndef TILT_LENS_FOCUS_AIDS_H
#define TILT_LENS_FOCUS_AIDS_H

#include <optional>
#include <vector>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

struct Rgb
{
    double red = 0.0, green = 0.0, blue = 0.0;
};

/// `focus_peaking`, `focus_map` and `show_planes` of a `tilt_lens` block.
struct FocusAids
{
    bool peaking = false, map = false, planes = false;
    Rgb peakingColour;           ///< in the scene's light
    double peakingPixels = 1.0;  ///< what is blurred less counts as sharp

    bool Any() const { return peaking || map || planes; }
};

/// Share of focus_peaking's colour in a sharp pixel; the rest is the picture.
constexpr double kPeakingTint = 0.5;

/// Largest blur that focus_map tells apart, pixels.
constexpr double kMapLimit = 64.0;

/// Where a blur lies on focus_map's scale, from -1 (behind, kMapLimit or more) over 0 (sharp) to 1
/// (before). Logarithmic, so that both one pixel and fifty can be read: sign(b) log(1 + |b|).
double FocusMapPosition(double blur);

/// Blue behind, white where sharp, orange before; the darker, the more blurred. The two hues stay
/// apart in all common kinds of colour blindness, and the brightness tells the amount without them.
Rgb FocusMapColour(double blur);

/// The scale that focus_map draws at the bottom of the picture, with its numbers of pixels.
class FocusMapScale
{
  public:
    /// For a picture of that size. Nothing is drawn where the numbers have no room (below 64 by 40).
    FocusMapScale(int width, int height);

    /// The scale's pixel there, if it covers that of the picture.
    std::optional<Rgb> At(int x, int y) const;

  private:
    int unit = 0;  ///< pixels of the picture in one dot of a digit; 0: no scale
    int left = 0, top = 0, width = 0, height = 0;  ///< of the box, in the picture
    std::vector<Rgb> pixels;

    void Fill(int x, int y, int w, int h, const Rgb& colour);
    void Write(int centre, int y, const char* text);
};

/// A translucent surface in front of what a chief ray meets.
struct Veil
{
    Rgb colour;
    double opacity;
};

/// The surfaces of show_planes: near limit, plane of sharp focus, far limit, the limits being those of a
/// blur of one pixel. The plane of sharp focus carries a grid, so that the eye can follow it.
class FocusPlanes
{
  public:
    FocusPlanes(const Lens& lens, int width, int height);

    /// Surfaces that the chief ray through the middle of a pixel passes on its way to T, nearest first.
    std::vector<Veil> Before(int x, int y, double T) const;

    /// Distance between the grid's lines, in scene units: 1, 2 or 5 times a power of ten.
    double GridSpacing() const { return spacing; }

  private:
    const Lens lens;
    const double width, height;
    Vec3 gridX, gridY;               ///< unit vectors in the plane of sharp focus
    double spacing = 0.0;

    Vec3 Chief(double x, double y) const;
    bool OnGridLine(double x, double y) const;
};

} // namespace tilt_lens

#endif
