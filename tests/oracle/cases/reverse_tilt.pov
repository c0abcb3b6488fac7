// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Tilted the other way: only a narrow wedge is sharp.
// The same camera for the oracle: reverse_tilt.json.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "checks.inc"

#ifndef (Tilt_Sign) #declare Tilt_Sign = 1; #end  // -1: the mirrored lens, which must fail

camera
{
  perspective
  location <0, 1.6, -4>
  right image_width/image_height*x
  look_at <0.1, 0.7, 3>
  angle 40
  aperture 0.4
  focal_point <0.3, 0.6, 2>
  blur_samples 32, 4096  confidence 0.95  variance 1/100000
  tilt_lens { scene_unit 250  tilt -5*Tilt_Sign }
}
