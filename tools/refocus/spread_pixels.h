// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file spread_pixels.h

#ifndef REFOCUS_SPREAD_PIXELS_H
#define REFOCUS_SPREAD_PIXELS_H

#include <vector>

#include "layers.h"

namespace refocus
{

/// Spreads pixels evenly over discs. A farther pixel covers a nearer one only as far as that is blurred, so that sharp edges stay.
/// @param diameters  pixels; up to 1 the pixel stays unchanged
/// @param depth      any unit, may be infinite
Picture Spread(const Picture& picture, const std::vector<float>& diameters, const std::vector<float>& depth);

} // namespace refocus

#endif
