// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Swing: a shelf of books that runs away from the camera, sharp from end to end.
//
//   ./render scenes/tutorial/swing.pov +W640 +H360
//
// Look for: all spines can be read, from the nearest to the farthest. The vase and the ball in front of the shelf are
// blurred, because they lie outside the upright wedge of sharpness.
// Try: swing 0, with which a few books are sharp; swing -Swing, with which fewer are.
//
// Tilt turns the lens about the horizontal axis, and swing about the vertical one. The shelf is on the left of the
// camera; a positive swing puts the hinge line to the left, too.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#declare Lens = <42, 20, -70>;       // the spines are in the plane x = 0
#declare Aim  = <0, 13, 14>;
#declare F    = 55;                  // millimetres
#declare Axis = vnormalize(Aim-Lens);
#declare Level = vnormalize(<Axis.x, 0, Axis.z>);
#declare Swing = degrees(asin(F*Level.z/(Lens.x*10)));

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
    swing Swing                      // about 6.7 degrees
  }
}

light_source { <160, 220, -140> color rgb <1.0, 0.93, 0.82>*1.6 parallel point_at 0 }
light_source { <120, 60, 200> color rgb <0.6, 0.75, 1.0>*0.45 parallel point_at 0 shadowless }
background { color srgb <0.55, 0.62, 0.66> }
#declare Wall = texture { pigment { color srgb <0.72, 0.76, 0.72> } finish { Set_Matt } }
plane { x, -22 texture { Wall } }
plane { z, 320 texture { Wall } }
box { <-22, -3, -80>, <12, 0, 320> texture { Set_Wood } }
box { <-22, 32, -80>, <3, 34, 320> texture { Set_Wood rotate y*3 } }
box { <-22, -60, -80>, <-20, 34, 320> texture { Set_Wood rotate x*90 } }

// A book stands on y = 0 with a rounded spine in x = 0; it takes W along the shelf.
#macro Book(W, H, C, Band)
  union {
    box { <-16, 0, 0>, <-0.6, H, W> }
    cylinder { <0, 0.0, 0>, <0, H, 0>, 1 scale <0.6, 1, W/2> translate <-0.6, 0, W/2> }
    #for (I, 0, 2)
      cylinder {
        <0, H*(0.2+0.28*I), 0>, <0, H*(0.2+0.28*I)+Band, 0>, 1
        scale <0.66, 1, W/2+0.01> translate <-0.6, 0, W/2>
        texture { pigment { color srgb <0.92, 0.76, 0.36> } finish { Set_Gloss } }
      }
    #end
    #for (I, 0, 3)                   // the lines of the title
      box {
        <-0.5, H*0.52+0.9*I, W*0.28>, <0.06, H*0.52+0.9*I+0.35, W*0.72>
        texture { pigment { color srgb <0.96, 0.92, 0.80> } finish { Set_Matt } }
      }
    #end
    texture { pigment { color srgb C } finish { Set_Gloss } }
  }
#end

#declare S = seed(11);
#declare Z = -60;
#while (Z < 310)
  #declare W = 2.6+2.2*rand(S);
  object {
    Book(W, 18+9*rand(S), Set_Colours[int(rand(S)*6.99)]*(0.55+0.4*rand(S)), 0.3+0.6*rand(S))
    translate z*Z
  }
  #declare Z = Z+W+0.08;
#end

union {
  sphere { y*4.2, 4.2 }
  cone { y*7, 2.4, y*13, 1.5 }
  torus { 1.5, 0.3 translate y*13 }
  Set_Colour(<0.16, 0.45, 0.50>)
  translate <7, 0, 52>
}
sphere { <7, 2.6, 4>, 2.6 Set_Colour(<0.90, 0.30, 0.10>) }
