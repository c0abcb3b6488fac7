// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file thread_waits.cpp
/// The sampler with more threads than processors: threads sleep instead of tracing.
///
///     thread_waits PICTURE.layers.exr --threads N,N --seconds S
///
/// Pixels have white noise, of which each needs about as many samples as it took in the picture. S is the wall time of threads that never
/// wait. Each number of threads yields a JSON object with the share of time that they slept.

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "picture.h"
#include "tilt_lens/samples/sequence.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace
{

using namespace tilt_lens;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::uint32_t kTile = 32;  // pixels, as in POV-Ray
constexpr double kVariance = 1e-6;   // noise of up to 1000 samples stays between black and white
constexpr double kReserve = 0.85;    // so that the estimated variance seldom asks for one more round
constexpr double kSlept = 0.005;     // seconds at a time: starting a thread again takes some 0.0001

/// Sleeps now and then, for all samples since.
class SleepingTracer
{
  public:
    SleepingTracer(const witness::Picture& counts, double secondsOfSample) : counts(counts), secondsOfSample(secondsOfSample) {}

    void operator()(const SampleRun& run, SampleResult* results)
    {
        const double noise = std::sqrt(12.0 * kReserve * kVariance *
                                       counts.values[3 * (std::size_t(run.first.y) * counts.width + run.first.x)]);
        for (std::uint32_t i = 0; i < run.count; i++)
        {
            const double value = 0.5 + noise * (PixelHash(run.first.x, run.first.y, run[i].index, 0) * 0x1p-32 - 0.5);
            results[i] = Radiance{value, value, value, 0.0, 0.0};
        }
        owed += run.count * secondsOfSample;
        samples += run.count;
        if (owed >= kSlept)
            Sleep();
    }

    void Sleep()
    {
        const auto start = Clock::now();
        std::this_thread::sleep_for(Seconds(owed));
        slept += Seconds(Clock::now() - start).count();
        owed = 0.0;
    }

    double slept = 0.0;  ///< seconds
    std::uint64_t samples = 0;

  private:
    const witness::Picture& counts;
    const double secondsOfSample;
    double owed = 0.0;
};

nlohmann::json Run(const witness::Picture& counts, int threads, double seconds)
{
    const std::uint32_t width = counts.width, height = counts.height, across = (width + kTile - 1) / kTile;
    double expected = 0.0;
    for (std::size_t i = 0; i < counts.values.size(); i += 3)
        expected += counts.values[i];
    SamplingLimits limits;
    limits.min = Settings::firstSamples;
    limits.variance = kVariance;
    limits.denoise = true;
    limits.settings.forecasts = false;  // white noise would be filtered
    BlockCache cache(limits, width, height, {0, 0, width, height});
    std::atomic<std::uint32_t> next{0};
    std::vector<SleepingTracer> tracers(threads, SleepingTracer(counts, seconds * threads / expected));
    std::vector<std::thread> running;
    const auto start = Clock::now();
    for (SleepingTracer& tracer : tracers)
        running.emplace_back([&]
        {
            TileSampler sampler(cache);
            const Tracer trace([&tracer](const SampleRun& run, SampleResult* results) { tracer(run, results); });
            for (std::uint32_t tile; (tile = next++) < across * ((height + kTile - 1) / kTile);)
            {
                const std::uint32_t left = tile % across * kTile, top = tile / across * kTile;
                sampler.Run({left, top, std::min(kTile, width - left), std::min(kTile, height - top)}, trace);
            }
            tracer.Sleep();
        });
    for (std::thread& thread : running)
        thread.join();
    const double wall = Seconds(Clock::now() - start).count();
    double slept = 0.0, samples = 0.0;
    for (const SleepingTracer& tracer : tracers)
        slept += tracer.slept, samples += tracer.samples;
    return {
        {"threads", threads}, {"wall", wall}, {"busy", slept / (threads * wall)}, {"samples", samples}, {"samples_of_picture", expected}};
}

}  // namespace

int main(int count, char** values)
{
    CLI::App app("The sampler with threads that sleep instead of tracing");
    std::string path;
    std::vector<int> threads;
    double seconds = 20.0;
    app.add_option("layers", path)->required();
    app.add_option("--threads", threads)->delimiter(',')->required();
    app.add_option("--seconds", seconds);
    CLI11_PARSE(app, count, values);
    try
    {
        const witness::Picture counts = witness::ReadChannel(path, "samples");
        for (const int one : threads)
            std::cout << Run(counts, one, seconds) << std::endl;
    }
    catch (const std::exception& error)
    {
        std::cerr << "thread_waits: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
