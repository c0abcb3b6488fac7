// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file forget_rays.cpp
/// Clears the caches that a thread keeps from ray to ray, where they may change the next ray's result. Pixels of pictures with `tilt_lens`
/// depend on the scene alone, so each of their camera rays starts without these caches. Random numbers are seeded by the sample instead.

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
    // the last object in a light's way is tested first, with tolerances of its own
    if (shadowCacheUsed)
    {
        std::fill(lightSourceLevel1ShadowCache.begin(), lightSourceLevel1ShadowCache.end(), ObjectPtr(NULL));
        std::fill(lightSourceOtherShadowCache.begin(), lightSourceOtherShadowCache.end(), ObjectPtr(NULL));
        shadowCacheUsed = false;
    }
    // a ray beside one that missed an isosurface is assumed to miss it, which holds only if max_gradient does
    threadData->isosurfaceData->cache = false;
    // points of the last cell of `facets` are recognised by a hash alone
    threadData->Facets_Last_Seed = int(0x80000000);
}

/// The photons of a light and a target do not depend on the thread that shoots them.
void Trace::BeginPhotons()
{
    ForgetRays();
    crandRandomNumberGenerator = 0;
    randomNumberGenerator.SetSeed(0);
    if (RandomDoubleSequence::Generator* const ofMedia = media.RandomNumbers())
        ofMedia->SetSeed(0);
}

} // namespace pov
