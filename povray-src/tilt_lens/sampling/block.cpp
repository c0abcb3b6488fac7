// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/block.h"

#include <algorithm>

#include "tilt_lens/sampling/convergence.h"
#include "tilt_lens/sampling/denoiser_forecast.h"
#include "tilt_lens/sampling/neighbourhood.h"
#include "tilt_lens/sampling/variance_ratio.h"

namespace tilt_lens
{

namespace
{

/// Sends a sample to the pixels of its circle of confusion.
void Spread(const SampleId& id, const SampleResult& result, const Area& block, SpreadSums& spread)
{
    CircleOfConfusion circle = result.circle;
    circle.x -= block.left;
    circle.y -= block.top;
    spread.Add(id.x - block.left, id.y - block.top, circle, result.radiance);
}

/// A round of one pixel.
/// @param results  place for those of a run
void TakeRound(PixelStatistics& pixel, const Area& area, std::uint32_t x, std::uint32_t y, std::uint32_t until, bool ofFirstRound,
               SpreadSums* spread, const Tracer& tracer, SampleResult* results)
{
    pixel.BeginRound(until);
    SampleRun run{{x, y, pixel.Samples()}, 0, ofFirstRound};
    for (; run.first.index < until; run.first.index += run.count)
    {
        run.count = std::min(settings.cameraRaysOfBatch - run.first.index % settings.cameraRaysOfBatch, until - run.first.index);
        tracer.Trace(run, results);
        pixel.Add(results, run.count);
        for (std::uint32_t i = 0; spread != nullptr && i < run.count; i++)
            Spread(run[i], results[i], area, *spread);
    }
    pixel.EndRound();
}

/// Whether so many pixels will take several more rounds that the first may as well be longer. What is seen of it by others, and what
/// its samples send to other pixels, is then of more samples.
bool IsFarFromConvergence(const BlockEstimate& estimate, const SamplingLimits& limits)
{
    if (!limits.Denoises() || estimate.firstSamples < 2)  // one sample tells no variance
        return false;
    const double far = settings.farFactor * limits.variance * estimate.firstSamples;
    const auto pixels = std::count_if(estimate.pixels.begin(), estimate.pixels.end(), [far](const PixelEstimate& pixel)
    {
        const PixelStatistics& own = pixel.statistics;
        return pixel.varianceRatio * LargestChannel(RelativeTo(own.Mean(), own.Variation().variance)) > far;
    });
    return pixels >= settings.farShare * estimate.pixels.size();
}

} // namespace

/// A pixel that was made active again catches up by the rounds that it left out, so that its buffers are as those of others.
void Block::TakeSamples(BlockEstimate& estimate, std::uint32_t until, SpreadSums* spread, const Tracer& trace)
{
    const Area& area = estimate.area;
    std::array<SampleResult, settings.cameraRaysOfBatch> results;
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            PixelEstimate& pixel = estimate.pixels[area.IndexOf(x, y)];
            PixelStatistics& own = pixel.statistics;
            while (pixel.active && own.Samples() < until)
                TakeRound(own, area, x, y, own.Samples() == 0 ? until : std::min(2 * own.Samples(), until),
                          until <= estimate.firstSamples, spread, trace, results.data());
        }
}

template<class Step>
bool Block::Take(Phase before, Phase during, Phase after, const Step& step)
{
    if (!phase.compare_exchange_strong(before, during))
        return false;
    try
    {
        step();
    }
    catch (...)
    {
        phase = before;
        throw;
    }
    phase = after;
    return true;
}

bool Block::TakeFirstRound(const SamplingLimits& limits, const Tracer& trace)
{
    return Take(Phase::Unsampled, Phase::InFirstRound, Phase::FirstRoundTaken, [&] { FirstStep(limits, trace); });
}

bool Block::TakeFurtherRounds(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    return Take(Phase::FirstRoundTaken, Phase::InFurtherRounds, Phase::Converged, [&] { SecondStep(neighbours, limits, trace); });
}

void Block::FirstStep(const SamplingLimits& limits, const Tracer& trace)
{
    auto estimate = std::make_unique<BlockEstimate>(area);
    std::uint32_t& samples = estimate->firstSamples;
    const std::shared_ptr<SpreadSums> spread =
        limits.variance > 0.0 ? std::make_shared<SpreadSums>(area, width, height) : nullptr;
    do
    {
        samples = samples == 0 ? limits.FirstRound() : 2 * samples;
        TakeSamples(*estimate, samples, spread.get(), trace);
        UpdateVarianceRatios(*estimate, samples);
    }
    while (2 * samples <= std::min(limits.max, settings.mostFirstSamples) && IsFarFromConvergence(*estimate, limits));
    auto round = std::make_unique<FirstRound>(*estimate);
    if (limits.Denoises())
        round->statistics = StatisticsOf(*estimate);
    if (spread && spread->IsSpread())
        round->spread = spread;
    afterFirstRound = std::move(estimate);
    firstRound = std::move(round);
}

FirstRounds Block::FirstRoundsOf(const Neighbours& neighbours) const
{
    FirstRounds rounds;
    std::transform(neighbours.begin(), neighbours.end(), rounds.begin(), [](const Block* block)
        { return block != nullptr ? block->firstRound.get() : nullptr; });
    return rounds;
}

void Block::SecondStep(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    const Neighbourhood around(FirstRoundsOf(neighbours), limits);
    BlockEstimate estimate = *afterFirstRound;
    estimate.spread = around.Spread();
    std::uint32_t samples = estimate.firstSamples;
    while (UpdateConvergence(estimate, around, limits, samples))
    {
        samples = std::min(2 * samples, limits.max);
        TakeSamples(estimate, samples, nullptr, trace);
        UpdateVarianceRatios(estimate, samples);
        Reactivate(estimate, around);
    }
    if (limits.Denoises())
        UpdateBlockStatistics(estimate, samples);

    results.reserve(estimate.pixels.size());
    for (const PixelEstimate& pixel : estimate.pixels)
    {
        const PixelStatistics& own = pixel.statistics;
        results.push_back({pixel.variance, pixel.undetected, own.Mean(), own.Samples(), own.NotFinite(), own.EmitterSamples()});
    }
    statistics = estimate.statistics;
    afterFirstRound.reset();
}

Rows Block::NoisyRows(const SamplingLimits& limits) const
{
    Rows rows{int(area.height), 0};
    if (!statistics)
        return rows;
    if (limits.max == 1)  // nothing tells their noise
        return {0, int(area.height)};
    for (int y = 0; y < int(area.height); y++)
    {
        double variance = 0.0;
        for (std::uint32_t x = 0; x < area.width; x++)
            variance += results[y * area.width + x].variance;
        if (variance > settings.leastRowVariance * limits.variance * area.width)
            rows = {std::min(rows.begin, y), y + 1};
    }
    return rows;
}

} // namespace tilt_lens
