// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_record.h
/// Exports cameras for programs that preview a scene, such as ./focus. If the environment variable `TILT_LENS_PREVIEW` names a file,
///
/// - every parsed camera statement and the picture's camera are written to it, as JSON, before the first pixel;
/// - the picture is a pinhole's: without apertures, POV-Ray's own focal blur and focus aids.
///
/// The JSON holds an array `cameras`, in the order of parsing, and `view`, the camera of the picture. Each has:
/// `file`, `line`, `offset`  end of the statement: name, line from 1, byte behind the closing brace
/// `perspective`             true if a lens is possible
/// `location`, `direction`, `right`, `up`, `sky`  world coordinates, scene units; without the block's shift
/// `focusDistance`           of POV-Ray's own focal blur, scene units
/// `aperture`                POV-Ray's number, twice the lens diameter, scene units; 0: none
/// `bokeh`, `normal`         true if the camera has the item
/// `matrix`, `inverse`       transformations in the statement, from its own coordinates to the world and back; four rows of four, for
///                           row vectors
/// `scale`                   linear scale of all transformations so far
/// `words`                   names of the block's items
/// `block`                   the `tilt_lens` block as a Statement (optics.h), or null; a focus given by a ray or by the film's distance
///                           is replaced by the resulting point or plane, and `fStop` is the number that `sharpWithin` has led to
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

/// Records a camera statement, if TILT_LENS_PREVIEW is set.
/// @param end  the closing brace of the statement
void RecordCamera(const Camera& camera, const TiltLensPlace& end);

/// If TILT_LENS_PREVIEW is set, writes the file and turns the camera into a pinhole.
/// @throws pov_base::Exception  the file cannot be written
void FinishCameraRecord(Camera& view, shared_ptr<SceneData> scene, double width);

} // namespace pov

#endif
