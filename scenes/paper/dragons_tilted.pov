// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 4: a row of four dragons in depth, the lens turned so that the plane of sharp focus stands
// upright along the row.
//
//   ./render scenes/paper/dragons_tilted.pov +W720 +H405
//
// Look for: all four dragons are sharp, and the floor to the left and right of the row is not.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "dragons_objects.inc"

camera
{
  Dragons_Camera()
  tilt_lens { focal_points Row_Start, Row_Start + Row_Step, Row_Start + y }
}
