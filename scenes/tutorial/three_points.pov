// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Three points: the program turns the lens so that three given points are in focus.
//
//   ./render scenes/tutorial/three_points.pov +W640 +H360
//
// Look for: the three red pins stand near, far and high, and all three heads are sharp. Other pins are sharp only near the
// plane through these three points.
// Try: another pin for P_3; no focal_points, with which the lens focuses on look_at.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#declare P_1 = <-7.5,  3.5, -9>;
#declare P_2 = < 7.0,  9.0,  4>;
#declare P_3 = <-5.0, 11.5, 25>;

camera {
  perspective
  right x*image_width/image_height
  location <2, 21, -42>
  look_at <0, 5.4, 6>
  angle 41
  blur_samples 16, 128  confidence 0.95  variance 1/3000
  tilt_lens {
    scene_unit 10                    // one unit is 10 mm
    f_stop 1.4
    focal_points P_1, P_2, P_3
  }
}

Set_Light()

// A map as model: land, a river, roads; painted on the table.
box {
  <-60, -3, -40>, <60, 0, 140>
  texture {
    pigment {
      bozo turbulence 0.35 octaves 4
      color_map {
        [0.38 srgb <0.42, 0.66, 0.80>] [0.40 srgb <0.93, 0.89, 0.74>] [0.42 srgb <0.80, 0.84, 0.60>]
        [0.60 srgb <0.86, 0.87, 0.66>] [0.80 srgb <0.94, 0.90, 0.76>]
      }
      scale 17 translate <7, 0, 3>
    }
    finish { Set_Matt }
  }
}
#for (I, -12, 12)
  cylinder { <I*5, -0.06, -40>, <I*5, -0.06, 140>, 0.1 pigment { color srgb <0.55, 0.52, 0.45> } }
#end
#for (I, -8, 28)
  cylinder { <-60, -0.06, I*5>, <60, -0.06, I*5>, 0.1 pigment { color srgb <0.55, 0.52, 0.45> } }
#end

// A pin with its point on the map and the middle of its head in P.
#macro Pin(P, C)
  union {
    cylinder { P*<1, 0, 1>, P, 0.14 pigment { color srgb <0.75, 0.76, 0.78> } finish { Set_Gloss } }
    sphere { P, 1 }
    Set_Colour(C)
  }
#end

Pin(P_1, <0.85, 0.06, 0.06>)
Pin(P_2, <0.85, 0.06, 0.06>)
Pin(P_3, <0.85, 0.06, 0.06>)
#declare S = seed(5);
#for (J, 0, 9)
  #for (I, 0, 5)
    #declare P = <-15+6*I+4*(rand(S)-0.5), 2.5+9*rand(S), -14+6.5*J+4*(rand(S)-0.5)>;
    #if (min(vlength(P-P_1), vlength(P-P_2), vlength(P-P_3)) > 4.5)
      Pin(P, (rand(S) < 0.5 ? <0.93, 0.92, 0.88> : <0.16, 0.30, 0.46>))
    #end
  #end
#end
