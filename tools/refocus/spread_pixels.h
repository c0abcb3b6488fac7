// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file spread_pixels.h
/// Blurs each pixel by a disc of its own.

#ifndef REFOCUS_SPREAD_PIXELS_H
#define REFOCUS_SPREAD_PIXELS_H

#include <vector>

#include "layers.h"

namespace refocus
{

/// Spreads each pixel's value evenly over a disc. A farther pixel covers a nearer one only as far as that is blurred itself, so that a
/// sharp object keeps its edge before a blurred background.
/// @param diameters  of the discs, pixels; up to 1 the pixel stays unchanged
/// @param depth      decides which of two pixels is nearer; any unit, may be infinite
Picture Spread(const Picture& picture, const std::vector<float>& diameters, const std::vector<float>& depth);

} // namespace refocus

#endif
