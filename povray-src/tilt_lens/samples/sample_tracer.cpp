// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/sample_tracer.h"

#include <array>

namespace tilt_lens
{

namespace
{

/// Random pair for the place in a third of the spectrum; area lights count from 0.
constexpr std::uint32_t kHuePair = 0x487565;

} // namespace

void SampleTracer::Trace(const SampleRun& run, SampleResult* results)
{
    batch.Make(run);
    refusedRays += batch.Refused();
    if (!camera.lens->HasColours())
        return TraceRays(batch.Rays(), run.Place(), run.first.index, run.count, results);
    for (std::uint32_t i = 0; i < run.count; i++)
        TraceColours(run.Place() + i, run.first.index + i, results[i]);
}

/// @param place  of the first ray
/// @param index  of its sample
void SampleTracer::TraceRays(const CameraRays& rays, std::uint32_t place, std::uint32_t index, std::uint32_t count, SampleResult* results)
{
    const CameraSamples& samples = rays.samples;
    const bool spreads = camera.spreads && index < camera.limits.settings.mostSentSamples;
    Hit hits[Settings::cameraRaysOfBatch];
    std::uint32_t begin = 0;
    for (std::uint32_t i = 0; i <= count; i++)
    {
        if (i < count && samples.weight[place + i] != 0.0)
            continue;
        // a blocked ray, or the end
        if (i > begin)
            rayTracer.Trace(rays, {place + begin, i - begin, index + begin, batch.Sampler(), spreads}, hits + begin);
        begin = i + 1;
    }
    for (std::uint32_t i = 0; i < count; i++)
    {
        const std::uint32_t at = place + i;
        const double weight = samples.weight[at];
        SampleResult& result = results[i];
        for (std::size_t channel = 0; channel < result.radiance.size(); channel++)
            result.radiance[channel] = weight * hits[i].radiance[channel];
        result.expectedEmission = samples.expectedEmission[at];
        result.circle = CircleOfConfusion();
        if (spreads && weight != 0.0)
            result.circle = camera.footprint.CircleOf({samples.x[at], samples.y[at]}, {samples.a[at], samples.b[at]},
                                                      rays.length[at] / hits[i].distance - rays.w[at]);
        result.circle.weight = float(samples.overPlain[at]);
    }
}

/// One ray per third of the spectrum, for red, green and blue. All draw the same random numbers, so uniform grey has no colour noise.
void SampleTracer::TraceColours(std::uint32_t place, std::uint32_t index, SampleResult& result)
{
    const double within = batch.Sampler().PaddedPair(index, kHuePair).u;
    std::array<double, 3> hues;
    for (int colour = 0; colour < 3; colour++)
        hues[colour] = 1.0 - 2.0 / 3.0 * (colour + within);
    CameraRays rays;
    batch.MakeColours(place, hues, rays);
    refusedRays += batch.Refused();
    Radiance mixed{};
    for (int colour = 0; colour < 3; colour++)
    {
        TraceRays(rays, colour, index, 1, &result);
        mixed[colour] = result.radiance[colour];
        for (int c = 3; c < 5; c++)
            mixed[c] += result.radiance[c] / 3.0;
    }
    result.radiance = mixed;
}

} // namespace tilt_lens
