// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file block.h
/// The rounds of samples of a square of pixels, on a grid fixed to the whole picture: docs/sampling.md, section 1.
///
/// A block is sampled in two steps: the first round, which its neighbours look at, and all further rounds. What a block sees
/// depends on places in the picture alone, so that neither threads nor tiles nor sub-images change a value (section 10).
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
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sampling_limits.h"

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

    /// @param width, height  of the whole picture
    Block(const Area& area, std::uint32_t width, std::uint32_t height) : area(area), width(width), height(height) {}

    const Area area;

    /// @return  false, with nothing done, where another thread has begun it
    bool TakeFirstRound(const SamplingLimits& limits, const Tracer& trace);
    /// The neighbours have taken their first rounds.
    /// @return  false, with nothing done, where another thread has begun it
    bool TakeFurtherRounds(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);
    bool HasFirstRound() const { return phase >= Phase::FirstRoundTaken; }
    bool IsConverged() const { return phase == Phase::Converged; }

    /// @name Of a converged block.
    /// @{
    /// (x, y) is in the whole picture.
    const PixelResult& ResultOf(std::uint32_t x, std::uint32_t y) const { return results[area.IndexOf(x, y)]; }
    /// Rows whose noise is noticed beside the `variance` asked for; with one sample a pixel all.
    Rows NoisyRows(const SamplingLimits& limits) const;
    /// Null where nothing is denoised.
    const BlockStatistics* Statistics() const { return statistics.get(); }
    /// What the samples of its first round have sent to other pixels; null: nothing.
    const SpreadSums* Spread() const { return firstRound->spread.get(); }
    std::uint32_t FirstSamples() const { return firstRound->samples; }  ///< of each pixel in the first round
    /// @}

  private:
    enum class Phase { Unsampled, InFirstRound, FirstRoundTaken, InFurtherRounds, Converged };

    const std::uint32_t width, height;
    std::atomic<Phase> phase{Phase::Unsampled};
    std::unique_ptr<const BlockEstimate> afterFirstRound;  ///< until the block has converged
    std::unique_ptr<const FirstRound> firstRound;          ///< from the first round on
    std::shared_ptr<const BlockStatistics> statistics;     ///< the last
    std::vector<PixelResult> results;

    /// Takes a step where the block is in phase `before`, whose results are then seen by all threads.
    template<class Step>
    bool Take(Phase before, Phase during, Phase after, const Step& step);
    void FirstStep(const SamplingLimits& limits, const Tracer& trace);
    void SecondStep(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);
    FirstRounds FirstRoundsOf(const Neighbours& neighbours) const;
    /// Takes the samples of active pixels that are missing up to number `until`.
    /// @param spread  takes what they send; may be null
    static void TakeSamples(BlockEstimate& estimate, std::uint32_t until, SpreadSums* spread, const Tracer& trace);
};

} // namespace tilt_lens

#endif
