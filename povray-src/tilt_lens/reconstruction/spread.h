// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file spread.h
/// Each sample serves all pixels of its circle of confusion: docs/sampling.md, section 8. A point that a ray has hit is seen
/// by every pixel of its circle, so its radiance is spread over them. What a pixel has received, over the shares that it has
/// received, is the spread estimate S of the pixel, made of the rays of many.
///
/// Samples reach at most kReach pixels, so that of a wide circle some parts of the lens send a pixel more samples than others.
/// A share is therefore one over the number of pixels that could have sent the pixel that sample (the balance heuristic).
///
/// S knows nothing of what hides the point from other pixels, and is no more than a candidate of the reconstruction.
///
/// Source: M. Potmesil, I. Chakravarty, "A lens and aperture camera model for synthetic image generation", SIGGRAPH 1981, for
/// spreading points over their circles of confusion; here the points are hits of distributed rays.

#ifndef TILT_LENS_SPREAD_H
#define TILT_LENS_SPREAD_H

#include <array>
#include <cstdint>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/math/area.h"
#include "tilt_lens/math/radiance.h"
#include "tilt_lens/math/simd.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

class LensFootprint;
struct CirclePixels;

/// The pixels that see a point through some part of the lens, to first order: a pixel at `x, y` - M (a, b) sees it through
/// the lens point (a, b), in aperture coordinates. Pixels to the right and down.
struct CircleOfConfusion
{
    float x = 0.0f, y = 0.0f;        ///< where the point lies in the pinhole picture
    float xa = 0.0f, xb = 0.0f, ya = 0.0f, yb = 0.0f;  ///< M, row by row
    const LensFootprint* lens = nullptr;               ///< null: the point serves its own pixel alone
};

/// The first of several points in aperture coordinates, or the step from one to the next.
struct AperturePoints
{
    float a, b;
};

/// What circles of confusion look like through a lens. Immutable: threads share it.
class LensFootprint
{
  public:
    /// @param width, height  of the whole picture, pixels
    LensFootprint(const Lens& lens, const Aperture& aperture, double width, double height);

    /// @param point  of the lens, that the ray came through
    /// @param vergence  1/T - w, with T the ray's parameter of the hit and w as MakeRay gives it
    CircleOfConfusion CircleOf(const FilmPoint& film, const AperturePoint& point, double vergence) const;

    /// Radius of a circle around the opening, in aperture coordinates.
    float BoundingRadius() const { return boundingRadius; }
    /// Whether the opening is the unit disc, evenly bright.
    bool IsDisc() const { return density.empty(); }
    /// Brightness of an opening that is not the unit disc, relative, at `count` points.
    void FindDensities(const AperturePoints& first, const AperturePoints& step, int count, float* densities) const;

  private:
    struct Axis
    {
        double x, y, depth;  ///< of a lens axis: along the film in frames, and along the camera's axis in units of `direction`
        double focus;        ///< its product with the lens's focus vector k
    } axisA, axisB;
    double width, height;
    float boundingRadius;
    std::vector<float> density;
};

/// The columns or the rows of the whole picture, relative to the first of a block.
struct PictureSpan
{
    float begin, end;
};

/// Whether the circle holds the centre of a pixel other than the sample's own.
bool ServesOthers(const CircleOfConfusion& circle);

/// The samples that the pixels of a block send to the pixels at most kReach away.
class SpreadSums
{
  public:
    /// Pixels, along rows and columns, from a sample's own pixel to the farthest that it serves.
    static constexpr int kReach = settings.spreadReach;
    static constexpr int kSide = int(settings.blockSide) + 2 * kReach;
    /// Pixels that the widest vector holds.
    static constexpr int kMostLanes = sizeof(Float8) / sizeof(float);

    /// Sums of the shares of samples times their weights: of red, green, blue, of 1, and of the squared colours, summed over the channels.
    /// The last one is of the shares alone.
    enum Sum { kRed, kGreen, kBlue, kShare, kSquares, kSamples, kSums };

    /// @param block  whose pixels send, in the whole picture
    /// @param width, height  of the whole picture, pixels
    SpreadSums(const Area& block, double width, double height);

    /// @param column, row  of the sample's pixel in the block
    /// @param circle  with a centre relative to the block's upper left corner
    /// @param weight  of the sample; the weights of each pixel's samples have the same sum, so that a surface does not count more where
    ///     more rays have met it
    void Add(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight = 1.0f);
    /// The same on processors without AVX2, with the same sums to the last bit.
    void AddPlain(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight = 1.0f);
    /// Samples that serve their own pixel alone.
    void AddSharp(int column, int row, float weight);

    /// A sum that pixel (x, y), -kReach <= x, y < blockSide + kReach, and those to the right of it have received from other pixels.
    const float* From(Sum sum, int x, int y) const { return &sums[sum][PlaceOf(x, y)]; }
    /// Shares that the samples of a pixel of the block kept for it, times their weights, summed; and the sum of these weights.
    float OwnShare(int x, int y) const { return own[y * int(settings.blockSide) + x].share; }
    float OwnWeight(int x, int y) const { return own[y * int(settings.blockSide) + x].weight; }
    /// Sum of the weights of the samples of each pixel of the block.
    float PixelWeight() const { return own[0].weight; }
    /// Whether any sample has served another pixel.
    bool IsSpread() const { return spread; }

  private:
    struct Own
    {
        float share = 0.0f, weight = 0.0f;
    };

    /// A number of each pixel; what fills the last vector of the last row is not used.
    using Plane = std::array<float, kSide * kSide + kMostLanes>;

    PictureSpan columns, rows;
    std::array<Plane, kSums> sums{};
    std::array<Own, settings.blockSide * settings.blockSide> own{};
    bool spread = false;

    static constexpr int PlaceOf(int x, int y) { return (y + kReach) * kSide + x + kReach; }

    // Written once and compiled for each kind of processor.
    template<class Vector>
    void AddBy(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight);
    /// @param density  of the lens at each of the pixels; null: the same at all
    /// @param sum      of these
    /// @param value    red, green, blue and 1
    template<class Vector>
    void Send(const CirclePixels& pixels, const float* density, float sum, const Float4& value, float weight, int column, int row);
    TILT_LENS_FOR_AVX2 void AddByAvx2(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight);
};

} // namespace tilt_lens

#endif
