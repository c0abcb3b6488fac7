// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_OBJECTS_AROUND_LENS_H
#define POVRAY_BACKEND_OBJECTS_AROUND_LENS_H

#include <vector>

#include "backend/frame.h"
#include "tilt_lens/camera/optics.h"

namespace pov
{

class Camera;
class SceneData;

struct ObjectAroundLens
{
    ObjectPtr object;
    bool holdsLens;  ///< holds all of it; else test each ray
};

/// Objects with interior around a part of the lens, in the scene's order.
std::vector<ObjectAroundLens> ObjectsAroundLens(const Camera& camera, const tilt_lens::SolvedLens& lens, const SceneData& scene);

} // namespace pov

#endif
