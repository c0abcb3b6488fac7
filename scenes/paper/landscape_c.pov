// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The seed paper's Fig. 9(c): a landscape, reverse tilt: the plane of sharp focus perpendicular to the ground.
//
//   ./render scenes/paper/landscape_c.pov +W960 +H540
//
// Look for: one street across the village sharp from doorstep to spire, and the look of a model.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "landscape_objects.inc"

camera
{
  Landscape_Camera()
  aperture 4

  tilt_lens { focal_plane { z, Village_Green.z } }
}
