// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_colours.cpp
/// TiltLensTracer's part in colour fringes. A sample takes three rays, each with one wavelength of its third of the spectrum, for red,
/// green and blue. All three draw the same random numbers, so that a uniform grey surface has no noise of colour.

#include <algorithm>

#include "backend/frame.h"
#include "backend/render/tilt_lens_tracer.h"

#include "base/povdebug.h"

namespace pov
{

/// Random pair for the place within a third of the spectrum; area lights count from 0.
static const unsigned int kHuePair = 0x487565;

void TiltLensTracer::TraceColours(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result)
{
    const double within = pixel->PaddedPair(index, kHuePair).u;
    tilt_lens::Radiance mixed{};
    for (int colour = pRED; colour <= pBLUE; colour++)
    {
        tilt_lens::CameraRay ray = camera;
        const double hue = 1.0 - 2.0 / 3.0 * (colour + within);
        ray.FindColour(*view->camera, hue);
        refusedRays += ray.refused;
        TraceCameraRay(ray, result);
        mixed[colour] = result.radiance[colour];
        for (int c = pFILTER; c <= pTRANSM; c++)
            mixed[c] += result.radiance[c] / 3.0;
    }
    result.radiance = mixed;
    result.circle = tilt_lens::CircleOfConfusion();  // three circles of confusion, one per colour: the sample serves its own pixel alone
}

} // namespace pov
