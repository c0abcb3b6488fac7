// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Figs. 5 and 6, state (b): the plane of sharp focus parallel to the floor, through the top of the box.
//
//   ./render scenes/paper/box_b.pov +W720 +H480
//
// Look for: the whole top sharp from front to back; the sides blur downward, and the floor is blurred everywhere.

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
    focal_plane { y, 8 }             // the lens leans forward by about 10 degrees
  }
}

#include "box_objects.inc"
