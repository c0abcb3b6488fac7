// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// An aperture painted by a pigment: half of it is clear, half lets a third through. Dots show it.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "batch.inc"

camera
{
  perspective
  location <0, 0, -4>
  direction 1.5*z
  right Frame_Right*x
  up Frame_Up*y
  aperture 1.2
  focal_point <0, 0, -1>
  bokeh { pigment { gradient x color_map { [0.5 color rgb 1] [0.5 color rgb 1/3] } } }
  blur_samples 16, 1024  confidence 0.95  variance 1/10000
  tilt_lens { scene_unit 400  film_width 36*Wider  tilt 3 }
}

background { color rgb 0.05 }
#default { finish { ambient 0 diffuse 0 emission 1 } }
sphere { <-1.5, 0.9, 3>, 0.2 pigment { color rgb <1, 0.8, 0.3> } finish { emission 4 } }
sphere { <1.4, 0.4, 4>, 0.2 pigment { color rgb <0.4, 0.8, 1> } finish { emission 4 } }
sphere { <0, -0.9, 2>, 0.2 pigment { color rgb <0.5, 1, 0.5> } finish { emission 4 } }
box { <-0.3, -0.2, -1>, <0.3, 0.2, -0.9> pigment { checker color rgb 1 color rgb 0.2 scale 0.1 } }
