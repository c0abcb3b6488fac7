// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file spread.h
/// Spreads each sample over its circle of confusion: docs/sampling.md, section 5. Occlusion is ignored.

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

/// The pixels that see a point, to first order: the pixel with the centre (`x`, `y`) - M (a, b) sees it through the lens point (a, b), in
/// aperture coordinates. It sees it from the place in its square that the sample has in its own. Frame: pixels to the right and down.
struct CircleOfConfusion
{
    float x = 0.0f, y = 0.0f;  ///< place in the pinhole picture, less that of the sample from its pixel's centre
    float xa = 0.0f, xb = 0.0f, ya = 0.0f, yb = 0.0f;  ///< M, row by row
    const LensFootprint* lens = nullptr;  ///< null: serves its own pixel alone
    float weight = 1.0f;  ///< CameraSample::overPlain
};

/// The lens's density: a grid of Settings::densityCells squared cells over the square around the aperture.
struct DensityTable
{
    const float* cells;  ///< row by row; relative brightness
    float scale;         ///< cells for each unit of aperture coordinates; the grid's middle is their origin

    /// A place along a or b, in cells.
    TILT_LENS_INLINED float PlaceOf(float coordinate) const { return coordinate * scale + 0.5f * Settings::densityCells; }
};

/// Immutable and thread-safe.
class LensFootprint
{
  public:
    /// @param width, height  whole picture, pixels
    LensFootprint(const Lens& lens, const Aperture& aperture, double width, double height);

    /// @param vergence  1/T - w, with the hit's ray parameter T, and w as in MakeRay
    CircleOfConfusion CircleOf(const FilmPoint& film, const AperturePoint& point, double vergence) const;

    /// In aperture coordinates.
    TILT_LENS_INLINED float BoundingRadius() const { return boundingRadius; }
    TILT_LENS_INLINED bool IsDisc() const { return isDisc; }
    /// Empty for a disc.
    DensityTable Density() const;

  private:
    struct Axis
    {
        /// Along the film, in frame widths and heights; along the camera's axis, in units of `direction`.
        double x, y, depth;
        double focus;  ///< dot product with the lens's k
    } axisA, axisB;
    double width, height;
    float boundingRadius;
    bool isDisc;
    std::vector<float> density;  ///< empty for a disc
};

/// Range of the picture's columns or rows, relative to the block's first.
struct PictureSpan
{
    float begin, end;
};

/// True if the circle contains another pixel's centre.
bool ServesOthers(const CircleOfConfusion& circle);

/// Samples of one pixel that serve no other.
struct SharpSamples
{
    float light[3]{}, squares = 0.0f, weights = 0.0f;  ///< sums of radiance, its square, and CircleOfConfusion::weight
    std::uint32_t count = 0;

    /// A radiance that is not finite counts as black.
    void Add(const Radiance& radiance, float weight);
};

struct SpreadPlanes
{
    /// Greatest spread along rows and columns, pixels.
    static constexpr int kReach = Settings::spreadReach;
    static constexpr int kSide = int(Settings::blockSide) + 2 * kReach;
    static constexpr int kMostLanes = sizeof(Float8) / sizeof(float);

    /// Sums of weighted shares, times red, green, blue, the circle's weight, and squared colour; last, of squared weighted shares.
    enum Sum
    {
        kRed,
        kGreen,
        kBlue,
        kShare,
        kSquares,
        kSquaredShares,
        kSums
    };

    struct Own
    {
        float share, weight;
    };

    PictureSpan columns, rows;
    float sums[kSums][kSide * kSide + kMostLanes];  ///< one per pixel, padded to a whole vector
    Own own[Settings::blockSide * Settings::blockSide];
    bool spread;

    TILT_LENS_INLINED static constexpr int PlaceOf(int x, int y) { return (y + kReach) * kSide + x + kReach; }
};

class SpreadSums : private SpreadPlanes
{
  public:
    using SpreadPlanes::kReach, SpreadPlanes::kSide;
    using SpreadPlanes::Sum, SpreadPlanes::kRed, SpreadPlanes::kGreen, SpreadPlanes::kBlue, SpreadPlanes::kShare, SpreadPlanes::kSquares,
        SpreadPlanes::kSquaredShares, SpreadPlanes::kSums;

    /// @param block  in the whole picture
    /// @param width, height  whole picture, pixels
    SpreadSums(const Area& block, double width, double height);

    /// @param column, row  in the block
    /// @param circle       centre relative to the block's upper left corner
    /// @param weight       equal sum for every pixel: a surface is not brighter where more rays have hit it
    void Add(int column, int row, const CircleOfConfusion& circle, const Radiance& radiance, float weight = 1.0f);
    void Add(int column, int row, const SharpSamples& sharp, float weight);

    /// For pixel (x, y) and those to its right, its own samples included; -kReach <= x, y < blockSide + kReach.
    const float* From(Sum sum, int x, int y) const { return &sums[sum][PlaceOf(x, y)]; }
    /// Weighted shares that a pixel's samples kept for it.
    float OwnShare(int x, int y) const { return own[y * int(Settings::blockSide) + x].share; }
    float OwnWeight(int x, int y) const { return own[y * int(Settings::blockSide) + x].weight; }
    bool IsSpread() const { return spread; }
};

}  // namespace tilt_lens

#endif
