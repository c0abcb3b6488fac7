// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file objects_around_lens.h
/// The objects whose interior rays from the lens start in.

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
    bool holdsLens;  ///< all of it; else each ray has to ask
};

/// Every object with an interior that some of the lens may lie in, in the order of the scene.
std::vector<ObjectAroundLens> ObjectsAroundLens(const Camera& camera, const tilt_lens::Lens& lens, const SceneData& scene);

} // namespace pov

#endif
