// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Figs. 5 and 6, state (c): reverse tilt; the plane of sharp focus is upright and passes through the
// box's perpendicular edge nearest to the camera.
//
//   ./render scenes/paper/box_c.pov +W720 +H480
//
// Look for: that edge sharp from top to bottom, and the board's squares at its foot; top and sides blur
// with their distance behind it.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "box_camera.inc"

camera
{
  Box_Camera()
  tilt_lens
  {
    scene_unit Scene_Unit
    focal_length Focal_Length
    f_stop F_Stop
    focal_plane { z, Edge_Top.z }    // the lens leans back by about 3.5 degrees
  }
}

#include "box_objects.inc"
