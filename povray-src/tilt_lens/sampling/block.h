// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block.h
/// A square of pixels on a grid fixed to the whole picture: docs/sampling.md, section 1.
///
/// A block is made in three steps, each of which reads only what the step before has left of the block and of its eight neighbours:
///
///     look      a first round of samples
///     converge  further rounds, until the stop rule is content with the block's own samples and its neighbours' first rounds
///     finish    further rounds where the samples of all rounds around tell that pixels have missed something, then the reconstruction
///
/// Values depend on places in the picture alone, so that neither threads nor tiles nor sub-images change one (section 10).
/// Threads may ask for any step at any time: each is taken once, by the first that asks, and nobody waits for it here. A step that is
/// broken off by an exception of the tracer leaves the block as it was.

#ifndef TILT_LENS_BLOCK_H
#define TILT_LENS_BLOCK_H

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/sampling/block_estimate.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sampling_limits.h"
#include "tilt_lens/sampling/sent_samples.h"

namespace tilt_lens
{

/// A pixel after its last sample.
struct PixelResult
{
    double variance = 0.0;  ///< of the mean, largest channel; relative to the square of what is above 1
    double undetected = 0.0;  ///< of that, what the samples do not show
    Radiance mean{};
    std::uint32_t samples = 0, notFinite = 0, emitterSamples = 0;
    bool reconstructed = false;
};

class Block
{
  public:
    /// The block and its eight neighbours, row by row; null outside the picture.
    using Neighbours = std::array<const Block*, 9>;

    static constexpr int kSteps = 3;

    /// Whether a block reads its neighbours in the step numbered `step`, 1 to kSteps. The plain mean of the most samples asks none.
    static bool LooksAtNeighbours(int step, const SamplingLimits& limits)
    {
        return step == 2 ? limits.variance > 0.0 : step == kSteps && limits.Denoises();
    }

    /// @param width, height  of the whole picture
    Block(const Area& area, std::uint32_t width, std::uint32_t height) :
        area(area), width(width), height(height), sent(area, width, height)
    {
    }

    const Area area;

    /// Steps that have been taken, 0 to kSteps.
    int StepsTaken() const { return phase / 2; }
    /// Takes the next step, after the block and its neighbours have taken so many.
    /// @return  false, with nothing done, where another thread has begun it
    bool TakeStep(int stepsTaken, const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);

    /// Of a block that has taken all steps; (x, y) is in the whole picture.
    const PixelResult& ResultOf(std::uint32_t x, std::uint32_t y) const { return results[area.IndexOf(x, y)]; }

  private:
    const std::uint32_t width, height;
    std::atomic<int> phase{0};  ///< twice the steps taken, and one more during a step

    /// @name Left by the first step
    /// @{
    std::unique_ptr<const FirstRound> firstRound;
    /// @}
    /// @name Left by the second step
    /// @{
    std::shared_ptr<const BlockStatistics> statistics;  ///< null where nothing is denoised
    std::shared_ptr<const SpreadSums> spread;           ///< of the samples of all rounds so far; null: nothing
    /// @}
    /// @name Of the block alone
    /// @{
    std::unique_ptr<const BlockEstimate> estimate;  ///< after the last step, until the last but one
    SentSamples sent;                               ///< until the second step
    std::vector<PixelResult> results;
    /// @}

    void Look(const SamplingLimits& limits, const Tracer& trace);
    void Converge(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);
    void Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);

    FirstRounds FirstRoundsOf(const Neighbours& neighbours) const;
    /// Samples that all rounds of the neighbours and of the block have sent; null: none.
    std::shared_ptr<const PaddedSpread> ReceivedFrom(const Neighbours& neighbours) const;
    /// Takes further rounds of active pixels until all have converged.
    /// @param samples  of the active pixels with the fewest
    void TakeRounds(BlockEstimate& estimate, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples,
                    SentSamples* sent, const Tracer& trace) const;
    void SetResults(const BlockEstimate& estimate);
    void ReconstructResults(const Neighbours& neighbours, const SamplingLimits& limits, const BlockStatistics* own, const PaddedSpread* received);
    /// Rows whose noise is noticed beside the `variance` asked for; with one sample a pixel all.
    Rows NoisyRows(const SamplingLimits& limits) const;
};

} // namespace tilt_lens

#endif
