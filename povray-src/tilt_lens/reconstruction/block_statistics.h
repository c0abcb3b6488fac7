// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_statistics.h
/// Input of the reconstruction: one plane per number.

#ifndef TILT_LENS_BLOCK_STATISTICS_H
#define TILT_LENS_BLOCK_STATISTICS_H

#include <array>
#include <cstddef>
#include <cstdint>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

using BlockPlane = std::array<float, Settings::blockSide * Settings::blockSide>;

class BlockStatistics
{
  public:
    enum Plane
    {
        kMean = 0,
        kNoise = 5,    ///< estimated variance of the mean, summed over the channels
        kMissed = 6,   ///< fraction of noise that only other pixels' samples show
        kSamples = 7,
        kPlanes
    };

    void Set(std::uint32_t x, std::uint32_t y, const Radiance& mean, double noise, double missed, std::uint32_t samples);
    /// Repeats the outermost pixels beyond the picture's edge.
    void RepeatEdges(std::uint32_t width, std::uint32_t height);

    const BlockPlane& operator[](std::size_t plane) const { return planes[plane]; }
    const BlockPlane& Mean(std::size_t channel) const { return planes[kMean + channel]; }
    const BlockPlane& Noise() const { return planes[kNoise]; }
    /// True if any filter or transmit channel is nonzero.
    bool IsTransparent() const { return transparent; }

  private:
    std::array<BlockPlane, kPlanes> planes;
    bool transparent = false;
};

/// First columns and rows of the picture, and the first ones beyond it; pixels from a block's upper left corner.
struct PictureEdges
{
    int left, top, right, bottom;
};

/// Its border is as wide as filters and their risks reach.
class PaddedBlock
{
  public:
    static constexpr int kBorder = Settings::filterRadius + Settings::riskRadius;
    static constexpr int kRows = int(Settings::blockSide) + 2 * kBorder;
    static constexpr int kColumns = (kRows + 3) / 4 * 4;  ///< rounded up to whole vector registers

    using Plane = std::array<float, kRows * kColumns>;

    TILT_LENS_INLINED static constexpr int At(int x, int y) { return (y + kBorder) * kColumns + x + kBorder; }

    /// @param blocks  row by row; for null (outside the picture or unknown) the nearest is mirrored
    PaddedBlock(const std::array<const BlockStatistics*, 9>& blocks, const PictureEdges& edges);

    /// Fills pixels outside the picture with those inside, mirrored at its edges: filters and their risks read them.
    static void Mirror(const PictureEdges& edges, Plane& plane);

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
