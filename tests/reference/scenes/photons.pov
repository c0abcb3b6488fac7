// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A caustic seen through a swung lens.

#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 photons { count 4000 } }
#include "batch.inc"

camera
{
  perspective
  location <0, 3, -5>
  direction 1.4*z
  right Frame_Right*x
  up Frame_Up*y
  look_at <0, 0.3, 0>
  aperture 0.5
  focal_point <0, 0, -0.3>
  blur_samples 16, 512  confidence 0.95  variance 1/10000
  tilt_lens { scene_unit 300  film_width 36*Wider  swing 4 }
}

light_source { <3, 6, 2>, color rgb 0.9 photons { reflection on refraction on } }
plane { y, 0 pigment { color rgb 0.7 } finish { ambient 0.05 diffuse 0.8 } }
sphere
{
  <-0.5, 0.8, 0>, 0.7
  pigment { color rgbt <0.7, 0.9, 1, 0.95> }
  finish { diffuse 0 phong 0.5 }
  interior { ior 1.5 }
  photons { target refraction on reflection off collect off }
}
box { <0.9, 0, -0.6>, <1.4, 0.9, 0.2> pigment { color rgb <0.8, 0.3, 0.2> } finish { ambient 0.05 diffuse 0.8 } }
