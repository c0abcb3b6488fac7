// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file reconstruction.h
/// The picture from its pixels' means: pixels that see the same, as far as their noise lets one tell,
/// are averaged. A non-local means filter whose distance between two pixels is that of their 3 by 3
/// neighbourhoods, less what their estimated variances explain, and in units of these:
///
///     d(p, q) = mean over the neighbourhood of (|p - q|^2 - (var p + min(var p, var q))) / (var p + var q)
///     weight  = exp(-max(0, d)), times the share of samples that q has of p's, at most 1
///
/// with squares and variances summed over the channels.
///
/// It looks at nothing but colours and their variances: no depth, no normals. So a mirror image, a
/// refraction, a medium or a far blurred light is treated as what it looks like. Pixels without noise
/// among their like stay what they are. The step is biased: what it makes equal may differ by less than
/// the noise. It is one of the things that `denoise off` leaves out.
///
/// Source: F. Rousselle, C. Knaus, M. Zwicker, "Adaptive rendering with non-local means filtering",
/// ACM Trans. Graph. 31(6), 2012. Here: one buffer instead of two halves, since the halves of a
/// low-discrepancy sequence are not independent; the error that is left is not estimated from a
/// second filtering of the picture, but from a filtering of the halves' difference: that is noise and
/// nothing else, so what is left of it tells what is left of the picture's noise.

#ifndef TILT_LENS_RECONSTRUCTION_H
#define TILT_LENS_RECONSTRUCTION_H

#include <array>
#include <cstdint>

#include "sampling.h"

namespace tilt_lens
{

/// What is known of a pixel.
struct Estimate
{
    std::array<float, 5> mean{};      ///< as Radiance
    std::array<float, 5> variance{};  ///< of the mean, estimated
    std::array<float, 5> halves{};    ///< difference of the means of its samples' two halves
    float samples = 0.0f;             ///< 0 outside the picture
};

/// However many pixels are averaged, this share of the variance is believed to remain besides what
/// the filter leaves of the noise: what it takes for noise and was a difference, its bias. Read off
/// pictures of textures, edges and lights, where it is between 0.1 and 0.2.
constexpr float kLeastRemains = 0.15f;

/// Side of the squares of pixels that are sampled and rebuilt together.
constexpr std::uint32_t kCell = 8;

/// A cell's pixels and what lies around them, as far as the filter looks.
class Surroundings
{
  public:
    static constexpr int kReach = 4;               ///< pixels from one to the farthest it is averaged with
    static constexpr int kBorder = kReach + 1;     ///< and one more to compare neighbourhoods
    static constexpr int kSide = int(kCell) + 2 * kBorder;

    /// A value of each pixel, row by row.
    using Plane = std::array<float, kSide * kSide>;

    /// @param complete  whether all pixels will be Set; those that are not are outside the picture
    explicit Surroundings(bool complete = false);

    /// @param x, y  relative to the cell's first pixel, -kBorder <= x, y < kCell + kBorder
    void Set(int x, int y, const Estimate& estimate);

    /// Whether filter or transmit are anything anywhere, which they are not in most pictures.
    bool Transparent() const { return transparent; }

    const std::array<Plane, 5>& Means() const { return mean; }
    const std::array<Plane, 5>& Halves() const { return halves; }
    const Plane& Noise() const { return noise; }  ///< sum of the channels' variances
    const Plane& Samples() const { return samples; }

  private:
    std::array<Plane, 5> mean, halves;
    Plane noise, samples;
    bool transparent = false;
};

/// A value of each pixel of a cell, row by row.
using CellPlane = std::array<float, kCell * kCell>;

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

/// @param means  whether the means are wanted too, or only what would remain of the variances
/// @param rows   that are wanted; the others stay as they are
Rebuilt Rebuild(const Surroundings& around, bool means, const Rows& rows = Rows());

} // namespace tilt_lens

#endif
