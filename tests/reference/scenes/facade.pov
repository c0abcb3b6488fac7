// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A pinhole with a rising front: verticals stay parallel. No aperture, so no noise.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "batch.inc"

camera
{
  perspective
  location <0, 1.6, -12>
  direction 1.1*z
  right Frame_Right*x
  up Frame_Up*y
  tilt_lens { film_width 36*Wider  shift <-2, 11> }
}

light_source { <-8, 12, -10>, color rgb 0.9 }
background { color rgb <0.5, 0.65, 0.9> }
plane { y, 0 pigment { color rgb <0.3, 0.4, 0.3> } finish { ambient 0.1 diffuse 0.7 } }
box { <-4, 0, 0>, <4, 10, 4> pigment { brick color rgb 0.8, color rgb <0.7, 0.35, 0.2> scale 0.25 } finish { ambient 0.1 diffuse 0.7 } }
cylinder { <5.5, 0, 1>, <5.5, 9, 1>, 0.5 pigment { color rgb 0.75 } finish { ambient 0.1 diffuse 0.7 } }
