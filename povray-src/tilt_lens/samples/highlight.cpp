// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/highlight.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

std::optional<Emitter> HighlightOf(const GlossySphere& sphere, const Vec3& light, double lensDiameter)
{
    if (!(Length(sphere.centre) > sphere.radius && Length(light - sphere.centre) > sphere.radius && sphere.exponent > 0.0))
        return std::nullopt;
    Vec3 brightest = sphere.centre;
    for (int i = 0; i <= Settings::highlightIterations; i++)
    {
        const Vec3 bisector = Normalized(light - brightest) - Normalized(brightest);
        if (!(Length(bisector) > 0.0))
            return std::nullopt;
        brightest = sphere.centre + sphere.radius * Normalized(bisector);
    }
    // within this angle cos^n is nearly exp(-n angle^2 / 2): a share 1 - exp(-2) of the light, with this mean
    const double angle = 2.0 / std::sqrt(sphere.exponent), mean = 0.5 * (1.0 - std::exp(-2.0));
    const double moved = 0.25 * lensDiameter / Length(brightest);  // turn of the bisector between the lens's centre and rim
    return Emitter{brightest, sphere.radius * std::min(1.0, angle + moved), sphere.around + mean * sphere.peak, sphere.around};
}

}  // namespace tilt_lens
