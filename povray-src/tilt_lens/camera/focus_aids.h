// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file focus_aids.h
/// Drawings of the focus aids over a picture that is sharp throughout: the tint of focus_peaking, the colours and the scale of focus_map,
/// the surfaces of show_planes. Pure functions of the pixel in the whole picture, independent of threads, tiles and sub-images.
///
/// Colours defined here are display colours (sRGB, 0 to 1); the caller converts them to the scene's light. Blur is BlurDiameter() of
/// optics.h: in pixels, positive before the plane of sharp focus.

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

struct FocusAids
{
    bool peaking = false, map = false, planes = false;
    Rgb peakingColour;           ///< in the scene's light
    double peakingPixels = 1.0;  ///< less blur than this counts as sharp

    bool Any() const { return peaking || map || planes; }
};

/// Share of focus_peaking's colour in a sharp pixel; the rest is the picture.
constexpr double kPeakingTint = 0.5;

/// Largest blur on focus_map's scale, in pixels.
constexpr double kMapLimit = 64.0;

/// Position of a blur on focus_map's scale: -1 (behind, kMapLimit or more), 0 (sharp), 1 (before). Logarithmic, so that both one pixel and
/// fifty can be read: sign(b) log(1 + |b|).
double FocusMapPosition(double blur);

/// Blue behind, white in focus, orange before; darker with more blur. The hues stay apart in all common kinds of colour blindness, and
/// brightness alone tells the amount.
Rgb FocusMapColour(double blur);

/// The scale that focus_map draws at the bottom of the picture, labelled in pixels.
class FocusMapScale
{
  public:
    /// @param width, height  of the picture; below 64 by 40 there is no room and nothing is drawn
    FocusMapScale(int width, int height);

    /// The scale's colour, if it covers this pixel of the picture.
    std::optional<Rgb> At(int x, int y) const;

  private:
    int unit = 0;  ///< pixels in one dot of a character; 0: no scale
    int left = 0, top = 0, width = 0, height = 0;  ///< of the box, in the picture
    std::vector<Rgb> pixels;

    void Fill(int x, int y, int w, int h, const Rgb& colour);
    void Write(int centre, int y, const char* text);
};

/// A translucent surface in front of the surface that a chief ray hits.
struct Veil
{
    Rgb colour;
    double opacity;
};

/// The surfaces of show_planes: near limit, plane of sharp focus, far limit. The limits are those of one pixel of blur. The plane of sharp
/// focus carries a grid, which makes its slope visible.
class FocusPlanes
{
  public:
    /// @param lens  must outlive this
    FocusPlanes(const Lens& lens, int width, int height);

    /// Surfaces that the chief ray through a pixel's centre passes before the ray parameter T, nearest first.
    std::vector<Veil> Before(int x, int y, double T) const;

    /// Distance between the grid's lines, in scene units: 1, 2 or 5 times a power of ten.
    double GridSpacing() const { return spacing; }

  private:
    const Lens& lens;
    const double width, height;
    Vec3 gridX, gridY;               ///< unit vectors in the plane of sharp focus
    double spacing = 0.0;

    Vec3 Chief(double x, double y) const;
    bool OnGridLine(double x, double y) const;
};

} // namespace tilt_lens

#endif
