// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// 300 stars of white, each half a pixel wide, before black, in circles of some four pixels.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 45/image_width;
#include "found_lamps/camera.inc"

background { rgb 0 }
#declare Dice = seed(3);
#for (I, 1, 300*Lamps)
  #declare Far = 20 + 40*rand(Dice);
  sphere
  {
    <(rand(Dice) - 0.5)*0.72*Far, (rand(Dice) - 0.5)*0.54*Far, Far - 10>, Far*0.18/image_width
    pigment { rgb 1 } finish { emission 1 diffuse 0 ambient 0 }
  }
#end
