// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A forest on a September evening. The lens leans away from the scene (a negative tilt), so that the plane of sharp focus
// cuts through the ground instead of lying along it: the toadstools are sharp, while the birch beside them, at the same
// distance, is sharp only at its foot.
//
//   ./render scenes/gallery/forest_reverse_tilt.pov +W1280 +H720
//
// Try: Declare=Lean=0 for an ordinary lens, with which the birch is sharp to its top. With Declare=Lean=4, the picture is
// sharp from the moss in front to the far trees.
//
// One unit is a centimetre (scene_unit 10).

#version 3.7;
#ifndef (Samples) #declare Samples = 80; #end
#ifndef (Lean) #declare Lean = -7; #end
global_settings { assumed_gamma 1 max_trace_level 2 adc_bailout 0.03 }
#include "forest_things.inc"
#declare S = seed(927);

#declare Subject = <0, 22, 0>;
camera {
  perspective
  right x*image_width/image_height
  location <-6, 27, -92>
  look_at <6, 28, 0>
  focal_point Subject
  blur_samples Samples  confidence 0.95  variance 1/2000
  tilt_lens {
    scene_unit 10
    focal_length 35
    f_stop 1.7
    tilt Lean
  }
}

// ---- light: a low sun behind the trees, haze ----

#declare Sun = vnormalize(<0.95, 0.50, 0.62>);
light_source { Sun*1e5 rgb <1.00, 0.78, 0.46>*3.8 parallel point_at 0 }
light_source { <-3, 5, -4>*1e4 rgb <0.62, 0.78, 1.00>*0.45 parallel point_at 0 shadowless }
light_source { <0, 9, 2>*1e4 rgb <0.80, 0.90, 0.70>*0.42 parallel point_at 0 shadowless }
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <1.30, 1.05, 0.58>] [0.35 rgb <1.10, 1.00, 0.72>] [1 rgb <0.50, 0.62, 0.66>] }
  }
}
fog { fog_type 1 distance 2900 rgb <0.98, 0.80, 0.42> }

// ---- the ground ----

#declare F_Ground = function { pattern { bozo scale 90 } }
#macro Ground_At(X, Z) (16*F_Ground(X, 0, Z)-8 + 5*F_Ground(3*X, 7, 3*Z)-2.5 + (Z > 0 ? Z*0.03 : 0) +
  7*exp(-(X*X+Z*Z)/2000)) #end
#declare Moss = texture {
  pigment {
    granite turbulence 0.4
    color_map {
      [0.20 srgb <0.13, 0.15, 0.05>] [0.45 srgb <0.27, 0.31, 0.08>] [0.62 srgb <0.40, 0.40, 0.12>]
        [0.75 srgb <0.42, 0.28, 0.13>] [0.9 srgb <0.30, 0.18, 0.09>]
    }
    scale 26
  }
  normal { granite 0.7 scale 5 }
  finish { ambient 0 diffuse 0.8 }
}
#declare G_N = 70;
#macro Ground_Mesh(X0, Z0, Size)
  #local G = array[G_N+1][G_N+1]
  #for (I, 0, G_N) #for (J, 0, G_N)
    #local X = X0+Size*I/G_N;  #local Z = Z0+Size*J/G_N;
    #local G[I][J] = <X, Ground_At(X, Z), Z>;
  #end #end
  mesh {
    #for (I, 0, G_N-1) #for (J, 0, G_N-1)
      triangle { G[I][J], G[I+1][J], G[I+1][J+1] }
      triangle { G[I][J], G[I+1][J+1], G[I][J+1] }
    #end #end
    texture { Moss }
  }
#end
Ground_Mesh(-180, -150, 420)
difference { box { <-6000, -100, -400>, <6000, 6, 9000> } box { <-179, -200, -149>, <239, 100, 269> }
  texture { Moss } }

// moss cushions, fallen leaves, twigs near the camera
mesh {
  #for (I, 1, 2600)
    #local X = -110+240*rand(S);  #local Z = -95+230*rand(S);
    #local P = <X, Ground_At(X, Z)+0.4+0.5*rand(S), Z>;
    #local D = vnormalize(Any_Direction(S)*<1, 0.3, 1>);
    Leaf_Pieces(P, D, vnormalize(vcross(D, vnormalize(y+0.5*Any_Direction(S)))), 2.2+2*rand(S),
      T_Leaf[int(rand(S)*2.99)])
  #end
}
#declare Tufts = array[3]
#declare Ferns = array[3]
#for (I, 0, 2)
  #declare Tufts[I] = Grass_Tuft(46, 17, S)
  #declare Ferns[I] = Fern(9+I, 42, S)
