// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The states of scenes/paper/box_a.pov, box_b.pov and box_c.pov through a real lens: State 0, 1, 2. Glass 1: by its surfaces, of the
// file gauss.dat; 0: by distortion K1, K2, Near and field curvature of the ideal lens.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "box_camera.inc"

camera
{
  Box_Camera()
  #if (State = 0) focal_point Edge_Top #end
  tilt_lens
  {
    scene_unit Scene_Unit
    f_stop F_Stop
    #if (Glass) prescription "gauss.dat", Focal_Length
    #else focal_length Focal_Length  distortion K1, K2, Near  field_curvature Bent #end
    #if (State = 1) focal_plane { y, 8 } #end
    #if (State = 2) focal_plane { z, Edge_Top.z } #end
  }
}

#include "box_objects.inc"
