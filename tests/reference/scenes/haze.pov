// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Media and fog behind a tilted lens.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "batch.inc"

camera
{
  perspective
  location <0, 1.5, -5>
  direction 1.3*z
  right Frame_Right*x
  up Frame_Up*y
  look_at <0, 0.8, 0>
  aperture 0.3
  focal_point <0, 0.5, -1>
  blur_samples 16, 256  confidence 0.95  variance 1/5000
  tilt_lens { scene_unit 250  film_width 36*Wider  tilt 5 }
}

light_source { <-4, 6, -4>, color rgb 0.9 }
fog { distance 25 color rgb <0.6, 0.65, 0.7> }
plane { y, 0 pigment { checker color rgb 0.7, color rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sphere
{
  <0.3, 1, 0.5>, 1
  hollow
  pigment { color rgbt 1 }
  interior { media { method 3 intervals 1 samples 4, 4 emission <0.25, 0.2, 0.1> density { spherical } } }
}
cylinder { <-1.2, 0, 2>, <-1.2, 2.5, 2>, 0.2 pigment { color rgb <0.2, 0.5, 0.3> } finish { ambient 0.1 diffuse 0.7 } }
