// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_TESTS_TILE_RESULTS_H
#define TILT_LENS_TESTS_TILE_RESULTS_H

#include <cstdint>
#include <vector>

#include "tilt_lens/samples/sequence.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

namespace tilt_lens
{

inline Radiance Grey(double value)
{
    return {value, value, value, 0.0, 0.0};
}

inline double Noise(const SampleId& id, std::uint32_t salt)
{
    return (PixelHash(id.x, id.y, id.index, salt) + 0.5) * 0x1p-32;
}

inline SequencePoint SequencePointOf(const SampleId& id)
{
    return PixelSampler(id.x, id.y, 0)(id.index);
}

inline void TraceOne(const Tracer& trace, const SampleId& id, SampleResult& light)
{
    trace.Trace({id, 1}, &light);
}

inline void Constant(const SampleId&, SampleResult& light)
{
    light = Grey(0.7);
}

/// Noise of variance 1/12, unaffected by stratification.
inline void WhiteNoise(const SampleId& id, SampleResult& light)
{
    light = Grey(Noise(id, 1));
}

inline void Edge(const SampleId& id, SampleResult& light)
{
    const SequencePoint s = SequencePointOf(id);
    light = Grey(0.3 * (id.x + s.pixelX) + (id.y + s.pixelY) > 20.0 ? 1.0 : 0.0);
}

struct Result
{
    Radiance mean;
    std::uint32_t samples;
    double variance;

    bool operator==(const Result& b) const { return mean == b.mean && samples == b.samples && variance == b.variance; }
};

inline std::vector<Result> ResultsOf(TileSampler& sampler, const Area& tile, const Tracer& trace)
{
    sampler.Run(tile, trace);
    std::vector<Result> results;
    for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
        for (std::uint32_t x = tile.left; x < tile.Right(); x++)
            results.push_back({sampler.Mean(x, y), sampler.Samples(x, y), sampler.Variance(x, y)});
    return results;
}

inline std::vector<Result> ResultsOf(const SamplingLimits& limits, const Area& tile, std::uint32_t width, std::uint32_t height,
                                     const Tracer& trace)
{
    BlockCache store(limits, width, height, tile);
    TileSampler sampler(store);
    return ResultsOf(sampler, tile, trace);
}

inline std::vector<Result> ResultsOf(const SamplingLimits& limits, std::uint32_t left, std::uint32_t top, const Tracer& trace)
{
    return ResultsOf(limits, {left, top, Settings::blockSide, Settings::blockSide}, 4096, 4096, trace);
}

inline SamplingLimits Limits(std::uint32_t min, std::uint32_t max, double variance, double confidence = 0.9)
{
    SamplingLimits limits;
    limits.min = min;
    limits.max = max;
    limits.variance = variance;
    limits.confidence = confidence;
    return limits;
}

} // namespace tilt_lens

#endif
