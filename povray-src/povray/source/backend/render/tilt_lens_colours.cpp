// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_colours.cpp
/// TiltLensTracer's part in colour fringes. Each of a sample's three rays carries a third of the spectrum, at one of its
/// wavelengths, and gives the picture its colour. All three draw the same random numbers, so that an even grey surface gets
/// three equal numbers and no noise of colour.

#include <algorithm>

#include "backend/frame.h"
#include "backend/render/tilt_lens_tracer.h"

#include "base/povdebug.h"

namespace pov
{

/// Number of the pair that the place within a third of the spectrum is taken from; area lights count from 0.
static const unsigned int kHuePair = 0x487565;

void TiltLensTracer::TraceColours(const tilt_lens::CameraRay& camera, tilt_lens::SampleResult& result)
{
    const double within = pixel->PaddedPair(index, kHuePair).u;
    tilt_lens::Radiance mixed{};
    for (int colour = pRED; colour <= pBLUE; colour++)
    {
        tilt_lens::CameraRay ray = camera;
        const double hue = 1.0 - 2.0 / 3.0 * (colour + within);
        if (view->glass)
            ray.DrawColour(*view->glass, hue);
        else
            ray.FindRay(view->lens, hue);
        refusedRays += ray.refused;
        TraceCameraRay(ray, result);
        mixed[colour] = result.radiance[colour];
        for (int c = pFILTER; c <= pTRANSM; c++)
            mixed[c] += result.radiance[c] / 3.0;
    }
    result.radiance = mixed;
    result.circle = tilt_lens::CircleOfConfusion();  // the three colours have three circles: it serves its own pixel alone
}

} // namespace pov
