// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A sky of stars that a pigment shows, as Starfield1 of POV-Ray's stars.inc does.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 0.25;
#include "found_lamps/camera.inc"

sky_sphere
{
  pigment
  {
    granite scale 0.02
    color_map { [0 rgb 0] [0.74 rgb 0] [0.78 rgb 0.8*Lamps] [0.9 rgb 1.5*Lamps] }
  }
}
box { <-2, -1.5, 0>, <-1, -0.5, 1> pigment { rgb <0.6, 0.4, 0.2> } finish { emission 0.3 } }
