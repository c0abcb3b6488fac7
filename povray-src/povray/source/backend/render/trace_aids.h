// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file trace_aids.h
/// Focus aids: one ray per pixel, through the lens centre.

#ifndef POVRAY_BACKEND_TRACE_AIDS_H
#define POVRAY_BACKEND_TRACE_AIDS_H

#include <vector>

#include "backend/frame.h"
#include "backend/colour/colour.h"

namespace pov
{

class TracePixel;
class ViewData;

/// @param x, y  pixel; between pixels in a radiosity pretrace
Colour AidPixel(TracePixel& trace, DBL x, DBL y, DBL width, DBL height);

/// Appends row by row.
void TraceAidTile(TracePixel& trace, const ViewData& view, const POVRect& rect, std::vector<Colour>& pixels);

} // namespace pov

#endif
