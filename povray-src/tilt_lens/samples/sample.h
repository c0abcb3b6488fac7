// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample.h
/// Interface between sampler and ray tracer.

#ifndef TILT_LENS_SAMPLE_H
#define TILT_LENS_SAMPLE_H

#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/reconstruction/spread.h"

namespace tilt_lens
{

struct SampleId
{
    std::uint32_t x, y;   ///< in the whole picture
    std::uint32_t index;  ///< 0, 1, ... in the order taken
};

struct SampleResult
{
    Radiance radiance;
    double expectedEmission = 0.0;  ///< emitter samples: mean radiance that the pixel's emitters add if nothing hides them; else 0
    CircleOfConfusion circle;       ///< of the hit, in the whole picture

    /// Hit of a sharp surface.
    SampleResult& operator=(const Radiance& value)
    {
        *this = SampleResult();
        radiance = value;
        return *this;
    }
};

/// Consecutive samples of one pixel in one group, computed together. Groups begin at multiples of cameraRaysOfBatch.
struct SampleRun
{
    SampleId first;
    std::uint32_t count;

    SampleId operator[](std::uint32_t i) const { return {first.x, first.y, first.index + i}; }
    /// The first sample's place in its group.
    std::uint32_t Place() const { return first.index % Settings::cameraRaysOfBatch; }
};

/// A run's places, extended to multiples of four for vector registers.
struct Quads
{
    explicit Quads(const SampleRun& run) : begin(run.Place() & ~3u), end((run.Place() + run.count + 3) & ~3u) {}

    static_assert(Settings::cameraRaysOfBatch % 4 == 0, "whole fours lie within a group");
    const std::uint32_t begin, end;

    int Count() const { return int(end - begin); }
};

class Tracer
{
  public:
    using OfRun = std::function<void(const SampleRun& samples, SampleResult* results)>;
    using OfOne = std::function<void(const SampleId& id, SampleResult& result)>;

    template<class Trace, std::enable_if_t<std::is_convertible_v<Trace, OfRun>, int> = 0>
    Tracer(Trace traceRun) : run(std::move(traceRun))
    {
    }

    /// Wraps a function that traces one sample at a time.
    template<class Trace, std::enable_if_t<std::is_convertible_v<Trace, OfOne>, long> = 0>
    Tracer(Trace traceOne) :
        run([trace = std::move(traceOne)](const SampleRun& samples, SampleResult* results)
    {
        for (std::uint32_t i = 0; i < samples.count; i++)
            trace(samples[i], results[i]);
    })
    {
    }

    /// @param results  one per sample; need not be initialised
    void Trace(const SampleRun& samples, SampleResult* results) const { run(samples, results); }

  private:
    OfRun run;
};

} // namespace tilt_lens

#endif
