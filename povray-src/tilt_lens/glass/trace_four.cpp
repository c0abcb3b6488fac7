// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

unsigned int GlassLens::Trace(FourGlassRays& rays, FourStopPoints& stop, bool rims) const
{
    const GlassSurface* const first = surfaces.data();
    unsigned int passed = kernels->traceGlass(first, first + surfaces.size(), StopScale(), rims, rays, stop);
    for (int i = 0; i < 4 && opening; i++)
        if ((passed >> i & 1u) != 0 && !opening({stop.a[i], stop.b[i]}))
            passed &= ~(1u << i);
    return passed;
}

} // namespace tilt_lens
