// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file spread.h
/// Blurs each pixel by a disc of its own.

#ifndef REFOCUS_SPREAD_H
#define REFOCUS_SPREAD_H

#include <vector>

#include "layers.h"

namespace refocus
{

/// Each pixel's value is spread evenly over a disc. What lies behind a pixel covers it only as far as that pixel is blurred
/// itself, so that a sharp object keeps its edge before a blurred background.
/// @param diameters  of the discs, pixels; up to 1 a pixel stays as it is
/// @param depth      which of two pixels lies behind; any unit, may be infinite
Picture Spread(const Picture& picture, const std::vector<float>& diameters, const std::vector<float>& depth);

} // namespace refocus

#endif
