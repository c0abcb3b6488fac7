// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Soft shadows: an area light of 5 by 5, each point jittered.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 1.6, -5>;
#declare Look = <0, 0.4, 2>;
#declare Angle = 67;
#declare Focus = <0, 0.4, 2>;
#declare Aperture = 0.3;
#declare Lean = 60;
#include "camera.inc"

light_source { <-4, 6, -3>, color rgb 1 area_light 3*x, 3*z, 5, 5 jitter }
background { color rgb <0.5, 0.7, 0.95> }
plane { y, 0 pigment { checker color rgb 0.8, color rgb 0.3 } }
#declare Dice = seed(9);
#for (I, 0, 39)
  sphere
  {
    <rand(Dice)*6 - 3, 0.3, I/3 - 2>, 0.3
    pigment { color rgb <rand(Dice), rand(Dice), rand(Dice)> }
  }
#end
