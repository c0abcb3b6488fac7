// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A physical lens: focal length, f-number and film width as on a real camera.
//
//   ./render scenes/tutorial/physical_lens.pov +W640 +H360
//   ./render scenes/tutorial/physical_lens.pov +W640 +H360 Declare=Stop=16
//
// Look for: with 90 mm at f/4, and dice of 16 mm about 40 cm away, the sharp zone is as thin as in a photograph:
// one die is sharp, and its neighbours are not. The program prints the limits of sharpness, which can be compared with a
// depth-of-field table.
// Try: Stop=16; tilt 8, which turns the plane of sharp focus along the row.
//
// The scene is in millimetres, so scene_unit is 1. There is no `angle`: focal length and film width determine the angle of
// view.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#ifndef (Stop)
  #declare Stop = 4;
#end

camera {
  perspective
  right x*image_width/image_height
  location <90, 130, -400>
  look_at <0, 8, 6>
  focal_point <-9, 8, -14>
  blur_samples 16, 256  confidence 0.95  variance 1/10000
  tilt_lens {
    film_width 36
    focal_length 90
    f_stop Stop
    scene_unit 1
  }
}

Set_Light()
box { <-2000, -40, -1000>, <2000, 0, 3000> texture { Set_Wood scale 10 } }

#declare Pip_Colour = texture { pigment { color srgb <0.96, 0.95, 0.90> } finish { Set_Gloss } }

// A pip at (X, Y) of the face z = -8, turned to the face it belongs to.
#macro Pip(X, Y, Turn)
  sphere { 0, 1.6 scale <1, 1, 0.12> translate <X, Y, -8> rotate Turn texture { Pip_Colour } }
#end
#macro Pips(N, Turn)
  #if (mod(N, 2) = 1) Pip(0, 0, Turn) #end
  #if (N > 1) Pip(4, 4, Turn) Pip(-4, -4, Turn) #end
  #if (N > 3) Pip(4, -4, Turn) Pip(-4, 4, Turn) #end
  #if (N > 5) Pip(4, 0, Turn) Pip(-4, 0, Turn) #end
#end
// A die of 16 mm with rounded corners, standing on y = 0; opposite faces add up to seven.
#macro Die(C)
  union {
    intersection {
      box { -8, 8 }
      sphere { 0, 11.9 }
      Set_Colour(C)
    }
    Pips(1, 0) Pips(2, y*-90) Pips(3, x*90) Pips(4, x*-90) Pips(5, y*90) Pips(6, y*180)
    translate y*8
  }
#end

#declare S = seed(21);
#for (I, 0, 10)
  object {
    Die(Set_Colours[mod(I, 6)])
    rotate y*(20+50*rand(S))
    translate <-66+14.5*I, 0, -112+26*I>
  }
#end
