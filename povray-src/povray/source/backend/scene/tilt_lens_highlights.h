// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_TILT_LENS_HIGHLIGHTS_H
#define POVRAY_BACKEND_TILT_LENS_HIGHLIGHTS_H

#include <vector>

#include "backend/frame.h"
#include "tilt_lens/samples/highlight.h"

namespace pov
{

class Camera;
class SceneData;

/// Adds highlights of all light sources, for spheres only.
/// @param around  possible radiance around them
void AddHighlights(ObjectPtr object, const SceneData& scene, const Camera& camera, double around,
                   std::vector<tilt_lens::Emitter>& emitters);

} // namespace pov

#endif
