// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A room in the light of its window (radiosity). The light is gathered once, with Gather=1, and read from
// a file by all cameras, so that they look at the same room and only the camera's noise counts.

#version 3.7;
#ifndef (Gather) #declare Gather = 0; #end
global_settings
{
  assumed_gamma 1.0
  radiosity
  {
    pretrace_start (Gather ? 0.08 : 1) pretrace_end (Gather ? 0.02 : 1)
    count 120 nearest_count 6 error_bound (Gather ? 1.0 : 1.8) low_error_factor 0.7 recursion_limit 2
    always_sample off
  }
}
#declare Eye = <-1.6, 1.5, -2.6>;
#declare Look = <0.4, 0.6, 0.8>;
#declare Angle = (Gather ? 75 : 62);
#declare Focus = <0.1, 0.7, 0.3>;
#declare Aperture = 0.2;
#declare Lean = 60;
#include "camera.inc"

#default { finish { ambient 0 emission 0 diffuse 0.8 } }
light_source { <14, 9, 4>, color rgb 6*<1, 0.93, 0.8> parallel point_at <0, 0, 0> }
sky_sphere { pigment { color rgb 2.5*<0.6, 0.75, 1> } }

// the room, its window to the right
difference
{
  box { <-2.2, -0.1, -3.2>, <2.2, 2.8, 3.2> }
  box { <-2.1, 0, -3.1>, <2.1, 2.7, 3.1> }
  box { <2, 0.9, -1.2>, <2.3, 2.3, 1.6> }
  pigment { color rgb <0.85, 0.82, 0.76> }
}
box
{
  <-2.1, 0, -3.1>, <2.1, 0.001, 3.1>
  pigment { checker color rgb <0.75, 0.7, 0.6>, color rgb <0.3, 0.2, 0.15> scale 0.3 }
}
box { <2.0, 0.9, 0.15>, <2.15, 2.3, 0.25> pigment { color rgb 0.9 } }

// a table with things, shelves, a ball
union
{
  box { <-0.5, 0.66, -0.3>, <0.9, 0.7, 0.9> }
  #for (I, 0, 3) cylinder { <-0.42 + 1.24*mod(I, 2), 0, -0.22 + 1.04*(I > 1)>, <-0.42 + 1.24*mod(I, 2), 0.66, -0.22 + 1.04*(I > 1)>, 0.03 } #end
  pigment { color rgb <0.55, 0.35, 0.2> }
}
#declare Dice = seed(17);
#for (I, 0, 11)
  #local Size = 0.05 + 0.06*rand(Dice);
  sphere
  {
    <-0.4 + 1.2*rand(Dice), 0.7 + Size, -0.2 + I/11>, Size
    pigment { color rgb <0.2 + 0.75*rand(Dice), 0.2 + 0.6*rand(Dice), 0.15 + 0.6*rand(Dice)> }
  }
#end
#for (Shelf, 0, 3)
  box { <-1.4, 0.5 + 0.5*Shelf, 2.8>, <1.6, 0.53 + 0.5*Shelf, 3.1> pigment { color rgb <0.7, 0.6, 0.45> } }
  #local X = -1.35;
  #while (X < 1.5)
    #local Thick = 0.03 + 0.05*rand(Dice);
    box
    {
      <X, 0.53 + 0.5*Shelf, 2.82>, <X + Thick, 0.75 + 0.5*Shelf + 0.15*rand(Dice), 3.05>
      pigment { color rgb <0.15 + 0.7*rand(Dice), 0.15 + 0.5*rand(Dice), 0.15 + 0.5*rand(Dice)> }
    }
    #local X = X + Thick + 0.006;
  #end
#end
sphere { <-0.9, 0.3, 1.4>, 0.3 pigment { color rgb <0.8, 0.25, 0.2> } }
