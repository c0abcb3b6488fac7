// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The plane of sharp focus along the ground, by three points; posts rise out of it. Area light.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "batch.inc"

camera
{
  perspective
  location <0, 2, -5>
  direction 1.2*z
  right Frame_Right*x
  up Frame_Up*y
  look_at <0.3, 0.8, 2>
  aperture 0.4
  blur_samples 16, 1024  confidence 0.95  variance 1/10000
  tilt_lens { film_width 36*Wider  focal_points <-1, 0, 0>, <1, 0, 1>, <0, 0.2, 8> }
}

light_source { <4, 7, -6>, color rgb 0.9 area_light x, y, 3, 3 }
background { color rgb <0.4, 0.55, 0.8> }
plane { y, 0 pigment { checker color rgb 0.7, color rgb <0.2, 0.35, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
#declare I = 0;
#while (I < 6)
  cylinder { <-2 + 0.9*I, 0, -1 + 2.2*I>, <-2 + 0.9*I, 1.5 + 0.3*I, -1 + 2.2*I>, 0.15 pigment { color rgb <0.8, 0.3, 0.1> } finish { ambient 0.1 diffuse 0.7 } }
  #declare I = I + 1;
#end
