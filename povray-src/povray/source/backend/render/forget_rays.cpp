// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file forget_rays.cpp
/// Clears caches that may change the next ray's result: pixels with `tilt_lens` depend on the scene alone.

#include <algorithm>

#include "backend/frame.h"
#include "backend/render/trace.h"
#include "backend/scene/threaddata.h"
#include "backend/shape/isosurf.h"

#include "base/povdebug.h"

namespace pov
{

void Trace::ForgetRays()
{
    // the last object in a light's way is tested first, with its own tolerances
    if (shadowCacheUsed)
    {
        std::fill(lightSourceLevel1ShadowCache.begin(), lightSourceLevel1ShadowCache.end(), ObjectPtr(NULL));
        std::fill(lightSourceOtherShadowCache.begin(), lightSourceOtherShadowCache.end(), ObjectPtr(NULL));
        shadowCacheUsed = false;
    }
    // a ray beside one that missed an isosurface is assumed to miss it
    threadData->isosurfaceData->cache = false;
    // `facets` recognises points of the last cell by a hash alone
    threadData->Facets_Last_Seed = int(0x80000000);
}

void Trace::BeginPhotons()
{
    ForgetRays();
    crandRandomNumberGenerator = 0;
    randomNumberGenerator.SetSeed(0);
    if (RandomDoubleSequence::Generator* const ofMedia = media.RandomNumbers())
        ofMedia->SetSeed(0);
}

} // namespace pov
