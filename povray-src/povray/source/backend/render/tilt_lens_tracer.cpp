// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/render/tilt_lens_tracer.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/math/vector.h"
#include "backend/render/tracepixel.h"
#include "backend/render/tracetask.h"
#include "backend/texture/normal.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::PixelSampler;
using tilt_lens::Radiance;
using tilt_lens::SampleId;

namespace
{

Colour ToColour(const Radiance& v)
{
    return Colour(v[pRED], v[pGREEN], v[pBLUE], v[pFILTER], v[pTRANSM]);
}

/// The point of an area light's row for x in (0, 1), with POV-Ray's weights: POV-Ray bisects the row recursively, and both halves of an odd
/// row include its middle point.
int PointOfRow(int points, double x)
{
    int first = 0, last = points - 1;
    while (first < last)
    {
        const int sum = first + last;
        const bool upper = x >= 0.5;
        x = 2.0 * x - (upper ? 1.0 : 0.0);
        (upper ? first : last) = upper ? (sum + 1) / 2 : sum / 2;
    }
    return first;
}

template<class Number>
void Reseed(std::vector<shared_ptr<SequentialNumberGenerator<Number> > >& generators, unsigned int seed)
{
    for (size_t i = 0; i < generators.size(); i++)
        dynamic_cast<SeedableNumberGenerator<Number>&>(*generators[i]).Seed(seed + i);
}

} // namespace

TiltLensTracer::TiltLensTracer(TracePixel& owner, const shared_ptr<TiltLensView>& itsView) :
    trace(owner), view(itsView),
    interiorsVary(std::any_of(view->aroundLens.begin(), view->aroundLens.end(), [](const ObjectAroundLens& around)
        { return !around.holdsLens; }))
{
}

shared_ptr<TiltLensTracer> TiltLensTracer::Create(TracePixel& owner, const shared_ptr<TiltLensView>& view)
{
    return view ? shared_ptr<TiltLensTracer>(new TiltLensTracer(owner, view)) : shared_ptr<TiltLensTracer>();
}

TiltLensTracer* TiltLensTracer::Of(const TracePixel& owner)
{
    return owner.tiltLens.get();
}

void TiltLensTracer::TraceRun(tilt_lens::CameraRayBatch& rays, const tilt_lens::SampleRun& run, Ray& ray,
                              tilt_lens::SampleResult* results)
{
    rays.Make(run);
    refusedRays += rays.Refused();
    pixel = &rays.Sampler();
    const unsigned int place = run.Place();
    if (view->camera->HasColours())
        for (unsigned int i = 0; i < run.count; i++)
        {
            index = run.first.index + i;
            TraceSample(rays.One(place + i), results[i]);
        }
    else
        TraceRays(rays.Rays(), place, run, ray, results);
}

void TiltLensTracer::TraceSample(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result)
{
    if (view->camera->HasColours() && camera.sample.weight != 0.0)
        TraceColours(camera, result);
    else
        TraceCameraRay(camera, result);
}

void TiltLensTracer::TraceCameraRay(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result)
{
    tilt_lens::CameraRays rays;
    rays.Put(0, camera);
    Ray ray = CameraRayOfPov();
    TraceRays(rays, 0, {{0, 0, index}, 1}, ray, &result);
}

/// A camera ray without origin and direction, inside the interiors that contain the whole lens.
Ray TiltLensTracer::CameraRayOfPov() const
{
    Ray ray(Ray::PrimaryRay, false, false, false, false, trace.pretrace);
    if (!interiorsVary)
        EnterInteriors(ray);
    return ray;
}

