// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Two hundred houses of brick in sunlight.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 2.4, -5>;
#declare Look = <0, 0.3, 2>;
#declare Angle = 55;
#declare Focus = <0, 0.4, 1.2>;
#declare Aperture = 0.4;
#declare Lean = 60;
#include "camera.inc"

light_source { <-40, 60, -30>, color rgb 1 }
background { color rgb <0.5, 0.7, 0.95> }
plane
{
  y, 0
  pigment { bozo color_map { [0 color rgb <0.2, 0.35, 0.1>] [1 color rgb <0.35, 0.4, 0.15>] } scale 0.3 }
}
#declare Dice = seed(7);
#for (I, 0, 199)
  #local X = (mod(I, 20) - 9.5)*0.6;
  #local Z = floor(I/20)*1.2 - 2;
  box
  {
    <X - 0.2, 0, Z - 0.2>, <X + 0.2, 0.3 + rand(Dice)*0.8, Z + 0.2>
    pigment { brick color rgb 0.8, color rgb <0.2 + 0.7*rand(Dice), 0.3, 0.2> scale 0.05 }
  }
#end
