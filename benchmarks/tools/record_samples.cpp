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

#include "recorded_sample.h"
#include "tilt_lens/sampling/tile_sampler.h"
#include "variable_settings.h"

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

    Recorder() { Vary(Environment("TILT_LENS_SETTINGS")); }
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

// --wrap leads TileSampler::Run here.
#define RUN _ZN9tilt_lens11TileSampler3RunERKNS_4AreaERKNS_6TracerE
#define JOIN(a, b) a##b
#define NAMED(prefix, name) JOIN(prefix, name)

extern "C" void NAMED(__real_, RUN)(TileSampler* sampler, const Area& tile, const Tracer& trace);

extern "C" void NAMED(__wrap_, RUN)(TileSampler* sampler, const Area& tile, const Tracer& trace)
{
    for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
        for (std::uint32_t x = tile.left; x < tile.Right(); x++)
            for (std::uint32_t index = 0; index < recorder.samples; index++)
            {
                SampleResult result;
                trace.Trace({{x, y, index}, 1}, &result);
                const std::lock_guard<std::mutex> lock(recorder.mutex);
                recorder.Record({x, y, index}, result);
            }
    NAMED(__real_, RUN)(sampler, tile, [](const SampleId&, SampleResult& black) { black = Radiance{}; });
}
