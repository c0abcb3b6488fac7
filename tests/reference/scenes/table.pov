// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A real lens over a table: focal length, f-number, seven blades, highlights, glass.

#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 6 }
#include "batch.inc"

camera
{
  perspective
  location <0, 3.2, -6>
  direction 1.5*z
  right Frame_Right*x
  up Frame_Up*y
  look_at <0, 0.4, 0>
  focal_point <0.2, 0.2, -1>
  blur_samples 16, 1024  confidence 0.95  variance 1/10000
  tilt_lens { scene_unit 60  film_width 36*Wider  focal_length 50  f_stop 2.8  tilt 7  blades 7, 10 }
}

light_source { <-5, 8, -3>, color rgb 0.9 }
background { color rgb <0.25, 0.3, 0.4> }
plane { y, 0 pigment { checker color rgb <0.6, 0.4, 0.25>, color rgb <0.45, 0.3, 0.2> } finish { ambient 0.05 diffuse 0.8 } }
#declare I = 0;
#while (I < 5)
  sphere
  {
    <-1.6 + 0.8*I, 0.4, -2 + 1.4*I>, 0.4
    pigment { color rgb <0.3 + 0.15*I, 0.2, 0.9 - 0.15*I> }
    finish { ambient 0.05 diffuse 0.7 phong 0.8 phong_size 60 reflection 0.1 }
  }
  #declare I = I + 1;
#end
sphere { <1.4, 0.5, -1.6>, 0.5 pigment { color rgbt <0.9, 1, 0.95, 0.9> } finish { diffuse 0.1 phong 0.8 } interior { ior 1.5 } }
sphere { <-1.8, 2.2, 6>, 0.12 pigment { color rgb 1 } finish { ambient 0 diffuse 0 emission 4 } }
