// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file focus_aids.h
/// Drawings over a sharp picture. Colours are sRGB, 0 to 1; blur is that of optics.h.

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
    Rgb peakingColour;           ///< scene light, not sRGB
    double peakingPixels = 1.0;  ///< less blur counts as sharp

    bool Any() const { return peaking || map || planes; }
};

constexpr double kPeakingTint = 0.5;

/// Pixels.
constexpr double kMapLimit = 64.0;

/// sign(b) log(1 + |b|), from -1 (behind, kMapLimit or more) to 1 (before).
double FocusMapPosition(double blur);

/// Blue behind, white in focus, orange before; darker with blur.
Rgb FocusMapColour(double blur);

class FocusMapScale
{
  public:
    /// Draws nothing below 64 by 40.
    FocusMapScale(int width, int height);

    std::optional<Rgb> At(int x, int y) const;

  private:
    int unit = 0;  ///< pixels per dot of a character; 0: no scale
    int left = 0, top = 0, width = 0, height = 0;
    std::vector<Rgb> pixels;

    void Fill(int x, int y, int w, int h, const Rgb& colour);
    void Write(int centre, int y, const char* text);
};

struct Veil
{
    Rgb colour;
    double opacity;
};

/// Plane of sharp focus, and limits for a blur of one pixel, with a grid.
class FocusPlanes
{
  public:
    /// @param lens  must outlive this
    FocusPlanes(const Lens& lens, int width, int height);

    /// Surfaces before the point T of a pixel's chief ray, nearest first.
    std::vector<Veil> Before(int x, int y, double T) const;

    /// Scene units.
    double GridSpacing() const { return spacing; }

  private:
    const Lens& lens;
    const double width, height;
    Vec3 gridX, gridY;               ///< unit, in the plane of sharp focus
    double spacing = 0.0;

    Vec3 Chief(double x, double y) const;
    bool OnGridLine(double x, double y) const;
};

} // namespace tilt_lens

#endif
