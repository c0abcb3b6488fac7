// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_UNLISTED_LAMPS_H
#define POVRAY_BACKEND_UNLISTED_LAMPS_H

#include <vector>

#include "backend/frame.h"
#include "tilt_lens/samples/emitter_sampling.h"

namespace pov
{

class SceneData;

/// True if something brighter than `Settings::searchRadiance` may be seen where no list of objects tells: by a pattern's colours or a
/// sky's, or one of the emitters through refracting objects.
bool MayShowUnlistedLamps(const SceneData& scene, const std::vector<tilt_lens::Emitter>& emitters);

} // namespace pov

#endif
