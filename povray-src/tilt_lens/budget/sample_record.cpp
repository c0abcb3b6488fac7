// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/sample_record.h"

#include <algorithm>

namespace tilt_lens
{

bool SampleRecord::Get(const SampleRun& run, SampleResult* results) const
{
    const Pixel& pixel = pixels[area.IndexOf(run.first.x, run.first.y)];
    if (pixel.samples.size() < run.first.index + run.count)
        return false;
    for (std::uint32_t i = 0; i < run.count; i++)
    {
        const std::uint32_t index = run.first.index + i;
        const Recorded& recorded = pixel.samples[index];
        const CircleOfConfusion circle = index < pixel.circles.size() ? pixel.circles[index] : CircleOfConfusion();
        results[i].radiance = recorded.radiance;
        results[i].expectedEmission = recorded.expectedEmission;
        results[i].circle = circle;
    }
    return true;
}

void SampleRecord::GetOrTrace(const SampleRun& run, SampleResult* results, const Tracer& trace)
{
    if (Get(run, results))
        return;
    trace.Trace(run, results);
    Pixel& pixel = pixels[area.IndexOf(run.first.x, run.first.y)];
    for (std::uint32_t i = std::uint32_t(pixel.samples.size()) - run.first.index; i < run.count; i++)
    {
        pixel.samples.push_back({results[i].radiance, results[i].expectedEmission});
        if (run.first.index + i < mostSent)
            pixel.circles.push_back(results[i].circle);
        samples++;
    }
}

std::size_t SampleRecord::BytesOf(double samples, std::uint32_t mostSent)
{
    return std::size_t(samples * sizeof(Recorded) + std::min<double>(samples, mostSent) * sizeof(CircleOfConfusion));
}

} // namespace tilt_lens
