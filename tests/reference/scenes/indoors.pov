// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Radiosity, alpha of a filter, and a camera that is moved after its lens was set.
// One picture is its reference, compared within limits: a larger picture is not the same with other
// samples, because radiosity's samples depend on the picture's size.

#version 3.7;
global_settings
{
  assumed_gamma 1.0
  radiosity { pretrace_start 0.08 pretrace_end 0.02 count 40 nearest_count 4 error_bound 0.8 recursion_limit 1 always_sample off }
}

camera
{
  perspective
  location <0, 0, -4>
  direction 1.2*z
  right image_width/image_height*x
  aperture 0.25
  focal_point <0, 0, 0>
  blur_samples 16, 256  confidence 0.95  variance 1/5000
  tilt_lens { scene_unit 250  swing 6 }
  rotate <8, -12, 0>
  translate 1.5*y
}

#default { finish { ambient 0 diffuse 0.7 } }
box { <-3, 0, -6>, <3, 3, 3> hollow pigment { color rgb <0.8, 0.75, 0.7> } }
light_source { <1.5, 2.7, -1>, color rgb 0.6 }
box { <-1.4, 0, -0.5>, <-0.5, 1.3, 0.4> pigment { color rgb <0.8, 0.3, 0.2> } rotate 15*y }
sphere { <0.8, 0.6, 0.6>, 0.6 pigment { color rgb <0.2, 0.4, 0.8> } }
box { <0.2, 0, -1.6>, <1.3, 1, -1.55> pigment { color rgbf <1, 0.9, 0.4, 0.7> } }
