// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file inner_loops.cpp
/// Nanoseconds a call of camera and sampler.

#include <cmath>
#include <cstdint>

#include <benchmark/benchmark.h>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/samples/sequence.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace
{

using namespace tilt_lens;

Lens SomeLens()
{
    Lens lens;
    lens.direction = {0.0, -0.1, 1.2};
    lens.right = {1.33, 0.0, 0.0};
    lens.up = {0.0, 1.0, 0.08};
    lens.lensX = {0.1, 0.0, 0.0};
    lens.lensY = {0.0, 0.099, 0.01};
    lens.focus = {0.0, -0.1, 0.2};
    return lens;
}

/// Unforeseeable by compilers.
struct Places
{
    std::uint32_t state = 1;
    double Next()
    {
        state = state * 1664525u + 1013904223u;
        return state * 0x1p-32;
    }
};

/// The empty loop's time, which is subtracted.
void Empty(benchmark::State& state)
{
    Places places;
    for (auto _ : state)
    {
        benchmark::DoNotOptimize(places.Next());
        benchmark::DoNotOptimize(places.Next());
    }
}
BENCHMARK(Empty);

void Ray(benchmark::State& state)
{
    const Lens lens = SomeLens();
    Places places;
    for (auto _ : state)
    {
        const double x = places.Next() - 0.5, a = places.Next();
        benchmark::DoNotOptimize(MakeRay(lens, x, -x, a, -a));
    }
}
BENCHMARK(Ray);

void SamplePoint(benchmark::State& state)
{
    const PixelSampler sampler(17, 4, 0);
    std::uint32_t index = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(sampler(index++));
}
BENCHMARK(SamplePoint);

void NewPixel(benchmark::State& state)
{
    std::uint32_t x = 0;
    for (auto _ : state)
        benchmark::DoNotOptimize(PixelSampler(x++, 4, 0));
}
BENCHMARK(NewPixel);

void Map(benchmark::State& state, const Aperture& aperture)
{
    Places places;
    for (auto _ : state)
    {
        const double u = places.Next(), v = places.Next();
        benchmark::DoNotOptimize(aperture(u, v));
    }
}
BENCHMARK_CAPTURE(Map, disc, Aperture::Disc());
BENCHMARK_CAPTURE(Map, polygon, Aperture::Polygon(7, 0.2));
BENCHMARK_CAPTURE(Map, picture, Aperture::Picture([](double u, double v) { return u + v * v; }));

void TilePerSample(benchmark::State& state)
{
    SamplingLimits limits;
    limits.min = 8;
    limits.max = static_cast<std::uint32_t>(state.range(0));
    limits.variance = 1e-12;    // never reached: every pixel takes the most
    limits.denoise = state.range(1) != 0;
    const std::uint32_t edge = 32;
    for (auto _ : state)
    {
        BlockCache store(limits, edge, edge, {0, 0, edge, edge});
        TileSampler tile(store);
        tile.Run({0, 0, edge, edge}, [](const SampleId& id, SampleResult& traced)
        {
            const double light = id.index * 0x9e3779b9u > 0x7fffffffu ? 1.0 : 0.1 * (id.x & 3);
            traced = Radiance{light, light, 0.5 * light, 0.0, 0.0};
        });
        benchmark::DoNotOptimize(tile.Mean(3, 3));
    }
    state.counters["per_sample"] = benchmark::Counter(double(state.iterations()) * edge * edge * limits.max,
                                                      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(TilePerSample)
    ->ArgNames({"samples", "denoise"})
    ->Args({64, 0})
    ->Args({64, 1})
    ->Args({1024, 0})
    ->Args({1024, 1})
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