/// Traces camera rays.
/// @param place  of the run's first ray
void TiltLensTracer::TraceRays(const tilt_lens::CameraRays& rays, unsigned int place, const tilt_lens::SampleRun& run, Ray& ray,
                               tilt_lens::SampleResult* results)
{
    DBL distances[tilt_lens::settings.cameraRaysOfBatch];
    const Trace::TraceTicket ticket(trace.maxTraceLevel, trace.adcBailout, trace.sceneData->outputAlpha);
    const unsigned int first = run.first.index, count = run.count;
    const bool plain = trace.camera.Tnormal == NULL && !interiorsVary;
    const bool circlesWanted = first < tilt_lens::settings.mostSentSamples && view->limits.variance > 0.0 && view->samplesSpread;
    trace.areaLightSampler = this;
    trace.lightPath.wanted = circlesWanted;
    LeadGenerators();
    for (unsigned int i = 0; i < count; i++)
    {
        index = first + i;
        results[i].expectedEmission = rays.samples.expectedEmission[place + i];
        distances[i] = HUGE_VAL;
        if (rays.samples.weight[place + i] == 0.0)
            results[i].radiance = Radiance{};
        else
        {
            Begin(ray, rays, place + i);
            if (!plain)
                BeginSpecially(ray, rays, place + i);
            TraceRay(ray, ticket, rays.samples.weight[place + i], results[i].radiance);
            distances[i] = trace.lightPath.Length();
        }
    }
    trace.areaLightSampler = NULL;
    trace.lightPath.wanted = false;
    EndSample();
    if (circlesWanted)
        FindCircles(rays, place, count, distances, results);
}

inline void TiltLensTracer::Begin(Ray& ray, const tilt_lens::CameraRays& rays, unsigned int place) const
{
    const VECTOR& location = trace.camera.Location;
    for (int axis = X; axis <= Z; axis++)
    {
        ray.Origin[axis] = location[axis] + rays.origin[axis][place];
        ray.Direction[axis] = rays.direction[axis][place];
    }
}

/// For a camera with a normal, or a lens that is partly inside an object.
void TiltLensTracer::BeginSpecially(Ray& ray, const tilt_lens::CameraRays& rays, unsigned int place)
{
    if (trace.camera.Tnormal != NULL)
    {
        VECTOR film = {rays.samples.x[place], rays.samples.y[place], 0.0};
        Perturb_Normal(ray.Direction, trace.camera.Tnormal, film, NULL, NULL, trace.threadData);
        VNormalizeEq(ray.Direction);
    }
    if (interiorsVary)
    {
        Ray other = CameraRayOfPov();
        Assign_Vector(other.Origin, ray.Origin);
        Assign_Vector(other.Direction, ray.Direction);
        EnterInteriors(other);
        ray = other;
    }
}

/// @param ticket  a new one
inline void TiltLensTracer::TraceRay(const Ray& ray, Trace::TraceTicket ticket, double weight, Radiance& radiance)
{
    trace.ForgetRays();
    BeginNumbers();
    areaLightsMet = 0;
    Colour colour;
    trace.TraceRay(ray, colour, 1.0, ticket, false, trace.camera.Max_Ray_Distance);
    radiance = {weight * colour[pRED], weight * colour[pGREEN], weight * colour[pBLUE], weight * colour[pFILTER],
                weight * colour[pTRANSM]};
}

/// Circles of confusion of the hit points.
void TiltLensTracer::FindCircles(const tilt_lens::CameraRays& rays, unsigned int place, unsigned int count, const DBL* distances,
                                 tilt_lens::SampleResult* results) const
{
    const tilt_lens::CameraSamples& samples = rays.samples;
    for (unsigned int i = 0; i < count; i++)
    {
        const unsigned int at = place + i;
        results[i].circle = tilt_lens::CircleOfConfusion();
        if (samples.weight[at] != 0.0)
            results[i].circle = view->footprint.CircleOf({samples.x[at], samples.y[at]}, {samples.a[at], samples.b[at]},
                                                         rays.length[at] / distances[i] - rays.w[at]);
    }
}

