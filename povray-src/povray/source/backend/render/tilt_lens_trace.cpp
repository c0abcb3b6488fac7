// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_trace.cpp
/// TracePixel's and TraceTask's part in `tilt_lens` pictures: one sample, one tile, one preview pixel.

#include <algorithm>
#include <vector>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/math/vector.h"
#include "backend/render/tracepixel.h"
#include "backend/render/tilt_lens_ways.h"
#include "backend/render/tracetask.h"
#include "backend/scene/tilt_lens_view.h"
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

/// The point of a row that x in (0, 1) chooses, in the proportions in which POV-Ray averages them: it
/// halves a row of an area light again and again, and both halves have the middle point of an odd one.
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

tilt_lens::Area AreaOf(const POVRect& rect)
{
    return {(unsigned int)rect.left, (unsigned int)rect.top, (unsigned int)rect.GetWidth(),
            (unsigned int)rect.GetHeight()};
}

template<class Number>
void Reseed(std::vector<shared_ptr<SequentialNumberGenerator<Number> > >& generators, unsigned int seed)
{
    for (size_t i = 0; i < generators.size(); i++)
        dynamic_cast<SeedableNumberGenerator<Number>&>(*generators[i]).Seed(seed + i);
}

} // namespace

/// The way from the film in, light out.
void TracePixel::TraceTiltLensSample(const PixelSampler& pixel, unsigned int index, const TiltLensWay& way, DBL width,
                                     tilt_lens::Traced& traced)
{
    const tilt_lens::Start& start = way.start;
    if (start.weight == 0.0)
    {
        traced = Radiance{};
        traced.sought = start.sought;
        traced.met = false;
        return;
    }
    // from a point of the lens through the focus of that film point
    Ray ray(Ray::PrimaryRay, false, false, false, false, pretrace);
    const tilt_lens::Vec3& origin = way.ray.origin;
    Make_Vector(ray.Origin, camera.Location[X] + origin.x, camera.Location[Y] + origin.y, camera.Location[Z] + origin.z);
    Make_Vector(ray.Direction, way.direction.x, way.direction.y, way.direction.z);
    if (camera.Tnormal != NULL)
    {
        VECTOR film = {start.x, start.y, 0.0};
        Perturb_Normal(ray.Direction, camera.Tnormal, film, NULL, NULL, threadData);
        VNormalizeEq(ray.Direction);
    }
    if (!tiltLens->aroundLens.empty())
        EnterTiltLensInteriors(ray);

    // whatever draws random numbers on the way draws this sample's own
    SeedRandomNumbers(pixel.Hash(index));
    tiltLensPixel = &pixel;
    tiltLensSample = index;
    areaLightsMet = 0;
    Colour colour;
    Trace::TraceTicket ticket(maxTraceLevel, adcBailout, sceneData->outputAlpha);
    const DBL distance = TraceRay(ray, colour, 1.0, ticket, false, camera.Max_Ray_Distance);
    tiltLensPixel = NULL;
    traced.light = {start.weight * colour[pRED], start.weight * colour[pGREEN], start.weight * colour[pBLUE],
                    start.weight * colour[pFILTER], start.weight * colour[pTRANSM]};
    traced.sought = start.sought;
    traced.met = distance < HUGE_VAL || !sceneData->atmosphere.empty();
    traced.blur = tiltLens->BlurRadius(way.ray.w, distance / way.length, width);
}

/// The rays of a pixel average over the lens anyway, so one point of an area light for each has the mean
/// of the whole grid at the cost of one shadow ray (R. L. Cook, T. Porter, L. Carpenter, "Distributed Ray
/// Tracing", 1984). Radiosity keeps its samples for other pixels and gets the whole light, as does the one ray of a
/// pixel with focus aids.
bool TracePixel::ChooseAreaLightPoint(const LightSource& light, const TraceTicket& ticket, int& u, int& v)
{
    if (tiltLensPixel == NULL || pretrace || ticket.radiosityRecursionDepth > 0)
        return false;
    const tilt_lens::Pair point = tiltLensPixel->Further(tiltLensSample, areaLightsMet++);
    areaLightPointsLeft += std::uint64_t(light.Area_Size1) * light.Area_Size2 - 1;
    areaLightPoints++;
    u = PointOfRow(light.Area_Size1, point.u);
    v = PointOfRow(light.Area_Size2, point.v);
    return true;
}

/// The lens points of one picture lie in few objects or none: the view has found out which to ask.
void TracePixel::EnterTiltLensInteriors(Ray& ray)
{
    for (const ObjectAroundLens& around : tiltLens->aroundLens)
    {
        const ObjectPtr object = around.object;
        if (around.holdsLens || (Inside_BBox(ray.Origin, object->BBox) && object->Inside(ray.Origin, threadData)))
            ray.AppendInterior(object->interior);
    }
}

void TracePixel::SeedRandomNumbers(unsigned int seed)
{
    crandRandomNumberGenerator = seed;
    randomNumberGenerator.SetSeed(seed);
    media.SeedRandomNumbers(seed);
    if (sceneData->useSubsurface)
        SeedSubsurface(seed);
}

