// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/block.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/stop_rule/convergence.h"
#include "tilt_lens/stop_rule/forecast.h"
#include "tilt_lens/stop_rule/pixel_variance.h"

namespace tilt_lens
{

namespace
{

/// @param results  buffer of one run
void TakeRound(PixelStatistics& pixel, std::uint32_t x, std::uint32_t y, std::uint32_t until, SentSamples* sent, const Tracer& tracer,
               SampleResult* results)
{
    pixel.BeginRound(until);
    SampleRun run{{x, y, pixel.Samples()}, 0};
    for (; run.first.index < until; run.first.index += run.count)
    {
        run.count = std::min(Settings::cameraRaysOfBatch - run.first.index % Settings::cameraRaysOfBatch, until - run.first.index);
        tracer.Trace(run, results);
        pixel.Add(results, run.count);
        for (std::uint32_t i = 0; sent != nullptr && i < run.count; i++)
            sent->Add(run[i], results[i]);
    }
}

/// Takes the active pixels' samples up to number `until`. A reactivated pixel catches up round by round, so that its two buffers divide as
/// others do.
/// @param sent  receives the samples that serve other pixels; may be null
void TakeSamples(BlockEstimate& estimate, std::uint32_t until, const SamplingLimits& limits, SentSamples* sent, const Tracer& trace)
{
    const Area& area = estimate.area;
    std::array<SampleResult, Settings::cameraRaysOfBatch> results;
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            PixelEstimate& pixel = estimate.pixels[area.IndexOf(x, y)];
            PixelStatistics& own = pixel.statistics;
            while (pixel.active && own.Samples() < until)
                TakeRound(own, x, y, own.Samples() == 0 ? until : std::min(limits.NextRound(own.Samples()), until), sent, trace,
                          results.data());
        }
}

std::vector<std::uint32_t> SamplesOf(const BlockEstimate& estimate)
{
    std::vector<std::uint32_t> samples;
    for (const PixelEstimate& pixel : estimate.pixels)
        samples.push_back(pixel.statistics.Samples());
    return samples;
}

} // namespace

bool Block::TakeStep(int stepsTaken, const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    int before = 2 * stepsTaken;
    if (!phase.compare_exchange_strong(before, before + 1))
        return false;
    try
    {
        if (stepsTaken == 0)
            Look(limits, trace);
        else if (stepsTaken == 1)
            Converge(neighbours, limits, trace);
        else
            Finish(neighbours, limits, trace);
    }
    catch (...)
    {
        phase = before;
        throw;
    }
    phase = before + 2;
    return true;
}

void Block::Look(const SamplingLimits& limits, const Tracer& trace)
{
    auto first = std::make_unique<BlockEstimate>(area, edges, limits.settings);
    const std::uint32_t samples = limits.FirstRound();
    sent.Clear();  // left by an interrupted step
    TakeSamples(*first, samples, limits, limits.variance > 0.0 ? &sent : nullptr, trace);
    UpdateVarianceRatios(*first, samples);
    sent.ReleaseReserve();
    auto round = std::make_unique<FirstRound>(*first);
    if (limits.Denoises())
        round->statistics = StatisticsOf(*first);
    round->spread = sent.Spread(SamplesOf(*first), samples);
    round->deviation = MeanDeviation(*first, limits);
    estimate = std::move(first);
    firstRound = std::move(round);
}

void Block::TakeRounds(BlockEstimate& current, const Neighbourhood& around, const SamplingLimits& limits, std::uint32_t samples,
                       SentSamples* sent, const Tracer& trace) const
{
    do
    {
        samples = limits.NextRound(samples);
        TakeSamples(current, samples, limits, sent, trace);
        UpdateVarianceRatios(current, samples);
    }
    while (UpdateConvergence(current, around, limits, samples));
    if (limits.Denoises())
        UpdateBlockStatistics(current, samples);
}