/// A pixel averages over many rays, so that one random point of an area light per ray has the mean of the whole grid for one shadow ray (R.
/// L. Cook, T. Porter, L. Carpenter, "Distributed Ray Tracing", 1984). Radiosity, which reuses its samples, and focus aids, which take one
/// ray per pixel, get the whole grid.
bool TiltLensTracer::ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v)
{
    if (trace.pretrace || radiosityDepth > 0)
        return false;
    const tilt_lens::Pair point = pixel->PaddedPair(index, areaLightsMet++);
    areaLightPointsSkipped += std::uint64_t(light.Area_Size1) * light.Area_Size2 - 1;
    areaLightPoints++;
    u = PointOfRow(light.Area_Size1, point.u);
    v = PointOfRow(light.Area_Size2, point.v);
    return true;
}

/// Tests only the objects that may contain lens points.
void TiltLensTracer::EnterInteriors(Ray& ray) const
{
    for (const ObjectAroundLens& around : view->aroundLens)
    {
        const ObjectPtr object = around.object;
        if (around.holdsLens ||
            (Inside_BBox(ray.Origin, object->BBox) && object->Inside(ray.Origin, trace.threadData)))
            ray.AppendInterior(object->interior);
    }
}

/// Connects generators to the seeds of samples. Not in the constructor, which runs before that of media.
void TiltLensTracer::LeadGenerators()
{
    trace.crandSeeds.Follow(*this);
    trace.randomNumberGenerator.seeds.Follow(*this);
    if (RandomDoubleSequence::Generator* const ofMedia = trace.media.RandomNumbers())
        ofMedia->seeds.Follow(*this);
}

/// Seeds every generator that the sample may use.
void TiltLensTracer::BeginNumbers()
{
    BeginSample();
    if (trace.sceneData->useSubsurface)
        SeedSubsurface(Seed());
}

/// Creates the sequences of subsurface light, one per recursion level, which Trace would create when first needed: so the sample determines
/// their first numbers, too.
void TiltLensTracer::SeedSubsurface(unsigned int seed)
{
    const size_t levels = 3, length = 32767;  // as deep and as long as Trace makes them
    while (trace.ssltUniformDirectionGenerator.size() < levels)
        trace.ssltUniformDirectionGenerator.push_back(GetSubRandomDirectionGenerator(0, length));
    while (trace.ssltUniformNumberGenerator.size() < levels)
        trace.ssltUniformNumberGenerator.push_back(GetRandomDoubleGenerator(0.0, 1.0, length));
    while (trace.ssltCosWeightedDirectionGenerator.size() < levels)
        trace.ssltCosWeightedDirectionGenerator.push_back(GetSubRandomCosWeightedDirectionGenerator(2, length));
    Reseed(trace.ssltUniformDirectionGenerator, seed);
    Reseed(trace.ssltUniformNumberGenerator, seed);
    Reseed(trace.ssltCosWeightedDirectionGenerator, seed);
}

void TiltLensTracer::TracePreview(DBL x, DBL y, DBL width, DBL height, Colour& colour)
{
    if (view->aids)
    {
        TraceAid(x, y, width, height, colour);
        return;
    }
    const unsigned int samples = trace.pretrace ? 1 : std::min(view->limits.min, view->limits.max);
    // pretrace positions lie between pixels and, at the picture's edge, outside
    SampleId id{(unsigned int)std::max(0.0, x), (unsigned int)std::max(0.0, y), 0};
    const PixelSampler sequence(id.x, id.y, view->seed);
    colour.clear();
    for (id.index = 0; id.index < samples; id.index++)
    {
        tilt_lens::SampleResult result;
        tilt_lens::CameraRay camera;
        const tilt_lens::SequencePoint point = sequence(id.index);
        camera.Draw(*view->camera, id, point, tilt_lens::FilmPointAt(id.x + point.pixelX, id.y + point.pixelY, width, height));
        pixel = &sequence;
        index = id.index;
        TraceSample(camera, result);
        colour += ToColour(result.radiance);
    }
    colour /= samples;
}

