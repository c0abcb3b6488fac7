// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file record_samples.cpp
/// POV-Ray that writes `tilt_lens` pictures' first samples into a file for replay_samples.
///
///     TILT_LENS_RECORD=FILE TILT_LENS_RECORD_SAMPLES=N TILT_LENS_SETTINGS=NAME=VALUE,... record_samples +Iscene.pov ...

#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stdexcept>
#include <string>

#include "named_settings.h"
#include "recorded_sample.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

using namespace tilt_lens;

namespace
{

std::string Environment(const char* name)
{
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

struct Recorder
{
    std::mutex mutex;
    std::FILE* file = std::fopen(Environment("TILT_LENS_RECORD").c_str(), "wb");
    const std::uint32_t samples = std::strtoul(Environment("TILT_LENS_RECORD_SAMPLES").c_str(), nullptr, 10);

    ~Recorder()
    {
        if (file != nullptr)
            std::fclose(file);
    }

    void Record(const SampleId& id, const SampleResult& result)
    {
        const RecordedSample sample(id, result);
        if (file == nullptr || std::fwrite(&sample, sizeof sample, 1, file) != 1)
            throw std::runtime_error("cannot write the file that TILT_LENS_RECORD names");
    }
} recorder;

} // namespace

// These functions take the place of the library's: the linker finds them first.

Settings tilt_lens::DefaultSettings()
{
    return SettingsNamed(Environment("TILT_LENS_SETTINGS"));
}

/// Records the tile; its pixels stay black.
void TileSampler::Run(const Area& wanted, const Tracer& trace)
{
    tile = wanted;
    pixels.assign(tile.Size(), PixelResult());
    for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
        for (std::uint32_t x = tile.left; x < tile.Right(); x++)
            for (std::uint32_t index = 0; index < recorder.samples; index++)
            {
                SampleResult result;
                trace.Trace({{x, y, index}, 1}, &result);
                const std::lock_guard<std::mutex> lock(recorder.mutex);
                recorder.Record({x, y, index}, result);
            }
}

SamplingStatistics TileSampler::Statistics() const
{
    SamplingStatistics statistics;
    statistics.pixelsBySamples[recorder.samples] = pixels.size();
    return statistics;
}
