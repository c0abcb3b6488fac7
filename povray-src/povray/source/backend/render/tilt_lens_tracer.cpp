// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/render/tilt_lens_tracer.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/render/chief_camera_ray.h"
#include "backend/render/trace_aids.h"
#include "backend/render/tracepixel.h"
#include "tilt_lens/samples/lamp_search.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Radiance;

namespace
{

template<class Number>
void Reseed(std::vector<shared_ptr<SequentialNumberGenerator<Number>>>& generators, unsigned int seed)
{
    for (size_t i = 0; i < generators.size(); i++)
        dynamic_cast<SeedableNumberGenerator<Number>&>(*generators[i]).Seed(seed + i);
}

} // namespace

TiltLensTracer::TiltLensTracer(TracePixel& owner, const shared_ptr<TiltLensView>& itsView) :
    view(itsView),
    samples(view->camera, *this),
    trace(owner),
    plainSamples(view->camera, *this, false),
    interiorsVary(
        std::any_of(view->aroundLens.begin(), view->aroundLens.end(), [](const ObjectAroundLens& around) { return !around.holdsLens; }))
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

void TiltLensTracer::Trace(const tilt_lens::CameraRays& rays, const tilt_lens::RayRange& range, tilt_lens::Hit* hits)
{
    const pov::Trace::TraceTicket ticket = NewTicket();
    const VECTOR& location = trace.camera.Location;
    Ray ray(Ray::PrimaryRay, false, false, false, false, trace.pretrace);
    if (!interiorsVary)
        EnterInteriors(ray);
    pixel = &range.sequence;
    trace.areaLightSampler = trace.pretrace ? NULL : &areaLights;
    trace.lightPath.wanted = range.distances;
    LeadGenerators();
    for (unsigned int i = 0; i < range.count; i++)
    {
        const unsigned int place = range.place + i;
        for (int axis = X; axis <= Z; axis++)
        {
            ray.Origin[axis] = location[axis] + rays.origin[axis][place];
            ray.Direction[axis] = rays.direction[axis][place];
        }
        BendByNormal(ray, trace.camera, rays.samples.x[place], rays.samples.y[place], trace.threadData);
        if (interiorsVary)
        {
            ray.ClearInteriors();
            EnterInteriors(ray);
        }
        trace.ForgetRays();
        index = range.index + i;
        areaLights.Begin(*pixel, index);
        Colour colour;
        Follow(ray, ticket, colour);
        hits[i] = {{colour[pRED], colour[pGREEN], colour[pBLUE], colour[pFILTER], colour[pTRANSM]}, trace.lightPath.Length()};
    }
    trace.areaLightSampler = NULL;
    trace.lightPath.wanted = false;
    EndSample();
}

inline DBL TiltLensTracer::Follow(const Ray& ray, pov::Trace::TraceTicket ticket, Colour& colour)
{
    BeginSample();
    if (trace.sceneData->useSubsurface)
        SeedSubsurface(Seed());
    return trace.TraceRay(ray, colour, 1.0, ticket, false, trace.camera.Max_Ray_Distance);
}

DBL TiltLensTracer::TraceAlone(const Ray& ray, unsigned int x, unsigned int y, Colour& colour)
{
    const tilt_lens::PixelSampler sequence(x, y, view->camera.seed);
    pixel = &sequence;
    index = 0;
    LeadGenerators();
    const DBL distance = Follow(ray, NewTicket(), colour);
    EndSample();
    return distance;
}

pov::Trace::TraceTicket TiltLensTracer::NewTicket() const
{
    return pov::Trace::TraceTicket(trace.maxTraceLevel, trace.adcBailout, trace.sceneData->outputAlpha, radiosityDepth);
}

void TiltLensTracer::Search(std::size_t row)
{
    const SceneRadiositySettings& radiosity = trace.sceneData->radiositySettings;
    radiosityDepth = radiosity.radiosityEnabled ? radiosity.recursionLimit : 0;
    view->search->Take(row, *this);
    radiosityDepth = 0;
}

const Camera& TiltLensTracer::GetCamera() const
{
    return trace.camera;
}

RenderStatistics& TiltLensTracer::Stats()
{
    return trace.threadData->Stats();
}

void TiltLensTracer::EnterInteriors(Ray& ray) const
{
    for (const ObjectAroundLens& around : view->aroundLens)
    {
        const ObjectPtr object = around.object;
        if (around.holdsLens || (Inside_BBox(ray.Origin, object->BBox) && object->Inside(ray.Origin, trace.threadData)))
            ray.AppendInterior(object->interior);
    }
}

/// Not in the constructor, which runs before that of media.
void TiltLensTracer::LeadGenerators()
{
    trace.crandSeeds.Follow(*this);
    trace.randomNumberGenerator.seeds.Follow(*this);
    if (RandomDoubleSequence::Generator* const ofMedia = trace.media.RandomNumbers())
        ofMedia->seeds.Follow(*this);
}

/// One sequence per recursion level, so that the sample determines their first numbers.
void TiltLensTracer::SeedSubsurface(unsigned int seed)
{
    const size_t levels = 3, length = 32767;
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
    colour.clear();
    if (view->aids)
    {
        colour = AidPixel(trace, x, y, width, height);
        return;
    }
    const tilt_lens::SamplingLimits& limits = view->camera.limits;
    const unsigned int count = trace.pretrace ? 1 : std::min(limits.min, limits.max);
    // pretrace positions may lie outside the picture
    tilt_lens::SampleId id{(unsigned int)std::max(0.0, x), (unsigned int)std::max(0.0, y), 0};
    for (; id.index < count; id.index++)
    {
        tilt_lens::SampleResult result;
        plainSamples.Trace({id, 1}, &result);
        colour += ToColour(result.radiance);
    }
    colour /= count;
}

} // namespace pov
