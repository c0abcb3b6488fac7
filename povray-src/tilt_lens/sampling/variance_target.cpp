// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/variance_target.h"

#include <algorithm>

namespace tilt_lens
{

double VarianceTarget::operator()(double relativeDeviation) const
{
    // NaN (0/0, a pixel among pixels without noise) counts as 1
    const double greatest = relativeDeviation > 1.0 ? std::min(relativeDeviation, settings.greatestTarget) : 1.0;
    return variance * std::clamp(proportional, settings.leastTarget, greatest);
}

} // namespace tilt_lens
