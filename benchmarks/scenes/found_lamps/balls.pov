// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Small glossy balls, each with one highlight of the sun.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 4, -12>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 0.4;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
plane { y, -0.5 pigment { rgb 0.15 } }
#for (I, 0, 7)
  #for (J, 0, 4)
    sphere
    {
      <1.1*I - 3.85, -0.2, 2*J - 4>, 0.3
      pigment { rgb <0.1, 0.15, 0.3> } finish { specular 3*Lamps roughness 0.0005 }
    }
  #end
#end
