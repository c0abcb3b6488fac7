// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/budget.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "tile_results.h"
#include "together.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace tilt_lens
{
namespace
{

struct Found
{
    BudgetRounds trials, rounds;
    double cost = 0.0;
};

/// A search in a scene where a variance costs `samplesOf` it.
/// @param few  excess of the trials' blocks above the least over that of all blocks; the standard error equals the difference
Found Search(double budget, double few, const std::function<double(double)>& samplesOf)
{
    constexpr double least = 4.0, share = 1.0 / 8.0;
    Found found;
    double ofTrials = 0.0, ofAll = 0.0;
    while (const std::optional<double> variance = NextTrialVariance(found.trials, budget, least))
    {
        const double samples = least + few * (samplesOf(*variance) - least);
        ofTrials = std::max(ofTrials, share * samples);
        found.trials.push_back({*variance, samples, std::abs(few - 1.0) * (samples - least), share * samples});
    }
    const auto recorded = [&] { return ofTrials + std::max(0.0, ofAll - ofTrials); };
    while (const std::optional<double> variance = NextVariance(found.trials, found.rounds, recorded(), budget, least))
    {
        const double samples = samplesOf(*variance);
        ofAll = std::max(ofAll, samples);
        found.rounds.push_back({*variance, samples, 0.0, samples});
    }
    if (const BudgetRound* best = BestRound(found.rounds, recorded(), budget))
        found.cost = best->Cost(recorded());
    return found;
}

TEST(NextVariance, ComesNearToTheBudgetAndNeverExceedsIt)
{
    for (const double budget : {6.0, 12.0, 30.0, 100.0})
        for (const double exponent : {0.5, 0.7, 1.0})
            for (const double noise : {1e-4, 1e-3, 1e-2})  // variance of one sample
                for (const double few : {0.8, 1.0, 1.2})
                {
                    const Found found = Search(budget, few, [=](double variance) { return 4.0 + std::pow(noise / variance, exponent); });
                    EXPECT_LE(found.cost, budget) << budget << " " << exponent << " " << noise << " " << few;
                    EXPECT_GE(found.cost, 0.88 * budget) << budget << " " << exponent << " " << noise << " " << few;
                    EXPECT_LE(found.rounds.size(), 12u);
                }
}

/// Half of the pixels have the same noise, so they double their samples together.
TEST(NextVariance, SeesStepsInTheTrials)
{
    const Found found = Search(12.0, 1.0, [](double variance) { return 0.5 * (variance < 3e-4 ? 16.0 : 8.0) + 2.0 + 1e-3 / variance; });
    EXPECT_LE(found.cost, 12.0);
    EXPECT_GE(found.cost, 0.7 * 12.0) << "the step is from 9.3 to 13.3";
}

/// From 3.3e-4 to 2.8e-4 the excess hardly grows, above and below steeply. Measured in a board out of focus.
double SamplesWithLevelStretch(double variance)
{
    const double level = std::clamp(variance, 2.8e-4, 3.3e-4);
    return 4.0 + 4.4 * std::pow(4.9e-4 / variance, 1.4) * std::pow(level / 3.3e-4, 1.1);
}

TEST(NextVariance, DoesNotTakeALevelStretchForTheWholeSlope)
{
    for (double budget = 12.0; budget < 20.0; budget += 0.5)
    {
        const Found found = Search(budget, 0.8, SamplesWithLevelStretch);
        EXPECT_LE(found.cost, budget);
        EXPECT_GE(found.cost, 0.88 * budget) << budget;
    }
}

TEST(NextVariance, EndsWhereTheBudgetIsTooSmall)
{
    const Found found = Search(6.0, 1.0, [](double) { return 8.0; });
    EXPECT_EQ(found.cost, 0.0) << "no round";
    EXPECT_EQ(found.rounds.size(), 0u);
}

TEST(NextVariance, EndsWhereNothingIsNoisy)
{
    const Found found = Search(30.0, 1.0, [](double) { return 4.0; });
    EXPECT_EQ(found.cost, 4.0);
    EXPECT_LE(found.rounds.size(), 12u);
}

TEST(NextVariance, KeepsTheBudgetWhereTrialsAreTooLow)
{
    for (const double few : {0.5, 0.6, 0.7})
    {
        const auto samples = [](double variance) { return 4.0 + std::pow(1e-3 / variance, 0.7); };
        const Found found = Search(12.0, few, samples);
        EXPECT_LE(found.cost, 12.0) << few;
        EXPECT_GE(found.cost, 0.8 * 12.0) << few;
    }
}

TEST(BestRound, CountsLostSamples)
{
    const BudgetRounds rounds{{1e-3, 8.0, 0.0, 0.8}, {5e-4, 11.0, 0.0, 1.1}, {1e-4, 20.0, 0.0, 2.0}};
    EXPECT_EQ(BestRound(rounds, 2.0, 20.5)->variance, 1e-4);
    EXPECT_EQ(BestRound(rounds, 2.0, 12.0)->variance, 5e-4) << "0.9 are lost";
    EXPECT_EQ(BestRound(rounds, 2.0, 11.5)->variance, 1e-3);
    EXPECT_EQ(BestRound(rounds, 2.0, 6.0)->variance, 1e-3) << "none keeps it: the cheapest";
    EXPECT_EQ(BestRound({}, 2.0, 6.0), nullptr);
}

constexpr std::uint32_t kWidth = 150, kHeight = 120;

void Picture(const SampleId& id, SampleResult& light)
{
    Edge(id, light);
    const double noise = id.x < 40 ? 0.0 : 0.004 * (id.x - 40) * (1.2 + std::sin(0.1 * id.y));
    for (int channel = 0; channel < 3; channel++)
        light.radiance[channel] = 0.5 * light.radiance[channel] + noise * (Noise(id, 1) - 0.5);
}

SamplingLimits DenoisedLimits(std::uint32_t max = 1024)
{
    SamplingLimits limits = Limits(4, max, 0.0);
    limits.denoise = true;
    return limits;
}

void RunPilot(BudgetPilot& pilot, int threads, const Tracer& trace)
{
    TakeTogether(threads, [&] { return pilot.NextTask(); }, [&](const BudgetPilot::Task& task) { pilot.Take(task, trace); });
}

/// Mean samples of the whole picture, recorded ones included.
double SamplesOf(const BudgetPilot& pilot, std::uint32_t width, std::uint32_t height, const Tracer& trace)
{
    BlockCache cache(pilot.Limits(), width, height, {0, 0, width, height});
    TileSampler sampler(cache);
    sampler.Run({0, 0, width, height}, [&](const SampleRun& run, SampleResult* results)
    {
        if (!pilot.Get(run, results))
            trace.Trace(run, results);
    });
    return double(sampler.Statistics().Samples()) / (width * height);
}

TEST(BudgetPilot, APictureTakesItsBudget)
{
    for (const double budget : {12.0, 30.0})
    {
        BudgetPilot pilot(DenoisedLimits(), kWidth, kHeight, budget);
        RunPilot(pilot, 1, Picture);
        const double samples = SamplesOf(pilot, kWidth, kHeight, Picture);
        EXPECT_NEAR(samples, pilot.Chosen().samples, 1e-9) << "all blocks were counted";
        EXPECT_LE(samples + pilot.Lost(), budget);
        EXPECT_GE(samples + pilot.Lost(), 0.9 * budget);
    }
}

TEST(BudgetPilot, ProgressNeverFalls)
{
    BudgetPilot pilot(DenoisedLimits(), kWidth, kHeight, 12.0);
    std::vector<double> told;
    while (const auto task = pilot.NextTask())
    {
        pilot.Take(*task, Picture);
        told.push_back(pilot.Progress());
    }
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_LT(told.front(), 0.02);
    EXPECT_NEAR(12.0 * told.back(), pilot.Chosen().samples + pilot.Lost(), 1e-6) << "all samples were traced once";
}

TEST(BudgetPilot, TracesEachSampleOnce)
{
    std::vector<std::atomic<std::uint32_t>> traced(kWidth * kHeight);
    const Tracer counting([&](const SampleId& id, SampleResult& result)
    {
        EXPECT_EQ(traced[id.y * kWidth + id.x]++, id.index);
        Picture(id, result);
    });
    BudgetPilot pilot(DenoisedLimits(), kWidth, kHeight, 12.0);
    RunPilot(pilot, 3, counting);
    SamplesOf(pilot, kWidth, kHeight, counting);
    const double all = std::accumulate(traced.begin(), traced.end(), 0.0) / traced.size();
    EXPECT_LE(all, 12.0) << "with those that were taken in vain";
}

TEST(BudgetPilot, ChoosesTheSameWithManyThreadsAndInterruptions)
{
    BudgetPilot alone(DenoisedLimits(), kWidth, kHeight, 12.0);
    RunPilot(alone, 1, Picture);
    std::atomic<std::uint32_t> asked{0};
    const Tracer failing([&](const SampleId& id, SampleResult& result)
    {
        if (asked++ % 997 == 500)
            throw std::runtime_error("interrupted");
        Picture(id, result);
    });
    BudgetPilot many(DenoisedLimits(), kWidth, kHeight, 12.0);
    RunPilot(many, 4, failing);
    EXPECT_GT(asked, 2000u);
    EXPECT_EQ(many.Limits().variance, alone.Limits().variance);
}

TEST(BudgetPilot, SomeBlocksStandForAll)
{
    constexpr double budget = 12.0, bytes = 2.1e7;
    std::atomic<std::uint64_t> traced{0};
    const Tracer counting([&](const SampleRun& run, SampleResult* results)
    {
        traced += run.count;
        for (std::uint32_t i = 0; i < run.count; i++)
            Picture(run[i], results[i]);
    });
    BudgetPilot pilot(DenoisedLimits(), kWidth, kHeight, budget, bytes);
    RunPilot(pilot, 2, counting);
    EXPECT_LT(traced, 0.7 * budget * kWidth * kHeight) << "as much as the whole picture";
    const BudgetRound& chosen = pilot.Chosen();
    EXPECT_GT(chosen.doubt, 0.0);
    EXPECT_LE(chosen.samples + 2.0 * chosen.doubt, budget);
    const double samples = SamplesOf(pilot, kWidth, kHeight, Picture);
    EXPECT_NEAR(samples, chosen.samples, 3.0 * chosen.doubt);
    EXPECT_GT(samples, 0.7 * budget);
}

} // namespace
} // namespace tilt_lens
