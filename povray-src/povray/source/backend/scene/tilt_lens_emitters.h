// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_emitters.h
/// Bright objects, for emitter sampling.

#ifndef POVRAY_BACKEND_TILT_LENS_EMITTERS_H
#define POVRAY_BACKEND_TILT_LENS_EMITTERS_H

#include <vector>

#include "backend/frame.h"
#include "tilt_lens/samples/emitter_sampling.h"

namespace pov
{

class Camera;
class SceneData;

/// Finite objects that outshine their surroundings by their own finish, and their images in flat mirrors, relative to the camera's
/// location. Errors of brightness only change the number of samples.
std::vector<tilt_lens::Emitter> EmittersOf(const SceneData& scene, const Camera& camera);

}  // namespace pov

#endif
