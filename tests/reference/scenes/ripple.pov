// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The camera's own normal ripples the picture of a tilted lens.
// One picture is its reference, compared within limits: a larger picture is not the same with other
// samples, because a camera normal is laid over the whole frame.

#version 3.7;
global_settings { assumed_gamma 1.0 }

camera
{
  perspective
  location <0, 1.5, -5>
  direction 1.3*z
  right image_width/image_height*x
  look_at <0, 0.8, 0>
  aperture 0.3
  focal_point <0, 0.5, 0>
  blur_samples 16, 8192  confidence 0.95  variance 1/100000
  normal { ripples 0.3 scale 0.3 }
  tilt_lens { scene_unit 250  tilt 4  swing -3 }
}

background { color rgb <0.2, 0.3, 0.5> }
#default { finish { ambient 0 diffuse 0 emission 0.9 } }
plane { y, 0 pigment { checker color rgb <0.9, 0.8, 0.6>, color rgb <0.2, 0.2, 0.1> } }
box { <-0.8, 0, -0.4>, <0.8, 1.6, 0.4> pigment { checker color rgb <0.8, 0.2, 0.2>, color rgb 0.9 scale 0.4 } rotate 30*y }
