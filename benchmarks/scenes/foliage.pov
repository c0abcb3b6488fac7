// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Bushes of small leaves, near and far, in sunlight.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 1.5, -4>;
#declare Look = <0, 0.9, 2>;
#declare Angle = 55;
#declare Focus = <0, 0.8, 1.5>;
#declare Aperture = 0.3;
#declare Lean = 60;
#include "camera.inc"

light_source { <-40, 60, -50>, color rgb 1.1 }
sky_sphere { pigment { gradient y color_map { [0 color rgb <0.9, 0.92, 0.95>] [0.5 color rgb <0.35, 0.55, 0.85>] } } }
plane { y, 0 pigment { bozo color_map { [0 color rgb <0.15, 0.25, 0.07>] [1 color rgb <0.3, 0.33, 0.12>] } scale 0.2 } }

#declare Dice = seed(13);
#declare Bush = mesh
{
  #for (I, 1, 900)
    #local Place = vrotate(sqrt(rand(Dice))*<0, 0.75, 0>, <360*rand(Dice), 360*rand(Dice), 0>) + 0.85*y;
    #local Length = vrotate(0.11*x, 360*<rand(Dice), rand(Dice), rand(Dice)>);
    #local Breadth = 0.04*vnormalize(vcross(Length, <rand(Dice), rand(Dice), 1.1>));
    triangle { Place - Length, Place + Breadth, Place - Breadth }
    triangle { Place + Length, Place + Breadth, Place - Breadth }
  #end
}
#for (I, 0, 27)
  object
  {
    Bush
    rotate 360*rand(Dice)*y
    scale 0.45 + 0.4*rand(Dice)
    translate <(rand(Dice) - 0.5)*(4.5 + 0.8*I), 0, 0.55*I - 0.8>
    pigment { color rgb <0.15 + 0.3*rand(Dice), 0.35 + 0.2*rand(Dice), 0.08> }
    finish { ambient 0.12 diffuse 0.75 }
  }
#end
