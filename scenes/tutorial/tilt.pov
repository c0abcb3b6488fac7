// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Tilt: a board that is sharp from the nearest square to the farthest.
//
//   ./render scenes/tutorial/tilt.pov +W640 +H360
//
// Look for: all squares are sharp, although the lens is wide open. The zone of sharpness is a wedge along the board:
// heads of pawns that rise out of the wedge are blurred, the near ones most.
// Try: Tilt = 0, an ordinary lens, with which only one row is sharp.
//
// The plane of sharp focus passes through the hinge line, which runs below the lens at the distance
// J = focal length / sin(tilt). For a board at the height H below a lens that looks down by Pitch: J = H / cos(Pitch).

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#declare Lens = <8, 34, -58>;        // centimetres above and before the board
#declare Aim  = <0, 0, 44>;
#declare F    = 50;                  // millimetres
#declare Pitch = asin((Lens.y-Aim.y)/vlength(Aim-Lens));
#declare Tilt = degrees(asin(F*cos(Pitch)/(Lens.y*10)));

camera {
  perspective
  right x*image_width/image_height
  location Lens
  look_at Aim
  blur_samples 16, 256  confidence 0.95  variance 1/10000
  tilt_lens {
    scene_unit 10                    // one unit is 10 mm
    focal_length F
    f_stop 2
    tilt Tilt                        // about 8 degrees
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
#declare S = seed(7);
#for (J, 0, 30)
  #declare I = mod(J*5+2, 8);
  object {
    Pawn
    Set_Colour(Set_Colours[mod(J, 7)])
    translate <-21+6*I, 0, -15+6*J>
  }
#end
