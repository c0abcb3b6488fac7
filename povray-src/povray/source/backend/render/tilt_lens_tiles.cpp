// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_tiles.cpp
/// Renders tiles with `tilt_lens` in one thread.

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/render/send_layers.h"
#include "backend/render/tilt_lens_tracer.h"
#include "backend/render/trace_aids.h"
#include "backend/render/tracetask.h"
#include "backend/scene/view.h"
#include "tilt_lens/budget/budget.h"
#include "tilt_lens/samples/lamp_search.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

std::string InPercent(double share)
{
    return " (" + std::to_string(int(100.0 * share)) + "%)";
}

std::string ProgressOf(const tilt_lens::LampSearch& search)
{
    const tilt_lens::TaskProgress now = search.Progress();
    return (now.round == 1 ? "Searching for lamps" : "Searching for small lamps") + InPercent(now.share);
}

std::string ProgressOf(const tilt_lens::BudgetPilot& pilot)
{
    return "Choosing the variance for the budget" + InPercent(pilot.Progress());
}

void RunSearch(TiltLensTracer& tracer, ViewData& view, const std::function<void()>& cooperate)
{
    while (const auto row = tracer.view->search->NextRow())
    {
        // before the row: afterwards another thread may be ahead, and show a later step
        tracer.view->ShowProgress(view, [&] { return ProgressOf(*tracer.view->search); });
        tracer.Search(*row);
        cooperate();
    }
}

void RunPilot(tilt_lens::BudgetPilot& pilot, TiltLensTracer& tracer, ViewData& view, RadiosityFunction& radiosity, bool apart,
              const std::function<void()>& cooperate)
{
    const auto trace = [&](const tilt_lens::SampleRun& run, tilt_lens::SampleResult* results) { tracer.samples.Trace(run, results); };
    while (const auto task = pilot.NextTask())
    {
        tracer.view->ShowProgress(view, [&] { return ProgressOf(pilot); });  // before the task, as above
        // reproducible pixels must not depend on light found here
        radiosity.BeforeTile(apart ? -1 - int(task->block) : 0);
        pilot.Take(*task, trace);
        radiosity.AfterTile();
        cooperate();
    }
}

void EstimateWork(TiltLensTracer& tracer)
{
    static_assert(tilt_lens::Settings::probeSamples <= tilt_lens::Settings::cameraRaysOfBatch, "they are one run");
    const tilt_lens::SamplingLimits& limits = tracer.view->Limits();
    const unsigned int count = std::min(tilt_lens::Settings::probeSamples, limits.max);
    const RenderStatistics& stats = tracer.Stats();
    const auto raysTraced = [&] { return stats[Number_Of_Rays] + stats[Shadow_Ray_Tests]; };
    while (const auto probe = tracer.view->progress.NextProbe())
    {
        const auto before = raysTraced();
        tilt_lens::SampleResult results[tilt_lens::Settings::probeSamples];
        tracer.samples.Trace({{probe->x, probe->y, 0}, count}, results);
        std::vector<tilt_lens::Radiance> tried;
        for (unsigned int i = 0; i < count; i++)
            tried.push_back(results[i].radiance);
        tracer.view->progress.SetWeight(probe->block, (raysTraced() - before) * ExpectedSamples(limits, tried));
    }
}

/// @param alone           shares no samples with other tiles
/// @param pixels, effort  row by row
void TraceTile(TiltLensTracer& tracer, const ViewData& view, const POVRect& rect, bool alone, std::vector<Colour>& pixels,
               std::vector<TiltLensEffort>& effort)
{
    const tilt_lens::Area tile = AreaOf(rect);
    tilt_lens::BlockCache own(tracer.view->Limits(), view.GetWidth(), view.GetHeight(), tile);
    tilt_lens::TileSampler sampler(alone ? own : tracer.view->Blocks());
    tracer.areaLights.sampled = tracer.areaLights.skipped = tracer.samples.refusedRays = 0;
    const auto trace = [&](const tilt_lens::SampleRun& run, tilt_lens::SampleResult* results) { tracer.samples.Trace(run, results); };
    if (const tilt_lens::BudgetPilot* const pilot = tracer.view->pilot.get())
        sampler.Run(tile, [&](const tilt_lens::SampleRun& run, tilt_lens::SampleResult* results)
        {
            if (!pilot->Get(run, results))
                trace(run, results);
        });
    else
        sampler.Run(tile, trace);
    for (unsigned int y = tile.top; y < tile.Bottom(); y++)
        for (unsigned int x = tile.left; x < tile.Right(); x++)
        {
            pixels.push_back(ToColour(sampler.Mean(x, y)));
            effort.push_back({sampler.Samples(x, y), sampler.Variance(x, y)});
        }
    tilt_lens::SamplingStatistics statistics = sampler.Statistics();
    statistics.lightPoints = tracer.areaLights.sampled;
    statistics.lightPointsSkipped = tracer.areaLights.skipped;
    statistics.refusedRays = tracer.samples.refusedRays;
    tracer.view->Add(statistics);
    tracer.Stats()[Number_Of_Pixels] += statistics.Pixels();
    tracer.Stats()[Number_Of_Samples] += statistics.Samples();
}

} // namespace

/// Replaces all anti-aliasing methods.
void TraceTask::TiltLensSampling()
{
    POVRect rect;
    std::vector<Colour> pixels;
    std::vector<TiltLensEffort> effort;
    unsigned int serial;

    TiltLensTracer& tracer = *TiltLensTracer::Of(trace);
    if (tracer.view->search)
        RunSearch(tracer, *GetViewData(), [this] { Cooperate(); });
    if (tilt_lens::BudgetPilot* const pilot = tracer.view->Pilot())
        RunPilot(*pilot, tracer, *GetViewData(), radiosity, highReproducibility, [this] { Cooperate(); });
    EstimateWork(tracer);
    while (GetViewData()->GetNextRectangle(rect, serial) == true)
    {
        radiosity.BeforeTile(highReproducibility ? serial : 0);
        pixels.clear();
        effort.clear();
        // reproducible radiosity starts each tile afresh
        const bool alone = highReproducibility && GetSceneData()->radiositySettings.radiosityEnabled;
        if (tracer.view->aids)
            TraceAidTile(trace, *GetViewData(), rect, pixels);
        else
            TraceTile(tracer, *GetViewData(), rect, alone, pixels, effort);
        radiosity.AfterTile();

        tracer.view->progress.Finish(AreaOf(rect));
        GetViewDataPtr()->AfterTile();
        if (finalTrace)
            SendLayers(trace, *GetViewData(), rect, effort);
        GetViewData()->CompletedRectangle(rect, serial, pixels, 1, finalTrace);

        Cooperate();
    }
}

} // namespace pov
