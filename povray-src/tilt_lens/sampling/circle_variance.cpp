// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/circle_variance.h"

#include <cmath>

namespace tilt_lens
{

CircleVariance::CircleVariance(const PaddedSpread* spread, std::size_t at, double samples)
{
    const double others = spread != nullptr ? spread->SamplesAt(at) : 0.0;
    if (!(others > 0.0))
        return;
    total = spread->variance[at];
    double squaredMean = 0.0;
    for (const auto& plane : spread->mean)
        squaredMean += Square(plane[at]);
    if (!(squaredMean > 0.0) || !std::isfinite(squaredMean + total))
        return;
    // fraction of received samples that hit a light, if a single light against darkness explains both moments
    const double hits = squaredMean / (squaredMean + total), missed = std::exp(-hits * samples);
    weight = missed * others / (others + samples - 1.0);
    for (std::size_t c = 0; c < spread->mean.size(); c++)
        share[c] = Square(spread->mean[c][at]) / squaredMean;
}

Radiance CircleVariance::Blend(const Radiance& own) const
{
    Radiance blend;
    for (std::size_t c = 0; c < blend.size(); c++)
        blend[c] = own[c] + weight * (total * share[c] - own[c]);
    return blend;
}

} // namespace tilt_lens
