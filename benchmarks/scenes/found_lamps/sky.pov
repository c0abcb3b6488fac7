// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Suns that a pigment of the sky shows.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
sky_sphere
{
  pigment
  {
    // 1 within small circles of a grid
    function { select(pow(mod(x + 10, 0.11) - 0.055, 2) + pow(mod(y + 10, 0.11) - 0.055, 2) - pow(Radius/22, 2), 1, 0) }
    color_map { [0.5 rgb 0.08] [0.5 #if (Lamps) Warm*Glow #else rgb 0.08 #end] }
  }
}
