// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 9(b): a landscape, the plane of sharp focus on the ground.
//
//   ./render scenes/paper/landscape_b.pov +W960 +H720
//
// Look for: all of the ground sharp, from the first field to the foot of the hills; the higher a thing
//          rises above it, the more it blurs: spire, keep, balloon.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "landscape_objects.inc"

camera
{
  Landscape_Camera(16)
  tilt_lens { focal_plane { y, 0 } denoise Denoise }
}
