// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps in the dim: none is brighter than white, but each is some hundred times as bright as what it stands before. The lamps do
// not light the scene; a faint sky and a faint moon do.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 1.6, -5>;
#declare Look = <0, 0.7, 2>;
#declare Angle = 60;
#declare Focus = <0, 0.4, 2>;
#declare Aperture = 0.8;
#declare Lean = 60;
#include "camera.inc"

background { color rgb <0.004, 0.005, 0.008> }
light_source { <-30, 60, -20> color rgb 0.022 parallel point_at 0 }
#default { finish { ambient 0 diffuse 0.8 emission 0 } }
plane { y, -0.2 pigment { checker color rgb 0.7 color rgb 0.35 scale 0.5 } }
#declare Dice = seed(11);
// house-like boxes
#for (I, 0, 13)
  box
  {
    <-0.5, -0.2, -0.4>, <0.5, 0.5 + 1.5*rand(Dice), 0.4>
    rotate 40*(rand(Dice) - 0.5)*y
    translate <mod(I, 2)*7 - 3.5 + rand(Dice) - 0.5, 0, 1.5*I - 1>
    pigment { color rgb 0.4 + 0.4*<rand(Dice), rand(Dice), rand(Dice)> }
  }
#end
#declare Brightness = 0.9;
#ifdef (Depth) #declare Brightness = 0.05; #end    // as in lights.pov
#for (I, 1, 120)
  sphere
  {
    <rand(Dice)*14 - 7, rand(Dice)*3, rand(Dice)*22>, 0.025 + 0.02*rand(Dice)
    pigment { color rgb <1, 0.75 + rand(Dice)/4, 0.5 + rand(Dice)/2> }
    finish { diffuse 0 emission Brightness }
    no_shadow
  }
#end
