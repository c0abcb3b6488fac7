// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

unsigned int GlassLens::Trace(const Four& lenses, FourGlassRays& rays, FourStopPoints& stop, bool rims)
{
    const GlassSurface* surfaces[4];
    for (int i = 0; i < 4; i++)
        surfaces[i] = lenses[i]->surfaces.data();
    const auto& opening = lenses[0]->opening;
    unsigned int passed = kernels->traceGlass(surfaces, lenses[0]->surfaces.size(), lenses[0]->StopScale(), rims, rays, stop);
    for (int i = 0; i < 4 && opening; i++)
        if ((passed >> i & 1u) != 0 && !opening({stop.a[i], stop.b[i]}))
            passed &= ~(1u << i);
    return passed;
}

} // namespace tilt_lens
