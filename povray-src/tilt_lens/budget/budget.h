// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file budget.h
/// The variance target with which a picture takes a given mean number of samples: docs/sampling.md, section 9. Several targets are tried on
/// some of its blocks; each sample is traced once.
///
/// The choice depends on scene, picture size and budget alone, never on threads or the rendered part.

#ifndef TILT_LENS_BUDGET_H
#define TILT_LENS_BUDGET_H

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tilt_lens/budget/budget_search.h"
#include "tilt_lens/budget/sample_record.h"
#include "tilt_lens/samples/shared_tasks.h"
#include "tilt_lens/stop_rule/block.h"

namespace tilt_lens
{

/// Thread-safe.
class BudgetPilot
{
  public:
    /// @param limits         the variance is not used
    /// @param width, height  whole picture, pixels
    /// @param budget         mean samples per pixel
    /// @param recordBytes    bounds the number of blocks
    BudgetPilot(const SamplingLimits& limits, std::uint32_t width, std::uint32_t height, double budget,
                double recordBytes = 256.0 * 1024 * 1024);

    /// One step of one block.
    struct Task
    {
        std::size_t number;
        std::size_t block;  ///< row by row
    };

    /// Waits for other threads if necessary; none once the target is chosen.
    std::optional<Task> NextTask();
    /// If the tracer throws, another thread gets the task.
    void Take(const Task& task, const Tracer& trace);
    /// Traced so far, over the samples that the budget allows the counted blocks; at most 1.
    double Progress() const;

    /// @name After the last task.
    /// @{
    const SamplingLimits& Limits() const { return limits; }  ///< with the chosen variance
    const BudgetRound& Chosen() const { return chosen; }
    double Lost() const { return recorded - chosen.used; }  ///< samples per pixel that the picture does not need
    double Budget() const { return budget; }
    /// False unless the pilot has taken all samples of the run.
    bool Get(const SampleRun& run, SampleResult* results) const;
    /// @}

  private:
    const double budget;
    const std::uint32_t width, height, columns, rows;  ///< in pixels, in blocks
    SamplingLimits limits;

    struct Blocks
    {
        std::vector<std::size_t> counted;  ///< places whose samples are counted, in a fixed order
        std::vector<std::size_t> looked;  ///< these and their neighbours, for their first rounds
    };
    Blocks few, all;

    SharedTasks tasks;  ///< a round of tasks for each step
    bool trying = true;  ///< with the few blocks
    int step = 0;  ///< of Block

    std::vector<std::unique_ptr<Block>> blocks;  ///< by place; null: not looked at
    std::vector<std::unique_ptr<SampleRecord>> records;  ///< by place
    double allowed = 0.0;  ///< samples of the counted blocks within the budget
    std::atomic<std::uint64_t> traced{0};  ///< samples of all blocks
    BudgetRounds trials, rounds;
    double recorded = 0.0;
    BudgetRound chosen;

    Area PixelsOf(std::size_t place) const;
    Block::Neighbours NeighboursOf(std::size_t place) const;
    std::vector<std::size_t> ChosenPlaces(double recordBytes) const;
    Blocks WithNeighbours(const std::vector<std::size_t>& places) const;
    const Blocks& Sampled() const { return trying ? few : all; }
    const std::vector<std::size_t>& Places() const { return step == 0 ? Sampled().looked : Sampled().counted; }
    void BeginRound(double variance);
    void EndStep();
    void EndRound();
    BudgetRound Measure() const;
};

}  // namespace tilt_lens

#endif
