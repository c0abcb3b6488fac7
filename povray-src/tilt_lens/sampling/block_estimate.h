// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block_estimate.h
/// What is known of a block's pixels between two rounds of samples: plain data that the functions of convergence.h,
/// variance_ratio.h and denoiser_forecast.h read and update.

#ifndef TILT_LENS_BLOCK_ESTIMATE_H
#define TILT_LENS_BLOCK_ESTIMATE_H

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/reconstruction/block_statistics.h"
#include "tilt_lens/reconstruction/padded_spread.h"
#include "tilt_lens/sampling/circle_variance.h"
#include "tilt_lens/sampling/pixel_statistics.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

struct PixelEstimate
{
    PixelStatistics statistics;
    double varianceRatio = 1.0;  ///< of the mean's variance to that of as many independent samples
    double variance = 0.0;       ///< of the mean, largest channel; relative to the square of what is above 1
    double undetected = 0.0;     ///< of that, what the samples do not show
    double undetectedNoise = 0.0;  ///< the same, summed over the channels and not relative
    Radiance seenVariance{};     ///< of one sample, by the pixel's own and those of its circles
    double target = 0.0;         ///< the variance that it may keep, when it was decided last
    double excess = 0.0;         ///< variance after the reconstruction, by the last forecast, over its target, when it was decided last
    double residualVarianceRatio = 1.0 / settings.greatestRisk;  ///< after the reconstruction, by the last forecast
    bool active = true;          ///< takes part in the next round
};

/// A value of each quadrant of a block: upper left, upper right, lower left, lower right.
using Quadrants = std::array<double, 4>;

struct BlockEstimate
{
    Area area;
    std::uint32_t firstSamples = 0;             ///< of each pixel in the first round
    std::vector<PixelEstimate> pixels;          ///< row by row
    Quadrants dualBufferRatio{1.0, 1.0, 1.0, 1.0};  ///< variance by the dual buffers over that of independent samples
    std::shared_ptr<const BlockStatistics> statistics;  ///< for the reconstruction; null: nothing is denoised
    std::uint32_t statisticsSamples = 0;        ///< of an active pixel, when `statistics` were made; 0: never
    std::shared_ptr<const PaddedSpread> spread; ///< sent to this block by itself and its neighbours; null: nothing, or not yet known

    explicit BlockEstimate(const Area& area) : area(area), pixels(area.Size()) {}

    std::size_t QuadrantOf(std::size_t pixel) const
    {
        return 2 * (pixel / area.width / (settings.blockSide / 2)) + pixel % area.width / (settings.blockSide / 2);
    }
    /// By the samples that other pixels have sent to a pixel.
    CircleVariance CircleVarianceOf(std::size_t pixel) const
    {
        return CircleVariance(spread.get(), PlaceOf(pixel), pixels[pixel].statistics.Samples());
    }
    double SamplesReceivedBy(std::size_t pixel) const { return spread ? spread->SamplesAt(PlaceOf(pixel)) : 0.0; }
    /// Place of a pixel in a plane of `spread`.
    std::size_t PlaceOf(std::size_t pixel) const { return PaddedBlock::At(int(pixel % area.width), int(pixel / area.width)); }
    /// Whether no sample of any pixel differs from its others.
    bool IsUniform() const;
};

/// What other blocks see of a pixel: its samples of the first round.
struct FirstRoundPixel
{
    SampleVariation variation;
    double deviation = 0.0;   ///< standard deviation of one sample, largest channel; relative to what is above 1
};

/// What other blocks see of a block, all of its first round. Immutable.
struct FirstRound
{
    Area area;
    std::uint32_t samples;                ///< of each pixel
    std::vector<FirstRoundPixel> pixels;  ///< row by row
    bool uniform;                         ///< no sample differs from the others of its pixel
    double loneVariance = 0.0;            ///< mean of what a pixel's samples vary more than those of the eight pixels around it together; relative
    std::shared_ptr<const BlockStatistics> statistics;  ///< null: nothing is denoised
    std::shared_ptr<const SpreadSums> spread;           ///< what its samples have sent to other pixels; null: nothing

    explicit FirstRound(const BlockEstimate& estimate);

    const FirstRoundPixel& At(std::uint32_t x, std::uint32_t y) const { return pixels[area.IndexOf(x, y)]; }

  private:
    double LoneVarianceOf(std::uint32_t column, std::uint32_t row) const;
};

/// A block's first round and those of its eight neighbours, row by row; null outside the picture or where they are not
/// asked for.
using FirstRounds = std::array<const FirstRound*, 9>;

/// The one of them that holds a pixel of the block or beside it, or null.
const FirstRound* FirstRoundAt(const FirstRounds& rounds, std::int64_t x, std::int64_t y);

} // namespace tilt_lens

#endif