void TiltLensTracer::TraceTile(const POVRect& rect, unsigned int width, unsigned int height, bool alone,
                               std::vector<Colour>& pixels)
{
    if (view->aids)
    {
        TraceAidTile(rect, width, height, pixels);
        return;
    }
    const tilt_lens::Area tile = AreaOf(rect);
    tilt_lens::BlockCache own(view->limits, width, height, tile);
    tilt_lens::TileSampler sampler(alone ? own : *view->blocks);
    tilt_lens::CameraRayBatch rays(*view->camera, view->emitters, view->seed);
    Ray ray = CameraRayOfPov();
    areaLightPoints = areaLightPointsSkipped = 0;
    refusedRays = 0;
    sampler.Run(tile, [&](const tilt_lens::SampleRun& run, tilt_lens::SampleResult* results)
        { TraceRun(rays, run, ray, results); });

    pixels.clear();
    effort.clear();
    for (unsigned int y = tile.top; y < tile.Bottom(); y++)
        for (unsigned int x = tile.left; x < tile.Right(); x++)
        {
            pixels.push_back(ToColour(sampler.Mean(x, y)));
            effort.push_back({sampler.Samples(x, y), sampler.Variance(x, y)});
        }
    tilt_lens::SamplingStatistics statistics = sampler.Statistics();
    statistics.lightPoints = areaLightPoints;
    statistics.lightPointsSkipped = areaLightPointsSkipped;
    statistics.refusedRays = refusedRays;
    view->Add(statistics);
    trace.threadData->Stats()[Number_Of_Pixels] += statistics.Pixels();
    trace.threadData->Stats()[Number_Of_Samples] += statistics.Samples();
}

void TiltLensTracer::EstimateWork()
{
    const tilt_lens::SamplingLimits& limits = view->limits;
    const unsigned int samples = std::min(tilt_lens::settings.probeSamples, limits.max);
    const RenderStatistics& stats = trace.threadData->Stats();
    tilt_lens::CameraRayBatch rays(*view->camera, view->emitters, view->seed);
    Ray ray = CameraRayOfPov();
    const auto raysTraced = [&] { return stats[Number_Of_Rays] + stats[Shadow_Ray_Tests]; };
    while (const auto probe = view->progress.NextProbe())
    {
        const auto before = raysTraced();
        static_assert(tilt_lens::settings.probeSamples <= tilt_lens::settings.cameraRaysOfBatch, "they are one run");
        tilt_lens::SampleResult results[tilt_lens::settings.probeSamples];
        TraceRun(rays, {{probe->x, probe->y, 0}, samples}, ray, results);
        std::vector<Radiance> tried;
        for (unsigned int sample = 0; sample < samples; sample++)
            tried.push_back(results[sample].radiance);
        view->progress.SetWeight(probe->block, (raysTraced() - before) * ExpectedSamples(limits, tried));
    }
}

/// Final render of a `tilt_lens` picture; replaces all anti-aliasing methods.
void TraceTask::TiltLensSampling()
{
    POVRect rect;
    std::vector<Colour> pixels;
    unsigned int serial;

    TiltLensTracer& tracer = *TiltLensTracer::Of(trace);
    tracer.EstimateWork();
    while (GetViewData()->GetNextRectangle(rect, serial) == true)
    {
        radiosity.BeforeTile(highReproducibility ? serial : 0);
        // reproducible radiosity starts each tile afresh
        tracer.TraceTile(rect, GetViewData()->GetWidth(), GetViewData()->GetHeight(),
                         highReproducibility && GetSceneData()->radiositySettings.radiosityEnabled, pixels);
        radiosity.AfterTile();

        GetViewData()->GetTiltLens()->progress.Finish(AreaOf(rect));
        GetViewDataPtr()->AfterTile();
        SendLayers(rect);
        GetViewData()->CompletedRectangle(rect, serial, pixels, 1, finalTrace);

        Cooperate();
    }
}

} // namespace pov
