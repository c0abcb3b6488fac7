// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 9(a): a landscape, the ordinary lens.
//
//   ./render scenes/paper/landscape_a.pov +W960 +H720
//
// Look for: the village green sharp, the church's spire and the balloon above it not: the plane of focus leans
//          away from the camera, as the film does.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "landscape_objects.inc"

camera
{
  Landscape_Camera(16)
  focal_point Village_Green
  tilt_lens { denoise Denoise }
}
