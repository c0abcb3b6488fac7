// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Equally bright all around: whatever the lens does, every pixel has that brightness.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "batch.inc"

camera
{
  perspective
  location <0, 0, -4>
  direction 0.8*z
  right Frame_Right*x
  up Frame_Up*y
  aperture 2
  focal_point <0, 0, 0>
  blur_samples 8, 64
  tilt_lens { scene_unit 100  film_width 36*Wider  tilt 12  swing -9  shift <10, -15>  blades 5 }
}

#default { finish { ambient 0 diffuse 0 emission 1 } }
background { color rgb <0.75, 0.5, 0.25> }
sphere { 0, 100 hollow pigment { color rgb <0.75, 0.5, 0.25> } }
plane { y, -1 pigment { color rgb <0.75, 0.5, 0.25> } }
sphere { <0.5, 0, 0>, 0.6 pigment { color rgb <0.75, 0.5, 0.25> } }
