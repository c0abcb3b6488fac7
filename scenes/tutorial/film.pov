// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A plane of sharp focus that sweeps through the scene with the clock, for ./batch.
//
//   ./batch film scenes/tutorial/film.pov --frames 24 +W320 +H180
//   ./batch sweep scenes/tutorial/film.pov --set Tilt=-8:8:4 --set Stop=1.4,4 +W320 +H180
//
// Look for: in the film, the sharp row of pawns moves from the first to the last. In the sweep, the whole table is sharp
// with tilt 8 at any f-number; with tilt -8, a narrow strip of it is.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#ifndef (Tilt) #declare Tilt = 0; #end
#ifndef (Stop) #declare Stop = 1.4; #end

camera {
  perspective
  right x*image_width/image_height
  location <8, 34, -58>
  look_at <0, 0, 44>
  angle 40
  focal_point <0, 0, -15+clock*150>  // from the first pawn to the last
  blur_samples 16, 64  confidence 0.95  variance 1/2000  // quick rather than fine
  tilt_lens {
    scene_unit 10                    // one unit is 10 mm
    f_stop Stop
    tilt Tilt
  }
}

Set_Light()
box { <-200, -4, -40>, <200, -0.6, 400> texture { Set_Wood } }
box {
  <-24, -0.6, -24>, <24, 0, 168>
  texture {
    pigment { checker color srgb <0.93, 0.87, 0.74>, color srgb <0.16, 0.24, 0.30> scale 6 translate y }
    finish { Set_Gloss }
  }
}

#declare Pawn = Set_Pawn(9)
#for (J, 0, 25)
  object {
    Pawn
    Set_Colour(Set_Colours[mod(J, 7)])
    translate <-21+6*mod(J*5+2, 8), 0, -15+6*J>
  }
#end
