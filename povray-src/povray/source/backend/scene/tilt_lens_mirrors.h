// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_TILT_LENS_MIRRORS_H
#define POVRAY_BACKEND_TILT_LENS_MIRRORS_H

#include <vector>

#include "backend/frame.h"
#include "tilt_lens/samples/flat_mirror.h"

namespace pov
{

/// Adds planes and boxes' faces that reflect without `normal`, relative to the location.
void AddFlatMirrors(ObjectPtr object, const tilt_lens::Vec3& location, std::vector<tilt_lens::FlatMirror>& mirrors);

} // namespace pov

#endif
