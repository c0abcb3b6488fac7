// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_estimate.h
/// A block's pixels between two rounds, and its first round as its neighbours see it.

#ifndef TILT_LENS_BLOCK_ESTIMATE_H
#define TILT_LENS_BLOCK_ESTIMATE_H

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/padded_spread.h"
#include "tilt_lens/samples/sampling_limits.h"
#include "tilt_lens/settings.h"
#include "tilt_lens/stop_rule/pixel_statistics.h"

namespace tilt_lens
{

struct PixelEstimate
{
    PixelStatistics statistics;
    float varianceRatio = 1.0f;  ///< variance of the mean over that of as many independent samples
    float variance = 0.0f;       ///< DecisiveVariance() of the mean, relative to SquaredScale
    float target = 0.0f;         ///< variance target, at the last decision
    float excess = 0.0f;         ///< variance after the reconstruction over the target, at the last decision
    float residualVarianceBound = 1.0f;  ///< predicted by the last forecast
    bool forecast = false;       ///< `excess` counts on this bound
    bool active = true;
};

/// Upper left, upper right, lower left, lower right.
using Quadrants = std::array<double, 4>;

struct BlockEstimate
{
    Area area;
    PictureEdges edges;
    std::vector<PixelEstimate> pixels;          ///< row by row
    Quadrants dualBufferRatio{1.0, 1.0, 1.0, 1.0};  ///< variance by dual buffers over that of independent samples
    std::shared_ptr<const BlockStatistics> statistics;  ///< null: no denoising
    std::uint32_t statisticsSamples = 0;        ///< active pixels' samples in `statistics`; 0: never computed
    std::shared_ptr<const PaddedSpread> spread; ///< received from the block and its neighbours; null: none or unknown

    Settings settings;

    BlockEstimate(const Area& area, const PictureEdges& edges, const Settings& settings);

    std::size_t QuadrantOf(std::size_t pixel) const
    {
        return 2 * (pixel / area.width / (Settings::blockSide / 2)) + pixel % area.width / (Settings::blockSide / 2);
    }
    /// Share of a pixel's samples that serves other pixels, [0, 1).
    double SharedPart(std::size_t pixel) const { return spread ? 1.0 - spread->ownShare[PlaceOf(pixel)] : 0.0; }
    std::size_t PlaceOf(std::size_t pixel) const { return PaddedBlock::At(int(pixel % area.width), int(pixel / area.width)); }
    /// Greatest excess with which a pixel may converge.
    double GreatestExcess(std::size_t pixel) const
    {
        return std::max(1.0, pixels[pixel].statistics.Samples() / Settings::samplesPerTarget);
    }
    /// False if each pixel's samples are equal and none were received.
    bool HasNoise() const;
};

/// Immutable until its block's last step, which frees the parts that no neighbour reads any more.
struct FirstRound
{
    std::size_t pixels;
    double deviation = 1.0;      ///< MeanDeviation()
    double loneVariance = 0.0;   ///< mean excess of a pixel's variance over its eight neighbours' sum; relative
    std::shared_ptr<const BlockStatistics> statistics;  ///< null: no denoising
    std::shared_ptr<const SpreadSums> spread;           ///< null: none

    explicit FirstRound(const BlockEstimate& estimate);
};

/// Row by row, the block's own in the middle; null outside the picture or if not needed.
using FirstRounds = std::array<const FirstRound*, 9>;

struct Neighbourhood
{
    const FirstRounds rounds;  ///< must outlive this object
    double loneVariance = 0.0;  ///< mean over all pixels
    double deviationRatio = 1.0;  ///< mean FirstRound::deviation over all pixels, over that of the block in the middle

    Neighbourhood(const FirstRounds& rounds, const SamplingLimits& limits);
};

template<class Part, class Whole, class Member>
std::array<const Part*, 9> EachOf(const std::array<const Whole*, 9>& objects, Member Whole::* member)
{
    std::array<const Part*, 9> parts{};
    for (std::size_t i = 0; i < parts.size(); i++)
        if (objects[i] != nullptr)
            parts[i] = (objects[i]->*member).get();
    return parts;
}

} // namespace tilt_lens

#endif