/// Subsurface light draws from sequences of its own, one a recursion level, made when first needed;
/// they are made here, so that their first numbers too are the sample's.
void TracePixel::SeedSubsurface(unsigned int seed)
{
    const size_t levels = 3, length = 32767;  // as deep and as long as Trace itself makes them
    while (ssltUniformDirectionGenerator.size() < levels)
        ssltUniformDirectionGenerator.push_back(GetSubRandomDirectionGenerator(0, length));
    while (ssltUniformNumberGenerator.size() < levels)
        ssltUniformNumberGenerator.push_back(GetRandomDoubleGenerator(0.0, 1.0, length));
    while (ssltCosWeightedDirectionGenerator.size() < levels)
        ssltCosWeightedDirectionGenerator.push_back(GetSubRandomCosWeightedDirectionGenerator(2, length));
    Reseed(ssltUniformDirectionGenerator, seed);
    Reseed(ssltUniformNumberGenerator, seed);
    Reseed(ssltCosWeightedDirectionGenerator, seed);
}

/// A pixel of a preview or of a radiosity pretrace: not for the final picture, so a few samples do,
/// one where only the places that are seen matter.
void TracePixel::TraceTiltLensPreview(DBL x, DBL y, DBL width, DBL height, Colour& colour)
{
    if (tiltLens->aids)
    {
        TraceTiltLensAid(x, y, width, height, colour);
        return;
    }
    const unsigned int samples = pretrace ? 1 : std::min(tiltLens->limits.min, tiltLens->limits.max);
    // pretrace positions lie between pixels and, at the picture's edge, outside
    SampleId id{(unsigned int)std::max(0.0, x), (unsigned int)std::max(0.0, y), 0};
    const PixelSampler pixel(id.x, id.y, 0);
    colour.clear();
    for (id.index = 0; id.index < samples; id.index++)
    {
        tilt_lens::Traced traced;
        TiltLensWay way{tiltLens->emitters.Aim({}, id, pixel(id.index))};
        way.FindRay(tiltLens->lens);
        TraceTiltLensSample(pixel, id.index, way, width, traced);
        colour += ToColour(traced.light);
    }
    colour /= samples;
}

/// A tile of the final picture. Where a pixel depends on what else its tile traced, tiles share nothing.
void TracePixel::TraceTiltLensTile(const POVRect& rect, unsigned int width, unsigned int height, bool alone,
                                   std::vector<Colour>& pixels)
{
    if (tiltLens->aids)
    {
        TraceTiltLensAidTile(rect, width, height, pixels);
        return;
    }
    const tilt_lens::Area tile = AreaOf(rect);
    tilt_lens::CellStore own(tiltLens->limits, width, height, tile);
    tilt_lens::TileSampler sampler(alone ? own : *tiltLens->cells);
    TiltLensWays ways(*tiltLens);
    areaLightPoints = areaLightPointsLeft = 0;
    sampler.Run(tile, [&](const SampleId& id, tilt_lens::Traced& traced)
    {
        const TiltLensWay& way = ways.Of(id);
        TraceTiltLensSample(ways.Sampler(), id.index, way, width, traced);
    });

    pixels.clear();
    tileEffort.clear();
    for (unsigned int y = tile.top; y < tile.Bottom(); y++)
        for (unsigned int x = tile.left; x < tile.Right(); x++)
        {
            pixels.push_back(ToColour(sampler.Mean(x, y)));
            tileEffort.push_back({sampler.Samples(x, y), sampler.Variance(x, y)});
        }
    tilt_lens::SamplingAccount account = sampler.Account();
    account.lightPoints = areaLightPoints;
    account.lightPointsLeft = areaLightPointsLeft;
    tiltLens->Add(account);
    threadData->Stats()[Number_Of_Pixels] += account.Pixels();
    threadData->Stats()[Number_Of_Samples] += account.Samples();
}

/// Before the first tile, all threads together try some pixels, so that progress can be told.
void TracePixel::TryTiltLensWork(unsigned int width, unsigned int height)
{
    const tilt_lens::SamplingLimits& limits = tiltLens->limits;
    const unsigned int samples = std::min(tilt_lens::WorkMap::kTries, limits.max);
    const RenderStatistics& stats = threadData->Stats();
    TiltLensWays ways(*tiltLens);
    const auto rays = [&] { return stats[Number_Of_Rays] + stats[Shadow_Ray_Tests]; };
    while (const auto probe = tiltLens->work.NextProbe())
    {
        const auto before = rays();
        std::vector<Radiance> tried;
        tilt_lens::Traced traced;
        for (unsigned int index = 0; index < samples; index++)
        {
            const TiltLensWay& way = ways.Of({probe->x, probe->y, index});
            TraceTiltLensSample(ways.Sampler(), index, way, width, traced);
            tried.push_back(traced.light);
        }
        tiltLens->work.SetWeight(probe->block, (rays() - before) * ExpectedSamples(limits, tried));
    }
}

/// Final render of a `tilt_lens` picture: takes the place of all anti-aliasing methods.
void TraceTask::TiltLensSampling()
{
    POVRect rect;
    std::vector<Colour> pixels;
    unsigned int serial;

    trace.TryTiltLensWork(GetViewData()->GetWidth(), GetViewData()->GetHeight());
    while (GetViewData()->GetNextRectangle(rect, serial) == true)
    {
        radiosity.BeforeTile(highReproducibility ? serial : 0);
        // radiosity that is to be reproducible begins each tile anew
        trace.TraceTiltLensTile(rect, GetViewData()->GetWidth(), GetViewData()->GetHeight(),
                                highReproducibility && GetSceneData()->radiositySettings.radiosityEnabled, pixels);
        radiosity.AfterTile();

        GetViewData()->GetTiltLens()->work.Finish(AreaOf(rect));
        GetViewDataPtr()->AfterTile();
        SendLayers(rect);
        GetViewData()->CompletedRectangle(rect, serial, pixels, 1, finalTrace);

        Cooperate();
    }
}

} // namespace pov
