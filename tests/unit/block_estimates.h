// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_TESTS_BLOCK_ESTIMATES_H
#define TILT_LENS_TESTS_BLOCK_ESTIMATES_H

#include <cstdint>

#include "picture_edges.h"
#include "tile_results.h"
#include "tilt_lens/stop_rule/block_estimate.h"

namespace tilt_lens
{

inline void TakeRound(BlockEstimate& estimate, std::uint32_t until, const Tracer& trace)
{
    const Area& area = estimate.area;
    for (std::uint32_t y = area.top; y < area.Bottom(); y++)
        for (std::uint32_t x = area.left; x < area.Right(); x++)
        {
            PixelEstimate& pixel = estimate.pixels[area.IndexOf(x, y)];
            if (!pixel.active)
                continue;
            pixel.statistics.BeginRound(until);
            while (pixel.statistics.Samples() < until)
            {
                SampleResult result;
                TraceOne(trace, {x, y, pixel.statistics.Samples()}, result);
                pixel.statistics.Add(result);
            }
        }
}

inline BlockEstimate FirstEstimate(const Area& area, std::uint32_t samples, const Tracer& trace)
{
    BlockEstimate estimate(area, kFarEdges, Settings());
    TakeRound(estimate, samples, trace);
    return estimate;
}

inline FirstRounds Alone(const FirstRound& round)
{
    FirstRounds rounds{};
    rounds[4] = &round;
    return rounds;
}

constexpr Area kMiddle{Settings::blockSide, Settings::blockSide, Settings::blockSide, Settings::blockSide};

} // namespace tilt_lens

#endif
