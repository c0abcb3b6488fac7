// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A checkered plane to the horizon and spheres; all of it shines by itself, so that nothing but the camera
// and the hierarchy of bounding boxes takes time. With Declare=Tell=1 the spheres are among the messages, for a renderer that
// draws the same picture.

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
#ifdef (Tell)
  #debug concat("Camera: ", vstr(3, Eye, " ", 0, 6), " ", vstr(3, Axis_, " ", 0, 6), "\n")    // lines of less than 80 characters
  #debug concat("Focus: ", vstr(3, <Angle, Distance_, Aperture/4>, " ", 0, 8), "\n")
#end
#declare Dice = seed(3);
#for (I, 0, 23)
  #declare Centre = <rand(Dice)*5 - 2.5, 0.3, I/2 - 2>;
  #declare Colour = 0.9*<rand(Dice), rand(Dice), rand(Dice)>;
  sphere { Centre, 0.3 pigment { color rgb Colour } }
  #ifdef (Tell) #debug concat("Sphere: ", vstr(3, Centre, " ", 0, 6), " ", vstr(3, Colour, " ", 0, 6), "\n") #end
#end
