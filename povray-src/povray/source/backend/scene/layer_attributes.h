// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layer_attributes.h
/// A camera's numbers as attributes of OpenEXR files.

#ifndef POVRAY_BACKEND_LAYER_ATTRIBUTES_H
#define POVRAY_BACKEND_LAYER_ATTRIBUTES_H

#include <string>
#include <vector>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "tilt_lens/math/vec3.h"

namespace pov
{

struct LayerAttribute
{
    std::string name;
    std::vector<double> values;  ///< 1, 2, 3 or 16 numbers (matrix row by row, for row vectors)
};

/// False: depth is the ray's length.
bool HasDepthAxis(const Camera& camera);

/// Film's unit normal, into the scene.
tilt_lens::Vec3 DepthAxis(const Camera& camera);

/// Empty for cameras that are not perspective.
/// @param camera  as rendered
/// @param width   whole picture, pixels
std::vector<LayerAttribute> LayerAttributesOf(const Camera& camera, unsigned int width);

} // namespace pov

#endif
