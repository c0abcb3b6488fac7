// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/undetected_error.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

double MissedSquareError(double share, double n)
{
    const double x = share * n;
    if (x < 1e-2)  // the formula below would lose all digits
        return share * share / 3.0;
    return (2.0 - (2.0 + x * (2.0 + x)) * std::exp(-x)) / (x * n * n);
}

Radiance UndetectedError(const PixelStatistics& own, const SampleVariation& around)
{
    Radiance error{};
    for (std::size_t c = 0; c < error.size(); c++)
    {
        const double excess = around.variance[c] - own.Variation().variance[c];
        if (!(excess > 0.0))
            continue;
        const double deviation = std::max(excess, around.maxSquaredDeviation[c]);
        error[c] = deviation * MissedSquareError(excess / deviation, own.Samples());
    }
    return error;
}

bool HasSearchedEmitters(const PixelStatistics& own, double target)
{
    const std::uint32_t missed = own.EmitterSamples();
    return missed == 0 || missed >= settings.hiddenEmitterSamples ||
           std::min(1.0, Square(own.ExpectedEmission())) * MissedSquareError(1.0, missed) <= target;
}

} // namespace tilt_lens
