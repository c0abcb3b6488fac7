// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/camera_rays.h"

#include <numeric>

namespace tilt_lens
{

namespace
{

void PutFour(const FourGlassSamples& four, std::uint32_t first, CameraRays& rays)
{
    for (std::uint32_t i = 0; i < 4; i++)
    {
        const std::uint32_t place = first + i;
        rays.samples.weight[place] = four.weight[i];
        if (four.weight[i] != 0.0)
            rays.Put(place, four.RayOf(i));
    }
}

} // namespace

void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays)
{
    const CameraSamples& from = rays.samples;
    auto &o = rays.origin, &d = rays.direction;
    MakeRays(lens, {from.x, from.y, from.a, from.b, {o[0], o[1], o[2]}, {d[0], d[1], d[2]}, rays.length, rays.w}, run.Place(),
             run.Place() + run.count);
}

void CameraRayBatch::Make(const SampleRun& run)
{
    const SampleId& pixel = run.first;
    if (empty || pixel.x != last.first.x || pixel.y != last.first.y)
    {
        empty = false;
        sampler = PixelSampler(pixel.x, pixel.y, camera.seed);
        if (aims)
            targets = camera.emitters.TargetsOf(pixel.x, pixel.y);
        if (glass != nullptr)
            glassSeeds = PixelSampler(pixel.x, pixel.y, camera.lens->SeedSalt());
    }
    last = run;
    sampler.FindGroup(run.first.index, points);
    if (glass != nullptr)
        return MakeOfGlass(run);
    camera.emitters.Draw(targets, run, points, rays.samples);
    FindRays(camera.lens->Solved(), run, rays);
}

void CameraRayBatch::MakeOfGlass(const SampleRun& run)
{
    refused = 0;
    camera.lensSampler.DrawFilmPoints(run, points, rays.samples);
    const std::uint32_t end = run.Place() + run.count;
    if (glass->HasColours())  // MakeColours() makes their rays
        for (std::uint32_t i = run.Place(); i < end; i++)
            rays.samples.weight[i] = glass->Brightness({rays.samples.x[i], rays.samples.y[i]});
    else
        for (std::uint32_t first = Quads(run).begin; first < end; first += 4)
            DrawFour(run, first);
}

/// @param first  position in the group of the four
void CameraRayBatch::DrawFour(const SampleRun& run, std::uint32_t first)
{
    FourGlassPoints four{};
    for (std::uint32_t i = 0; i < 4; i++)
        if (const std::uint32_t place = first + i; place >= run.Place() && place < run.Place() + run.count)
            PutPoint(place, 0.0, i, four);
    FourGlassSamples samples;
    glass->Draw(four, samples);
    for (std::uint32_t i = 0; i < 4; i++)
        Weigh(first + i, 0.0, i, samples);
    PutFour(samples, first, rays);
    refused = std::accumulate(samples.refused, samples.refused + 4, refused);
}

/// @param place  of the sample in its group
/// @param i      its number in `four`
void CameraRayBatch::PutPoint(std::uint32_t place, double hue, std::uint32_t i, FourGlassPoints& four)
{
    const std::uint32_t index = last.first.index - last.Place() + place;
    four.x[i] = rays.samples.x[place], four.y[i] = rays.samples.y[place];
    four.u[i] = points.lensU[place], four.v[i] = points.lensV[place];
    four.seed[i] = glassSeeds.Hash(index);
    four.wanted |= 1u << i;
    rays.samples.expectedEmission[place] = 0.0;
    if (!camera.emitters.MayAim(targets, index))
        return;
    const EmitterSampling::Choice choice = camera.emitters.Choose(targets, {four.x[i], four.y[i]}, four.u[i], four.v[i], hue);
    four.u[i] = choice.u, four.v[i] = choice.v;
    four.aimed |= (choice.aimed ? 1u : 0u) << i;
    rays.samples.expectedEmission[place] = choice.expectedEmission;
}

void CameraRayBatch::Weigh(std::uint32_t place, double hue, std::uint32_t i, FourGlassSamples& four) const
{
    const std::uint32_t index = last.first.index - last.Place() + place;
    if (four.weight[i] != 0.0 && camera.emitters.MayAim(targets, index))
        four.weight[i] *= camera.emitters.OverPlain(targets, {rays.samples.x[place], rays.samples.y[place]}, {four.a[i], four.b[i]}, hue);
}

void CameraRayBatch::MakeColours(std::uint32_t place, const std::array<double, 3>& hues, CameraRays& made)
{
    const CameraSample sample = rays.samples[place];
    for (std::uint32_t i = 0; i < hues.size(); i++)
        made.samples.Put(i, sample);
    refused = 0;
    if (sample.weight == 0.0)
        return;
    if (glass == nullptr)
    {
        for (std::uint32_t i = 0; i < hues.size(); i++)
            made.Put(i, MakeColourRay(camera.lens->Solved(), sample.x, sample.y, sample.point.a, sample.point.b, hues[i]));
        return;
    }
    FourGlassPoints four{};
    for (std::uint32_t i = 0; i < hues.size(); i++)
        PutPoint(place, hues[i], i, four);
    FourGlassSamples drawn;
    glass->DrawColours(four, hues, drawn);
    for (std::uint32_t i = 0; i < hues.size(); i++)
    {
        Weigh(place, hues[i], i, drawn);
        made.samples.expectedEmission[i] = rays.samples.expectedEmission[place];
    }
    PutFour(drawn, 0, made);
    refused = std::accumulate(drawn.refused, drawn.refused + hues.size(), 0u);
}

} // namespace tilt_lens
