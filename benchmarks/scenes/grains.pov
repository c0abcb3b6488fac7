// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A wall of bright grains, so many that plain samples find them: what aiming at each would cost (docs/notebook.md).
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
plane
{
  -z, -12
  pigment { granite color_map { [0.65 rgb 0.05] [0.65 4.5*Lamps*Warm] [1 4.5*Lamps*Warm] } scale 1.2 }
  finish { ambient 0 diffuse 0 emission 1 }
}
