// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Count small spheres in a slab that the picture shows from edge to edge: what the hierarchy of bounding
// boxes costs as it grows. The spheres shrink as they become more, so that as much of the sky is covered.

#version 3.7;
#ifndef (Count) #declare Count = 1000; #end
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 0, -6>;
#declare Look = <0, 0, 0>;
#declare Angle = 50;
#declare Focus = <0, 0, 0>;
#declare Aperture = 0.3;
#declare Lean = 60;
#include "camera.inc"

background { color rgb <0.3, 0.4, 0.6> }
#declare Dice = seed(23);
#for (I, 1, Count)
  sphere
  {
    <6*rand(Dice) - 3, 4.6*rand(Dice) - 2.3, 4*rand(Dice) - 1>, 3/sqrt(Count)
    pigment { color rgb <rand(Dice), rand(Dice), rand(Dice)> } finish { ambient 0 diffuse 0 emission 1 }
  }
#end
