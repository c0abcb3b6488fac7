// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file progress_estimator.h
/// What share of a picture's work is done, where a pixel may cost a few rays or a thousand.
///
/// The tiles that are done say nothing of those to come: sky often comes first, and half of the pixels
/// may be a tenth of the work. So before the first tile one pixel in each block of blockSide by blockSide
/// is tried with probeSamples samples (some 0.03 a pixel of the picture), and the block is expected to cost what that pixel
/// would: the samples until its variance is reached, times the rays of one sample. The blocks' shares are then fixed,
/// so what is shown never falls, and ends at 1.
///
/// Threads may share one map.

#ifndef TILT_LENS_PROGRESS_ESTIMATOR_H
#define TILT_LENS_PROGRESS_ESTIMATOR_H

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/math/radiance.h"
#include "tilt_lens/sampling/sampling_limits.h"

namespace tilt_lens
{

/// Samples that a pixel will take under these limits, guessed from a few of its samples.
double ExpectedSamples(const SamplingLimits& limits, const std::vector<Radiance>& tried);

class ProgressEstimator
{
  public:
    /// Before Plan there is nothing to do, and Share() is unknown.
    ProgressEstimator() = default;

    /// The part of the picture that is rendered. With `probing`, blocks have no weight until they are
    /// tried; without, all weigh the same.
    void Plan(const Area& rendered, bool probing);

    struct Probe
    {
        std::size_t block;
        std::uint32_t x, y;  ///< the pixel to try, in the whole picture
    };

    /// The next block to try, in each thread that asks; none when all are given out.
    std::optional<Probe> NextProbe();

    /// What a pixel of the block is expected to cost, in any unit that is the same for all blocks.
    void SetWeight(std::size_t block, double weight);

    /// Counts the pixels of a tile as done.
    void Finish(const Area& tile);

    /// Share of the work that is done, 0 to 1; none while blocks are yet to be tried, or without a plan.
    std::optional<double> Share() const;

  private:
    Area area{};
    std::uint32_t columns = 0;
    std::size_t given = 0, tried = 0;  ///< probes
    double done = 0.0, all = 0.0;      ///< sums of pixels' weights
    std::vector<double> weights;       ///< of a pixel, by block
    std::vector<std::uint32_t> pixels, finished;  ///< by block
    mutable std::mutex mutex;
};

} // namespace tilt_lens

#endif
