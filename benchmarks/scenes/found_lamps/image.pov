// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A photograph of windows at night, on a wall that glows.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#declare Brightness = 0.2;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
plane
{
  -z, -12
  pigment
  {
    // windows of two pixels or three
    image_map
    {
      function 256, 192 { select(max(abs(mod(12*x, 1) - 0.5) - 0.04, abs(mod(8*y, 1) - 0.5) - 0.04), Lamps, 0) }
      once
    }
    scale <24, 18, 1> translate <-12, -9, 0>
  }
  finish { emission Glow diffuse 0 }
}
