// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_SEND_LAYERS_H
#define POVRAY_BACKEND_SEND_LAYERS_H

#include <vector>

#include "backend/frame.h"
#include "base/povmscpp.h"

namespace pov
{

class TracePixel;
class ViewData;

struct TiltLensEffort
{
    unsigned int samples;
    double variance;  ///< see TileSampler::Variance()
};

void StartLayers(ViewData& view, POVMS_Object& options);

/// Call before the tile's colours are sent.
/// @param effort  row by row; empty if not sampled
void SendLayers(TracePixel& trace, ViewData& view, const POVRect& rect, const std::vector<TiltLensEffort>& effort = {});

} // namespace pov

#endif
