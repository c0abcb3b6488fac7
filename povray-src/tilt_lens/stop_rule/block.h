// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block.h
/// Adaptive sampling of a block, a square of pixels on a grid fixed to the whole picture: docs/sampling.md, section 1.
///
/// Render threads enter by tile_sampler.h; samples/sample.h is the interface to the ray tracer.
///
/// A block is computed in three steps. Each reads only results of the previous one, of the block and its eight neighbours:
///
///     look      a first round of samples
///     converge  further rounds, until the stop rule holds
///     finish    further rounds where all samples around show that something was missed, then the reconstruction
///
/// Results depend on positions in the picture alone, never on threads or tiles (section 7). Any thread may request any step; the first one
/// takes it. If the tracer throws, the block stays unchanged.

#ifndef TILT_LENS_BLOCK_H
#define TILT_LENS_BLOCK_H

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/samples/sample.h"
#include "tilt_lens/samples/sampling_limits.h"
#include "tilt_lens/stop_rule/block_estimate.h"
#include "tilt_lens/stop_rule/sent_samples.h"

namespace tilt_lens
{

struct PixelResult
{
    float variance = 0.0f;  ///< of the mean, averaged over colours, relative to SquaredScale
    std::array<float, 5> mean{};
    std::uint32_t samples = 0, notFinite = 0, emitterSamples = 0;
    bool reconstructed = false;
};

class Block
{
  public:
    /// The block and its eight neighbours, row by row; null outside the picture.
    using Neighbours = std::array<const Block*, 9>;

    static constexpr int kSteps = 3;

    /// @param step  1 to kSteps
    static bool LooksAtNeighbours(int step, const SamplingLimits& limits)
    {
        return step == 2 ? limits.variance > 0.0 : step == kSteps && limits.Denoises();
    }

    /// @param width, height  whole picture, pixels
    Block(const Area& area, std::uint32_t width, std::uint32_t height, const Settings& settings) :
        area(area),
        edges{-int(area.left), -int(area.top), int(width - area.left), int(height - area.top)},
        sent(area, width, height, settings.mostSentSamples)
    {
    }

    const Area area;

    int StepsTaken() const { return phase / 2; }
    /// The block and its neighbours must have taken `stepsTaken` steps.
    /// @return  false if another thread has begun the step
    bool TakeStep(int stepsTaken, const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);

    /// Valid after all steps; (x, y) in the whole picture.
    const PixelResult& ResultOf(std::uint32_t x, std::uint32_t y) const { return results[area.IndexOf(x, y)]; }
    /// Mean square error of the block, bias included, over the mean of its variances. Negative by chance: for sums over many blocks.
    float RiskOverVariance() const { return riskOverVariance; }

  private:
    const PictureEdges edges;
    std::atomic<int> phase{0};  ///< twice the steps taken, plus 1 during a step

    /// @name Left by the first step
    /// @{
    std::unique_ptr<FirstRound> firstRound;
    /// @}
    /// @name Left by the second step
    /// @{
    std::shared_ptr<const BlockStatistics> statistics;  ///< null: no denoising
    std::shared_ptr<const SpreadSums> spread;  ///< of all rounds so far; null: none
    /// @}
    /// @name Read by this block alone
    /// @{
    std::unique_ptr<const BlockEstimate> estimate;  ///< until the last step
    SentSamples sent;  ///< until the second step
    std::vector<PixelResult> results;
    float riskOverVariance = 1.0f;
    /// @}

    void Look(const SamplingLimits& limits, const Tracer& trace);
    void Converge(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);
    void Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);

    /// @param samples  fewest samples of an active pixel
    void TakeRounds(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples,
                    SentSamples* sent, const Tracer& trace) const;
    void SetResults(const BlockEstimate& last, const SamplingLimits& limits, double loneVariance);
    void ReconstructResults(const Neighbours& neighbours, const SamplingLimits& limits, const BlockStatistics* own,
                            const PaddedSpread* received);
    /// From the first row with noise to the last.
    Rows NoisyRows() const;
};

}  // namespace tilt_lens

#endif
