// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample.h
/// What the sampler asks of a tracer for some samples of a pixel, and what it gets.

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

/// Identifies one sample of one pixel.
struct SampleId
{
    std::uint32_t x, y;   ///< pixel in the whole picture
    std::uint32_t index;  ///< 0, 1, ... in the order taken
};

/// What the ray of one sample has found.
struct SampleResult
{
    Radiance radiance;
    double expectedEmission = 0.0;  ///< of an emitter-sampled sample: what its emitters bring the pixel if nothing hides
                                    ///< them (emitter_sampling.h); 0 for any other sample
    CircleOfConfusion circle;       ///< of the surface that was hit, in the whole picture

    /// A sharp surface of this radiance.
    SampleResult& operator=(const Radiance& value)
    {
        *this = SampleResult();
        radiance = value;
        return *this;
    }
};

/// Samples of one pixel that follow each other. They are of one group of cameraRaysOfBatch: these begin with the numbers that
/// this divides, so that their points of the sequence are made together.
struct SampleRun
{
    SampleId first;
    std::uint32_t count;

    SampleId operator[](std::uint32_t i) const { return {first.x, first.y, first.index + i}; }
    /// Of its first sample, in the group.
    std::uint32_t Place() const { return first.index % settings.cameraRaysOfBatch; }
};

/// The places in their group of the samples of a run, rounded to whole fours: what vector registers compute together.
struct Quads
{
    explicit Quads(const SampleRun& run) : begin(run.Place() & ~3u), end((run.Place() + run.count + 3) & ~3u) {}

    static_assert(settings.cameraRaysOfBatch % 4 == 0, "whole fours lie within a group");
    const std::uint32_t begin, end;

    int Count() const { return int(end - begin); }
};

/// Traces samples: each that which PixelSampler(id.x, id.y, seed) gives for its number.
class Tracer
{
  public:
    using OfRun = std::function<void(const SampleRun& samples, SampleResult* results)>;
    using OfOne = std::function<void(const SampleId& id, SampleResult& result)>;

    template<class Trace, std::enable_if_t<std::is_convertible_v<Trace, OfRun>, int> = 0>
    Tracer(Trace traceRun) : run(std::move(traceRun)) {}

    /// Of what traces one at a time.
    template<class Trace, std::enable_if_t<std::is_convertible_v<Trace, OfOne>, long> = 0>
    Tracer(Trace traceOne) :
        run([trace = std::move(traceOne)](const SampleRun& samples, SampleResult* results)
        {
            for (std::uint32_t i = 0; i < samples.count; i++)
                trace(samples[i], results[i]);
        })
    {
    }

    /// @param results  takes one for each sample, in any state before
    void Trace(const SampleRun& samples, SampleResult* results) const { run(samples, results); }

  private:
    OfRun run;
};

} // namespace tilt_lens

#endif
