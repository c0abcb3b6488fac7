// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A lens in millimetres: focal length and f-number, focus breathing included.
// The same camera for the oracle: physical.json.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "checks.inc"

#ifndef (Tilt_Sign) #declare Tilt_Sign = 1; #end
#ifndef (Swing_Sign) #declare Swing_Sign = 1; #end  // -1: the mirrored lens, which must fail

camera
{
  perspective
  location <0, 1.6, -4>
  right image_width/image_height*x
  look_at <0.1, 0.7, 3>
  focal_point <0.3, 0.6, 2>
  blur_samples 32, 4096  confidence 0.95  variance 1/100000
  tilt_lens { scene_unit 100  focal_length 50  f_stop 2.8  tilt 3*Tilt_Sign  swing -2*Swing_Sign }
}
