// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file focus_target.h
/// Finds by rays what `focus_on` and `focus_at` put into focus, as an autofocus does.

#ifndef POVRAY_BACKEND_FOCUS_TARGET_H
#define POVRAY_BACKEND_FOCUS_TARGET_H

#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/camera.h"

namespace pov
{

class SceneData;

/// Puts the points, and the blur that is given in pixels, into the camera's statement and solves its lens; does nothing where
/// nothing is missing there.
///
/// - An object: where the ray from the lens centre to the middle of the object's bounding box first meets it, whatever else
///   is in the way; where that ray misses it, the next of 1024 rays around that one, by growing angle.
/// - A place in the picture: where its chief ray first meets a surface that is visible to the camera, transparent or not.
///   Where focusing changes the angle of view (`focal_length`), the two are brought into agreement step by step.
///
/// @param scene  parsed completely
/// @param width  of the whole picture, pixels
/// @throws tilt_lens::OpticsError  a ray meets nothing, an object has no end, or no lens can follow
/// @return what to warn of
std::vector<std::string> FindFocus(Camera& camera, shared_ptr<SceneData> scene, double width);

} // namespace pov

#endif
