// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file forget_rays.cpp
/// What a thread keeps from one ray for the next, to be faster, and where the next ray may get another answer by it.
/// Pictures with `tilt_lens` promise pixels that depend on nothing but the scene, so each of their camera rays begins
/// with all of it forgotten. Random numbers are not among it: a sample seeds them.

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
    // the object that was in a light's way last time is asked first, with other tolerances than all the others
    if (shadowCacheUsed)
    {
        std::fill(lightSourceLevel1ShadowCache.begin(), lightSourceLevel1ShadowCache.end(), ObjectPtr(NULL));
        std::fill(lightSourceOtherShadowCache.begin(), lightSourceOtherShadowCache.end(), ObjectPtr(NULL));
        shadowCacheUsed = false;
    }
    // a ray beside one that missed an isosurface is taken to miss it, too, which is true if max_gradient is
    threadData->isosurfaceData->cache = false;
    // points of the cell that `facets` was asked for last are told from those of other cells by a hash only
    threadData->Facets_Last_Seed = int(0x80000000);
}

/// Whatever thread shoots the photons of a light at a target, it shoots the same ones.
void Trace::BeginPhotons()
{
    ForgetRays();
    crandRandomNumberGenerator = 0;
    randomNumberGenerator.SetSeed(0);
    if (RandomDoubleSequence::Generator* const ofMedia = media.RandomNumbers())
        ofMedia->SetSeed(0);
}

} // namespace pov
