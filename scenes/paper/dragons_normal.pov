// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 4: a row of four dragons in depth, the ordinary lens.
//
//   ./render scenes/paper/dragons_normal.pov +W720 +H405
//
// Look for: one dragon is sharp, the second; the others are not.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "dragons_objects.inc"

camera
{
  Dragons_Camera()
  focal_point Row_Start + Row_Step + 0.8*y
  tilt_lens { }
}
