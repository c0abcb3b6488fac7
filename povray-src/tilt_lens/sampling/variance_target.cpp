// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/variance_target.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

double VarianceTarget::operator()(double relativeDeviation) const
{
    // written so that a pixel among those without any noise, 0/0, may keep as much as one among its like
    const double rare = settings.greatestTarget * std::sqrt(std::max(1.0, relativeDeviation / settings.rareDeviation));
    const double greatest =
        relativeDeviation > 1.0 ? std::min({relativeDeviation, rare, settings.greatestRareTarget}) : 1.0;
    const double alike = settings.leastTargetAmongLike;
    const double least = relativeDeviation < 1.0 ? std::max(settings.leastTarget, alike * relativeDeviation) : alike;
    return variance * std::clamp(proportional, least, greatest);
}

} // namespace tilt_lens
