// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The same game as a film camera with an anamorphic lens sees it: lamps are upright ovals, narrower towards the sides, the frame bulges a
// little, its corners are darker, and edges have a trace of colour. Each of these traits is an item of tilt_lens.
//
//   ./render scenes/gallery/chess_anamorphic.pov +W1280 +H536
//
// Try: Declare=Character=0 for an ideal lens; Declare=Swung=0 for a lens without swing.
//
// One unit is a centimetre (scene_unit 10).

#version 3.7;
#ifndef (Samples) #declare Samples = 256; #end
#ifndef (Character) #declare Character = yes; #end
#ifndef (Swung) #declare Swung = yes; #end
global_settings { assumed_gamma 1 max_trace_level 3 }

#declare Night_Away = 70;
camera {
  perspective
  right x*image_width/image_height
  location <0, 10.5, -Night_Away>
  look_at <0, 8.2, 0>
  focal_point <0, 6, 0>
  blur_samples Samples  confidence 0.9  variance 1/4000
  tilt_lens {
    scene_unit 10
    focal_length 50
    f_stop 1.4
    #if (Character)
      squeeze 2
      edge_light 0.35
      optical_vignetting 0.45
      natural_vignetting 1
      distortion 0.04
      lateral_colour 0.06
      axial_colour 0.15
    #end
    swing (Swung ? degrees(asin(5/Night_Away)) : 0)
  }
}
#include "chess_at_night.inc"
