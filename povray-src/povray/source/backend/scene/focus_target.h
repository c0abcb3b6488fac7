// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file focus_target.h
/// Autofocus by rays.

#ifndef POVRAY_BACKEND_FOCUS_TARGET_H
#define POVRAY_BACKEND_FOCUS_TARGET_H

#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/camera.h"

namespace pov
{

class SceneData;

/// Completes the camera's statement and solves its lens; returns warnings.
///
/// - Object: first hit towards its bounding box's centre, even behind other objects; else the next of 1024 rays around it.
/// - Place in the picture: first hit of its chief ray, transparent or not. Iterated if focusing changes the angle of view.
///
/// @param scene  completely parsed
/// @param width  whole picture, pixels
/// @throws tilt_lens::OpticsError  a ray hits no object, an object is infinite, or no lens fits
std::vector<std::string> FindFocus(Camera& camera, shared_ptr<SceneData> scene, double width);

} // namespace pov

#endif
