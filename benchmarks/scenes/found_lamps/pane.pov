// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps behind a thick pane of glass at an angle, which shifts them.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#declare Brightness = 0.3;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
plane { -z, -30 pigment { rgb 0.08 } }
box
{
  <-20, -12, -0.5>, <20, 12, 0.5>
  pigment { rgbt <0.9, 0.95, 0.9, 0.9> } finish { reflection 0.08 diffuse 0 } interior { ior 1.5 }
  rotate 40*y translate 6*z
}
Array(14*z, Announced)
