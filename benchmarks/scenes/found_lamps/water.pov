// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps on the ground of a pool, under waves.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 5, -10>;
#declare Look = <0, 0, 0>;
#declare Sharp = <0, 0.6, -2>;
#declare Aperture = 2;
#declare Brightness = 0.15;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
background { rgb <0.2, 0.3, 0.4> }
sphere { <-1.2, 0.6, -2>, 0.6 pigment { rgb <0.6, 0.4, 0.2> } }
plane
{
  y, 0
  hollow pigment { rgbt <0.9, 0.95, 1, 0.95> } finish { reflection 0.1 diffuse 0 } interior { ior 1.33 }
  normal { bumps 0.03 scale 3 }
}
plane { y, -8 pigment { checker rgb 0.12 rgb 0.06 scale 2 } }
#if (Lamps)
  #for (I, 0, 5)
    #for (J, 0, 3)
      sphere { <2.2*I - 5.5 + 0.3*J, -7.5, 3*J - 4>, Radius texture { Announced } }
    #end
  #end
#end
