// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/lighting/area_light_sampler.h"

#include "backend/frame.h"
#include "backend/lighting/point.h"

#include "base/povdebug.h"

namespace pov
{

/// POV-Ray bisects the row recursively; both halves of an odd row hold its middle, which weighs more.
static int PointOfRow(int points, double x)
{
    int first = 0, last = points - 1;
    while (first < last)
    {
        const int sum = first + last;
        const bool upper = x >= 0.5;
        x = 2.0 * x - (upper ? 1.0 : 0.0);
        (upper ? first : last) = upper ? (sum + 1) / 2 : sum / 2;
    }
    return first;
}

bool AreaLightSampler::ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v)
{
    if (radiosityDepth > 0)
        return false;
    const tilt_lens::Pair point = pixel->PaddedPair(index, lightsMet++);
    skipped += std::uint64_t(light.Area_Size1) * light.Area_Size2 - 1;
    sampled++;
    u = PointOfRow(light.Area_Size1, point.u);
    v = PointOfRow(light.Area_Size2, point.v);
    return true;
}

} // namespace pov
