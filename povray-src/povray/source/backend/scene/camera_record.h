// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_record.h
/// Exports cameras for previews, such as ./focus. If the environment variable `TILT_LENS_PREVIEW` names a file, it gets all cameras as JSON
/// before the first pixel, and the picture is a pinhole's, without focus aids.
///
/// JSON: array `cameras`, in the order of parsing, and `view`, the picture's camera, each with:
///
///     `file`, `line`, `offset`  end of the statement: name, line from 1, byte behind the closing brace;
///     `perspective`             true if a lens is possible;
///     `location`, `direction`, `right`, `up`, `sky`  world coordinates, scene units; without the block's shift;
///     `focusDistance`           POV-Ray's focal blur, scene units;
///     `aperture`                twice the lens diameter, scene units; 0: none;
///     `bokeh`, `normal`         true if the camera has the item;
///     `matrix`, `inverse`       transformations in the statement, to the world and back; four rows of four, for row vectors;
///     `scale`                   linear scale of all transformations so far;
///     `words`                   names of the block's items;
///     `block`                   Statement (optics.h) or null; a focus given by a ray or the film's distance becomes the resulting point
///                               or plane, `fStop` the number found for `sharpWithin`.
///
/// `gamma` of the scene is the transfer curve from pixel values to light: `sRGB`, a number (power), or null for none.

#ifndef POVRAY_BACKEND_CAMERA_RECORD_H
#define POVRAY_BACKEND_CAMERA_RECORD_H

#include <string>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "backend/scene/tilt_lens_camera.h"

namespace pov
{

class SceneData;

bool CamerasAreRecorded();

/// @param end  closing brace
void RecordCamera(const Camera& camera, const TiltLensPlace& end);

/// Writes the file and turns the camera into a pinhole.
/// @throws pov_base::Exception  unwritable file
void FinishCameraRecord(Camera& view, shared_ptr<SceneData> scene, double width);

}  // namespace pov

#endif