#end
#for (I, 1, 420)
  #local X = -150+330*rand(S);  #local Z = -85+330*rand(S);
  #if (abs(X-Subject.x-0.1*Z) > 15 | Z > 22)
    object { Tufts[int(rand(S)*2.99)] scale 0.45+0.6*rand(S) rotate y*360*rand(S)
      translate <X, Ground_At(X, Z)-0.4, Z> }
  #end
#end

// ---- what the picture is about ----

#macro Stool(X, Z, H, R, Open, Turn)
  object { Toadstool(H, R, Open, S) rotate x*Turn rotate y*360*rand(S) translate <X, Ground_At(X, Z)-1, Z> }
#end
Stool(-3, 0, 17.5, 8.2, 0.62, 4)
Stool(11, 5, 12.5, 6.2, 0.35, -5)
Stool(4.5, -7.5, 8.2, 4.3, 0.10, 6)
Stool(-19, 15, 11, 6.8, 0.85, 3)
Stool(19, -4, 5.2, 2.9, 0.0, 3)

// ---- birches ----

#declare Trunks = array[4]
#declare Crowns = array[4]
#for (I, 0, 3)
  #declare Trunks[I] = Birch_Trunk(1250+90*I, 6.2+1.0*I, (I < 2 ? 34 : -46), S)
  #declare Crowns[I] = Birch_Crown(1330, 330+40*I, 46, 24, 14, S)
#end
#macro Birch(X, Z, K, Size, With_Crown)
  #local Turn = 360*rand(S);
  #if (With_Crown)
    union { object { Trunks[K] texture { T_Birch } } object { Crowns[K] no_shadow }
  #else
    object { Trunks[K] texture { T_Birch }
  #end
    scale Size rotate y*Turn rotate z*5*(rand(S)-0.5)
    translate <X, Ground_At(X, Z)*(abs(X) < 170 & Z < 250)+(Z >= 250)*6, Z>
  }
#end
Birch(-27, 10, 1, 1.0, no)            // beside the toadstools
Birch(58, 66, 0, 0.9, no)
Birch(-92, 118, 2, 0.95, no)
Birch(118, 170, 3, 1.0, no)
Birch(20, 260, 1, 1.0, no)
#for (I, 1, 58)
  #local Z = 330+2600*pow(rand(S), 1.2);
  #local X = (rand(S)-0.5)*2.1*(Z*0.62+160)+0.12*Z;
  Birch(X, Z, int(rand(S)*3.99), 0.8+0.4*rand(S), (Z > 600))
#end
// ferns: in front, beside, and a sea of them behind
#macro Fern_At(X, Z, Size)
  object { Ferns[int(rand(S)*2.99)] scale Size rotate y*360*rand(S)
    translate <X, Ground_At(X, Z)*(abs(X) < 170 & Z < 250)+(Z >= 250)*6-1, Z> }
#end
Fern_At(42, 12, 0.85) Fern_At(34, 42, 1.0) Fern_At(-62, 34, 1.05) Fern_At(-50, -38, 0.7)
  Fern_At(66, -14, 0.8) Fern_At(-12, 62, 0.9)
Fern_At(52, -62, 0.6) Fern_At(-84, 6, 0.9)
#for (I, 1, 150)
  #local Z = 70+900*pow(rand(S), 1.5);
  #local X = (rand(S)-0.5)*1.9*(Z*0.7+110);
  Fern_At(X, Z, 0.8+0.7*rand(S))
#end
// saplings whose leaves catch the sun
#for (I, 1, 22)
  #local Z = 120+620*rand(S);
  #local X = (rand(S)-0.5)*1.7*(Z*0.6+60);
  object { Crowns[int(rand(S)*3.99)] scale <0.30, 0.26, 0.30>*(0.8+0.5*rand(S)) rotate y*360*rand(S)
    translate <X, -70+40*rand(S), Z> no_shadow }
#end
// young trees at the wood's edge
#for (I, 1, 60)
  #local Z = 900+2200*rand(S);
  #local X = (rand(S)-0.5)*2*(Z*0.7+100);
  object { Crowns[int(rand(S)*3.99)] scale <0.8, 0.35, 0.8> rotate y*360*rand(S) translate <X, -110, Z> no_shadow }
#end
