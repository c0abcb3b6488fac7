// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A diaphragm of three blades in a tilted lens: neither turned nor upside down.
// The same camera for the oracle: triangle.json.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "dots.inc"

#ifndef (Tilt_Sign) #declare Tilt_Sign = 1; #end
#ifndef (Blades_Sign) #declare Blades_Sign = 1; #end  // -1: the mirrored lens, which must fail

camera
{
  perspective
  location <0, 1.6, -4>
  right image_width/image_height*x
  look_at <0.1, 0.7, 3>
  angle 40
  aperture 2
  focal_point <-0.5, 0.6, -1>
  blur_samples 32, 4096  confidence 0.95  variance 1/100000
  tilt_lens { scene_unit 200  tilt 7*Tilt_Sign  blades 3, 20*Blades_Sign }
}
