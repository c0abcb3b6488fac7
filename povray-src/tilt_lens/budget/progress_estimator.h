// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file progress_estimator.h
/// Finished share of a picture's work. Thread-safe. One pixel per block is probed first (0.03 samples per pixel), since finished tiles do
/// not predict the rest. The probe's cost is the block's fixed weight: the share never falls, and ends at 1.

#ifndef TILT_LENS_PROGRESS_ESTIMATOR_H
#define TILT_LENS_PROGRESS_ESTIMATOR_H

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/math/radiance.h"
#include "tilt_lens/samples/sampling_limits.h"

namespace tilt_lens
{

double ExpectedSamples(const SamplingLimits& limits, const std::vector<Radiance>& tried);

class ProgressEstimator
{
  public:
    ProgressEstimator() = default;

    /// With `probing`, blocks have no weight until probed; else all weigh the same.
    void Plan(const Area& rendered, bool probing);

    struct Probe
    {
        std::size_t block;
        std::uint32_t x, y;  ///< pixel to probe, in the whole picture
    };

    /// None when all are assigned.
    std::optional<Probe> NextProbe();

    /// @param weight  expected cost per pixel, in any common unit
    void SetWeight(std::size_t block, double weight);

    void Finish(const Area& tile);

    /// 0 to 1; none while blocks are unprobed, or without a plan.
    std::optional<double> Share() const;

  private:
    Area area{};
    std::uint32_t columns = 0;
    std::size_t given = 0, tried = 0;
    double done = 0.0, all = 0.0;
    std::vector<double> weights;  ///< per pixel, by block
    std::vector<std::uint32_t> pixels, finished;
    mutable std::mutex mutex;
};

} // namespace tilt_lens

#endif
