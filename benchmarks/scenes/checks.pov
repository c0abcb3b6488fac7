// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A checkered plane to the horizon and spheres; all of it shines by itself, so that nothing but the camera
// and the hierarchy of bounding boxes takes time.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 1.6, -5>;
#declare Look = <0, 0.4, 2>;
#declare Angle = 67;
#declare Focus = <0, 0.4, 2>;
#declare Aperture = 0.3;
#declare Lean = 60;
#include "camera.inc"

#default { finish { ambient 0 diffuse 0 emission 1 } }
background { color rgb <0.3, 0.5, 0.9> }
plane { y, 0 pigment { checker color rgb 1, color rgb 0.1 scale 0.5 } }
#declare Dice = seed(3);
#for (I, 0, 23)
  sphere
  {
    <rand(Dice)*5 - 2.5, 0.3, I/2 - 2>, 0.3
    pigment { color rgb 0.9*<rand(Dice), rand(Dice), rand(Dice)> }
  }
#end
