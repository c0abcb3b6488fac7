// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_statistics.h
/// What the reconstruction knows of the pixels of a block, and of those around it: planes of one number a pixel.
///
/// A further number of each pixel is one more name of BlockStatistics::Plane; edges, borders and copies then follow.

#ifndef TILT_LENS_BLOCK_STATISTICS_H
#define TILT_LENS_BLOCK_STATISTICS_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// A value of each pixel of a block, row by row.
using BlockPlane = std::array<float, settings.blockSide * settings.blockSide>;

/// What is known of a block's pixels. Beyond the picture's edge pixels are repeated.
class BlockStatistics
{
  public:
    /// What there is of each pixel: five channels as Radiance has them, or one number.
    enum Plane
    {
        kMean = 0,                  ///< five channels
        kNoise = 5,    ///< variance of the mean and its undetected error, estimated, summed over the channels
        kMissed = 6,   ///< share of the noise that other pixels' samples tell and the pixel's own do not, [0, 1]
        kSamples = 7,  ///< taken
        kPlanes
    };

    void Set(std::uint32_t x, std::uint32_t y, const Radiance& mean, double noise, double missed, std::uint32_t samples);
    /// @param width, height  of what was Set
    void RepeatEdges(std::uint32_t width, std::uint32_t height);

    const BlockPlane& operator[](std::size_t plane) const { return planes[plane]; }
    const BlockPlane& Mean(std::size_t channel) const { return planes[kMean + channel]; }
    const BlockPlane& Noise() const { return planes[kNoise]; }
    /// Whether filter or transmit are not zero anywhere.
    bool IsTransparent() const { return transparent; }

  private:
    std::array<BlockPlane, kPlanes> planes;
    bool transparent = false;
};

/// A block's pixels and those around it, as far as filters and their risks look.
class PaddedBlock
{
  public:
    static constexpr int kBorder = settings.filterRadius + settings.riskRadius;
    static constexpr int kRows = int(settings.blockSide) + 2 * kBorder;
    static constexpr int kColumns = (kRows + 3) / 4 * 4;  ///< as many, rounded up to whole vector registers

    using Plane = std::array<float, kRows * kColumns>;

    /// Where in a Plane pixel (x, y) is, relative to the block's first one, -kBorder <= x, y < blockSide + kBorder.
    static constexpr int At(int x, int y) { return (y + kBorder) * kColumns + x + kBorder; }

    /// @param blocks  the block, which is in the middle, and its eight neighbours, row by row. Those that are null are
    ///                outside the picture or not known: there the nearest block is mirrored.
    explicit PaddedBlock(const std::array<const BlockStatistics*, 9>& blocks);

    const Plane& Mean(std::size_t channel) const { return planes[BlockStatistics::kMean + channel]; }
    const Plane& Noise() const { return planes[BlockStatistics::kNoise]; }
    const Plane& Missed() const { return planes[BlockStatistics::kMissed]; }
    const Plane& Samples() const { return planes[BlockStatistics::kSamples]; }
    bool IsTransparent() const { return transparent; }

  private:
    std::array<Plane, BlockStatistics::kPlanes> planes;
    bool transparent = false;
};

} // namespace tilt_lens

#endif
