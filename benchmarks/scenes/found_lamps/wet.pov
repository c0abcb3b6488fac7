// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A wet road at night: waves of a puddle with highlights of lamps.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 2.5, -10>;
#declare Look = <0, 0, 0>;
#declare Sharp = <0, 0.5, -4>;
#declare Aperture = 0.6;
#include "found_lamps/camera.inc"

background { rgb 0.02 }
sphere { <-0.8, 0.5, -4>, 0.5 pigment { rgb <0.2, 0.4, 0.6> } finish { ambient 0.2 } }
#for (I, 0, 3)
  light_source { <8*I - 12, 9, 30>, Warm*0.5 }
#end
plane
{
  y, 0
  pigment { rgb 0.05 } normal { bumps 0.25 scale 0.7 }
  finish { specular 4*Lamps roughness 0.0008 }
}