void Block::Converge(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    const Neighbourhood around(EachOf<FirstRound>(neighbours, &Block::firstRound), limits);
    auto converged = std::make_unique<BlockEstimate>(*estimate);
    const std::uint32_t samples = limits.FirstRound();
    converged->spread = PaddedSpread::Of(EachOf<SpreadSums>(around.rounds, &FirstRound::spread), edges);
    spread = firstRound->spread;
    if (UpdateConvergence(*converged, around, limits, samples))
    {
        SentSamples all = sent;
        TakeRounds(*converged, around, limits, samples, limits.Denoises() ? &all : nullptr, trace);
        if (limits.Denoises())
            spread = all.Spread(SamplesOf(*converged), samples);
    }
    else if (limits.Denoises())
        UpdateBlockStatistics(*converged, samples);
    statistics = converged->statistics;
    SetResults(*converged, limits, around.loneVariance);
    converged->spread.reset();
    estimate = std::move(converged);
    sent.Clear();
}

void Block::Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace)
{
    std::shared_ptr<const PaddedSpread> received;
    if (limits.Denoises())
        received = PaddedSpread::Of(EachOf<SpreadSums>(neighbours, &Block::spread), edges);
    const Neighbourhood around(EachOf<FirstRound>(neighbours, &Block::firstRound), limits);
    BlockEstimate last = *estimate;
    if (const std::uint32_t samples = received ? ActivateWhereMissed(last, *received, limits) : 0)
    {
        last.spread = received;
        last.statisticsSamples = 0;
        TakeRounds(last, around, limits, samples, nullptr, trace);
        SetResults(last, limits, around.loneVariance);
    }
    if (last.statistics)
        ReconstructResults(neighbours, limits, last.statistics.get(), received.get());
    estimate.reset();
    if (!limits.Denoises())
        return;
    // all neighbours have taken their second step
    firstRound->statistics.reset();
    firstRound->spread.reset();
}

void Block::SetResults(const BlockEstimate& last, const SamplingLimits& limits, double loneVariance)
{
    results.clear();
    results.reserve(last.pixels.size());
    for (std::size_t i = 0; i < last.pixels.size(); i++)
    {
        const PixelStatistics& own = last.pixels[i].statistics;
        // n samples miss a feature of share 1/n with probability exp(-1)
        const double missed = std::exp(-1.0) * LoneVariance(loneVariance, limits.FirstRound(), own.Samples());
        PixelResult result;
        result.variance = FiniteFloat(std::max(MeanColour(VarianceOfMean(last, i, own.Variance())), missed));
        const Radiance mean = own.Mean();
        std::copy(mean.begin(), mean.end(), result.mean.begin());
        result.samples = own.Samples(), result.notFinite = own.NotFinite(), result.emitterSamples = own.EmitterSamples();
        results.push_back(result);
    }
}

/// @param own  final; neighbours' statistics are those of the previous step
void Block::ReconstructResults(const Neighbours& neighbours, const SamplingLimits& limits, const BlockStatistics* own,
                               const PaddedSpread* received)
{
    const Rows rows = limits.max == 1 ? kAllRows : NoisyRows();  // one sample shows no noise
    if (rows.IsEmpty() || (limits.max == 1 && received == nullptr))
        return;
    std::array<const BlockStatistics*, 9> known = EachOf<BlockStatistics>(neighbours, &Block::statistics);
    known[4] = own;
    const PaddedBlock padded(known, edges);
    const ReconstructedBlock reconstructed = limits.max == 1 ? SpreadEstimates(padded, limits.settings, *received)
                                                             : Reconstruct(padded, limits.settings, received, rows);
    double risk = 0.0, variance = 0.0;
    for (std::size_t i = 0; i < results.size(); i++)
    {
        PixelResult& pixel = results[i];
        const int row = int(i / area.width);
        const std::size_t place = row * Settings::blockSide + i % area.width;
        const Radiance mean = reconstructed.MeanOf(place);
        if (rows.Has(row) && IsFinite(mean))  // not finite beside a pixel too bright for a float
        {
            risk += pixel.variance * reconstructed.risk;
            std::copy(mean.begin(), mean.end(), pixel.mean.begin());
            pixel.variance *= reconstructed.residualVarianceRatio[place];
            pixel.reconstructed = true;
        }
        else
            risk += pixel.variance;
        variance += pixel.variance;
    }
    if (variance > 0.0)
        riskOverVariance = FiniteFloat(risk / variance);
}

Rows Block::NoisyRows() const
{
    std::vector<std::size_t> noisy;
    for (std::size_t i = 0; i < results.size(); i++)
        if (results[i].variance > 0.0f)
            noisy.push_back(i);
    return Rows::Of(noisy, area.width);
}

} // namespace tilt_lens
