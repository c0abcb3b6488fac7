// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Figs. 5 and 6, state (a): the plane of sharp focus parallel to lens and film.
//
//   ./render scenes/paper/box_a.pov +W720 +H480
//
// Look for: sharpness at the box's nearest upper corner only, falling off before and behind it.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "box_camera.inc"

camera
{
  Box_Camera()
  focal_point Edge_Top
  tilt_lens
  {
    scene_unit Scene_Unit
    focal_length Focal_Length
    f_stop F_Stop
  }
}

#include "box_objects.inc"
