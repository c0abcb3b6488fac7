// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// The picture from its pixels' means. A bank of linear filters F smooths it, each by something done across and something
/// done down: nothing, a parabola fitted to 5 or 9 pixels, the mean of 9, the mean of 5 on one side. A pixel becomes the
/// mean of what they make of it, weighted by 1 / risk^2 with Stein's estimate of the risk
///
///     risk = mean over the 7 by 7 pixels q around of (|F q - q|^2 - (1 - 2 F_0) var q) / (var q + kFaint |q|^2)
///
/// where F_0 is a filter's own tap of the pixel, and squares and variances are summed over the channels. What a filter
/// changes is noise that it takes off and error that it makes; what is more than the noise explains is error. It counts in
/// units of a pixel's noise and brightness, since beside a lamp a dark pixel would take harm from what is good for the
/// lamp. Errors that stand out of the noise count in full for the 3 by 3 pixels around, for others at most kLimit times
/// the noise, so that an edge does not keep all that is around it noisy.
///
/// It looks at nothing but colours and their variances: no depth, no normals. So a mirror image, a refraction, a medium or
/// a far blurred light is treated as what it looks like. Pixels among such as have no noise stay what they are. The step is
/// biased: what it smooths may differ by less than the noise. It is one of the things that `denoise off` leaves out.
///
/// Sources: C. M. Stein, "Estimation of the mean of a multivariate normal distribution", Ann. Statist. 9(6), 1981, for the
/// risk; F. Rousselle, C. Knaus, M. Zwicker, "Adaptive sampling and reconstruction using greedy error minimization", ACM
/// Trans. Graph. 30(6), 2011, and T.-M. Li, Y.-T. Wu, Y.-Y. Chuang, "SURE-based optimization for adaptive sampling and
/// reconstruction", ACM Trans. Graph. 31(6), 2012, for choosing among filters by it; A. Savitzky, M. J. E. Golay,
/// "Smoothing and differentiation of data by simplified least squares procedures", Anal. Chem. 36(8), 1964, for the
/// parabolas. Here: no one filter is chosen, since the choice would be as noisy as the risk; and what is left of the
/// variance is not told by the risk, which may be none by chance, but by filtering the difference of the samples' halves,
/// which is noise and nothing else.

#ifndef TILT_LENS_RECONSTRUCTION_H
#define TILT_LENS_RECONSTRUCTION_H

#include <array>
#include <cstdint>

#include "tilt_lens/sampling/sampling.h"

namespace tilt_lens
{

/// However many pixels are averaged, this share of the variance is believed to remain besides what
/// the filters leave of the noise: what they take for noise and was a difference, their bias. With it,
/// claims are 0.8 to 1.2 of the errors of the benchmark's pictures (variance 0.002 and 0.0002).
constexpr float kLeastRemains = 0.15f;

/// Side of the squares of pixels that are sampled and rebuilt together.
constexpr std::uint32_t kCell = 16;

/// A value of each pixel of a cell, row by row.
using CellPlane = std::array<float, kCell * kCell>;

/// What is known of a cell's pixels. Beyond the picture's edge pixels are repeated.
struct Estimates
{
    std::array<CellPlane, 5> mean;    ///< as Radiance
    std::array<CellPlane, 5> halves;  ///< difference of the means of a pixel's samples' two halves
    CellPlane noise;                  ///< variance of the mean, estimated, summed over the channels
    bool transparent = false;         ///< whether filter or transmit are anything anywhere

    void Set(std::uint32_t x, std::uint32_t y, const Radiance& mean, const Radiance& halves, double noise);
    /// @param width, height  of what was Set
    void RepeatEdges(std::uint32_t width, std::uint32_t height);
};

/// A cell's pixels and what lies around them, as far as filters and their risks look.
class Surroundings
{
  public:
    static constexpr int kReach = 4;                  ///< of a filter, pixels
    static constexpr int kJudged = 3;                 ///< from a pixel to the farthest whose risk counts
    static constexpr int kBorder = kReach + kJudged;
    static constexpr int kRows = int(kCell) + 2 * kBorder;
    static constexpr int kColumns = (kRows + 3) / 4 * 4;  ///< as many, rounded up to whole vector registers

    using Plane = std::array<float, kRows * kColumns>;

    /// Where in a Plane pixel (x, y) is, relative to the cell's first one, -kBorder <= x, y < kCell + kBorder.
    static constexpr int At(int x, int y) { return (y + kBorder) * kColumns + x + kBorder; }

    /// @param cells  the cell, which is in the middle, and its eight neighbours, row by row. Those that are null are
    ///               outside the picture or not known: there the nearest cell is mirrored.
    explicit Surroundings(const std::array<const Estimates*, 9>& cells);

    bool Transparent() const { return transparent; }
    const std::array<Plane, 5>& Means() const { return mean; }
    const std::array<Plane, 5>& Halves() const { return halves; }
    const Plane& Noise() const { return noise; }

  private:
    std::array<Plane, 5> mean, halves;
    Plane noise;
    bool transparent = false;
};

/// Rows of a cell, from the first to before the end.
struct Rows
{
    int begin = 0, end = int(kCell);

    bool IsEmpty() const { return begin >= end; }
    bool Has(int row) const { return row >= begin && row < end; }
};

/// A cell's pixels rebuilt.
struct Rebuilt
{
    std::array<CellPlane, 5> mean;
    CellPlane remains;  ///< of a pixel's variance: the share that averaging leaves, (0, 1]

    /// No light (IsLight) beside a pixel that is brighter than a float can hold.
    Radiance MeanOf(std::size_t pixel) const;
};

/// @param rows  that are wanted; the others stay as they are
Rebuilt Rebuild(const Surroundings& around, const Rows& rows = Rows());

} // namespace tilt_lens

#endif
