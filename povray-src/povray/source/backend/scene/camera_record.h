// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_record.h
/// For programs that show a scene before its lens is chosen, such as ./focus. Where the environment variable
/// `TILT_LENS_PREVIEW` names a file,
///
/// - every camera statement that is parsed and the camera that the picture is taken with are written to it,
///   as JSON, before the first pixel;
/// - the picture is that of a pinhole: apertures, POV-Ray's own focal blur and focus aids are left out.
///
/// The JSON holds an array `cameras`, in the order of parsing, and `view`, the camera of the picture, each with:
/// `file`, `line`, `offset`  where the statement ends: name, line from 1, byte behind its closing brace
/// `perspective`             whether a lens is possible
/// `location`, `direction`, `right`, `up`, `sky`  world coordinates, scene units; without the block's shift
/// `focusDistance`           of POV-Ray's own focal blur, scene units
/// `aperture`                POV-Ray's number, twice the lens diameter, scene units; 0: none
/// `bokeh`, `normal`         whether the camera has these items
/// `matrix`, `inverse`       the transformations in the statement: from the coordinates in which its items are written to
///                           those of the world, and back; four rows of four, a point is the row in front of it
/// `scale`                   by which all transformations so far make the camera larger
/// `words`                   names of the items that the block has
/// `block`                   the `tilt_lens` block as a Statement (optics.h), or null; where a ray or the film's distance
///                           sets the focus, with the point or plane that this makes
/// and `gamma` of the scene: how values of the picture become light: `sRGB`, a number (power), or null where
/// they are shown as they are.

#ifndef POVRAY_BACKEND_CAMERA_RECORD_H
#define POVRAY_BACKEND_CAMERA_RECORD_H

#include <string>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "backend/scene/tilt_lens_camera.h"

namespace pov
{

class SceneData;

/// Whether TILT_LENS_PREVIEW is set.
bool CamerasAreRecorded();

/// Notes a camera statement; does nothing where none is recorded.
/// @param end  the closing brace of the statement
void RecordCamera(const Camera& camera, const TiltLensPlace& end);

/// Writes the file, and makes a pinhole of the camera; does nothing where none is recorded.
/// @throws pov_base::Exception  the file cannot be written
void FinishCameraRecord(Camera& view, shared_ptr<SceneData> scene, double width);

} // namespace pov

#endif
