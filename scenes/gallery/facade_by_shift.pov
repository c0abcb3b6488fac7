// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A guildhall of brick, photographed from the street with a 4x5 inch camera. The camera is level
// and looks at the door; a shift of 42 mm upward brings the gable into the frame. The walls are therefore vertical in the
// picture, which they are not if the camera looks up.
//
//   ./render scenes/gallery/facade_by_shift.pov +W1280 +H1024
//
// Try: Declare=Look_Up=1 aims the camera at the gable, without shift: the towers lean. shift <40, 42> shows more of the
// house on the right.
//
// One unit is a metre.

#version 3.7;
#ifndef (Samples) #declare Samples = 64; #end
#ifndef (Look_Up) #declare Look_Up = no; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "tilt_lens.inc"
#include "gothic_front.inc"
#include "facade_materials.inc"
#declare S = seed(1390);

#declare Eye = <-3.5, 1.65, -31>;
camera {
  perspective
  right x*image_width/image_height
  location Eye
  look_at (Look_Up ? <-0.2, 12.6, 0> : Eye+z)
  focal_point <0, 8, 0>
  blur_samples Samples  confidence 0.95  variance 1/4000
  tilt_lens {
    film_width Tilt_Lens_Film_4x5[0]
    focal_length 105
    f_stop 16
    #if (!Look_Up) shift <9, 42> #end
  }
}

// ---- an afternoon sun that rakes the wall; a sky with some cloud ----

light_source { <-1.0, 0.86, -0.62>*1e5 rgb <1.00, 0.86, 0.66>*2.7 parallel point_at 0 }
light_source { <0.4, 1, -0.8>*1e5 rgb <0.52, 0.70, 1.00>*0.34 parallel point_at 0 shadowless }
light_source { <0.6, -0.6, -0.8>*1e5 rgb <1.00, 0.82, 0.60>*0.13 parallel point_at 0 shadowless }
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.62, 0.74, 0.86>] [0.25 rgb <0.28, 0.47, 0.74>] [0.8 rgb <0.10, 0.24, 0.54>] }
  }
  pigment {
    wrinkles turbulence 0.55 octaves 6 omega 0.55
    color_map { [0.42 rgbt 1] [0.62 rgbt <0.95, 0.94, 0.92, 0.45>] [0.9 rgbt <1.0, 0.98, 0.95, 0.12>] }
    scale <0.75, 0.22, 0.6> rotate z*-9 translate <0.3, 0.12, 0>
  }
}

// ---- the guildhall: 16 metres wide, its middle at x = 0 ----

#declare Bay_W = 16/7;
#declare Gable_Top = array[7] { 17.2, 20.4, 23.2, 25.4, 23.2, 20.4, 17.2 }
mesh {
  // ground floor: portal between two pairs of windows
  GF_Wall(-2.3, 2.3, 0, 6.1, <0, 0.1, 0>, 3.9, 2.7, 0.95)
  #for (I, 0, 3)
    #local W = 3.9-0.46*I;
    GF_Reveal(<0, 0.1, 0>, W, 2.7, 0.95, 0.22*I, 0.22*(I+1), 0.23, M_Brick)
    GF_Roll(<0, 0.1, 0>, W-0.20, 2.7, 0.95, 0.22*I+0.14, 0.10, M_Glazed)
    GF_Roll(<0, 0.1, 0>, W-0.40, 2.7, 0.95, 0.22*I+0.20, 0.05, M_Sandstone)
  #end
  GF_Pane(<0, 0.1, 0>, 2.06, 2.7, 0.95, 0.90, M_Leaded)
  GF_Box_T(<-1.03, 2.75, 0.78>, <1.03, 2.98, 0.9>, M_Sandstone)
  GF_Box_T(<-1.03, 0.1, 0.80>, <-0.03, 2.75, 0.88>, M_Door)
  GF_Box_T(<0.03, 0.1, 0.80>, <1.03, 2.75, 0.88>, M_Door)
  #for (Side, -1, 1, 2) #for (K, 0, 1)
    GF_Box_T(<0.53*Side-0.34, 0.35+1.2*K, 0.76>, <0.53*Side+0.34, 1.35+1.1*K, 0.80>, M_Door)
    GF_Box_T(<0.53*Side-0.46, 0.62+1.5*K, 0.755>, <0.53*Side+0.46, 0.68+1.5*K, 0.80>, M_Iron)
  #end #end
  GF_Roll(<-0.5, 2.95, 0>, 0.9, 0.35, 1, 0.84, 0.05, M_Sandstone) GF_Roll(<0.5, 2.95, 0>, 0.9, 0.35, 1,
    0.84, 0.05, M_Sandstone)
  GF_Ring(<0, 4.25, 0>, 0.5, 0.11, 0.82, M_Sandstone)
  GF_Box_T(<-2.1, 0, -0.55>, <2.1, 0.12, 0.9>, M_Granite)
  GF_Box_T(<-2.5, -0.1, -0.95>, <2.5, 0.01, 0.3>, M_Granite)
  #for (I, 0, 3)
    #local X = (I < 2 ? -1 : 1)*(3.75+2.85*mod(I, 2));
    GF_Wall(X-1.425-(mod(I, 2) ? 0 : 0.025), X+1.425, 0, 6.1, <X, 1.55, 0>, 1.9, 2.2, 1)
    GF_Window(<X, 1.55, 0>, 1.9, 2.2, 1, M_Brick, M_Glazed, M_Sandstone, M_Leaded)
  #end
  #for (Side, -1, 1, 2)
    GF_Box_T(<min(2.05*Side, 8.02*Side), 0, -0.12>, <max(2.05*Side, 8.02*Side), 0.95, 0.0>, M_Granite)
    GF_Box_T(<min(2.05*Side, 8.06*Side), 0.95, -0.16>, <max(2.05*Side, 8.06*Side), 1.05, 0.0>, M_Sandstone)
  #end
  // the friezes: a band of plaster with rings of brick between two courses
  #for (K, 0, 1)
    #local Y = (K ? 12.35 : 6.1);
    GF_Quad_T(<-8, Y, 0.06>, <8, Y, 0.06>, <8, Y+0.95, 0.06>, <-8, Y+0.95, 0.06>, M_Plaster)
    GF_Box_T(<-8.05, Y-0.05, -0.14>, <8.05, Y+0.13, 0.06>, M_Glazed)
    GF_Box_T(<-8.05, Y+0.80, -0.10>, <8.05, Y+0.88, 0.06>, M_Glazed)
    GF_Box_T(<-8.1, Y+0.88, -0.2>, <8.1, Y+0.98, 0.06>, M_Sandstone)
    #for (I, 0, 23)
      GF_Ring(<-7.66+16/24*I, Y+0.465, 0>, 0.30, 0.07, 0.0, M_Brick)
      #for (J, 0, 3) GF_Ring(<-7.66+16/24*I+0.11*cos(pi/2*J), Y+0.465+0.11*sin(pi/2*J), 0>, 0.11, 0.04,
        0.02, M_Brick) #end
    #end
  #end
  // first floor: five tall windows
  #for (I, 0, 4)
    #local X = -6.4+3.2*I;
    GF_Wall(X-1.6, X+1.6, 7.05, 12.35, <X, 7.75, 0>, 1.95, 2.6, 1)
    GF_Window(<X, 7.75, 0>, 1.95, 2.6, 1, M_Brick, M_Glazed, M_Sandstone, M_Leaded)
  #end
  // the gable: seven bays with niches in two or three tiers, stepped, piers between them
  #for (I, 0, 6)
    #local X = (I-3)*Bay_W;  #local Top = Gable_Top[I];
    #local Y = 13.35;
    #while (Y < Top-2.2)
      #local H = min(3.1, Top-Y);
      #if (Top-Y-H < 2.2) #local H = Top-Y; #end
      #local Hs = H-0.62-1.15*0.866;
      GF_Wall(X-Bay_W/2, X+Bay_W/2, Y, Y+H, <X, Y+0.32, 0>, 1.15, Hs, 1)
      #if (I = 3 & Y < 14)
        GF_Window(<X, Y+0.32, 0>, 1.15, Hs, 1, M_Brick, M_Glazed, M_Sandstone, M_Leaded)
      #else
        GF_Niche(<X, Y+0.32, 0>, 1.15, Hs, 1, M_Brick, M_Glazed, M_Plaster)
      #end
      #local Y = Y+H;
    #end
    GF_Quad(<X-Bay_W/2, 13.3, 0.5>, <X-Bay_W/2, 13.3, 0>, <X-Bay_W/2, Top, 0>, <X-Bay_W/2, Top, 0.5>)
    GF_Quad(<X+Bay_W/2, 13.3, 0.5>, <X+Bay_W/2, 13.3, 0>, <X+Bay_W/2, Top, 0>, <X+Bay_W/2, Top, 0.5>)
    // each step ends in a small gable of its own, with a copper cap
    triangle { <X-Bay_W/2, Top, 0>, <X+Bay_W/2, Top, 0>, <X, Top+1.25, 0> }
    GF_Ring(<X, Top+0.42, 0>, 0.27, 0.08, 0.0, M_Glazed)
    #for (Side, -1, 1, 2)
      GF_Quad_T(<X+(Bay_W/2+0.1)*Side, Top-0.05, -0.14>, <X, Top+1.38, -0.14>, <X, Top+1.38, 0.6>,
        <X+(Bay_W/2+0.1)*Side, Top-0.05, 0.6>, M_Copper)
      GF_Quad_T(<X+(Bay_W/2+0.1)*Side, Top-0.05, -0.14>, <X, Top+1.38, -0.14>, <X, Top+1.24, -0.14>,
        <X+(Bay_W/2+0.1)*Side, Top-0.19, -0.14>, M_Copper)
    #end
    Ball_Pieces(<X, Top+1.45, 0>, <0.12, 0.2, 0.12>, 0, 6, 10)
  #end
  #for (I, 0, 7)
    #local X = (I-3.5)*Bay_W;
    #local Top = max(Gable_Top[max(0, min(6, I-1))], Gable_Top[max(0, min(6, I))]);
    GF_Pinnacle(X, 13.35, Top+0.7, 0.24, M_Copper)
  #end
  GF_Pinnacle(-7.92, 0, 13.35, 0.32, M_Copper) GF_Pinnacle(7.92, 0, 13.35, 0.32, M_Copper)
  texture { M_Brick }
}
box { <-8, 0, 0.95>, <8, 13.2, 14> texture { M_Brick } }
prism { linear_spline 0.6, 14, 4, <-8.2, 13>, <8.2, 13>, <0, 25.5>, <-8.2, 13> rotate x*-90
  scale <1, 1, -1> texture { M_Tiles } }
// a clock
union {
  cylinder { <0, 18.3, -0.22>, <0, 18.3, 0>, 1.02 texture { M_Sandstone } }
  cylinder { <0, 18.3, -0.24>, <0, 18.3, 0>, 0.86 pigment { srgb <0.08, 0.12, 0.22> }
    finish { diffuse 0.8 ambient 0 } }
  #for (I, 0, 11) box { <-0.03, 0.62, -0.27>, <0.03, 0.80, 0> rotate z*30*I translate y*18.3 } #end
  box { <-0.035, -0.1, -0.29>, <0.035, 0.70, -0.26> rotate z*-132 translate y*18.3 }
  box { <-0.045, -0.1, -0.29>, <0.045, 0.45, -0.26> rotate z*-111 translate y*18.3 }
  torus { 0.88, 0.05 rotate x*90 translate <0, 18.3, -0.24> }
  pigment { srgb <0.85, 0.62, 0.22> } finish { ambient 0 diffuse 0.6 specular 0.6 metallic }
}
// lanterns beside the door
#for (Side, -1, 1, 2)
  union {
    cylinder { <0, 0, 0>, <0, 0, -0.6>, 0.025 } cylinder { <0, -0.5, 0>, <0, 0, -0.5>, 0.02 } torus
      { 0.17, 0.018 rotate z*90 translate <0, -0.17, -0.2> }
    cone { <0, 0.02, -0.6>, 0.02, <0, -0.18, -0.6>, 0.19 }
    cone { <0, -0.62, -0.6>, 0.09, <0, -0.66, -0.6>, 0.04 }
    #for (I, 0, 5) cylinder { vrotate(<0.16, -0.18, 0>, y*60*I)-z*0.6, vrotate(<0.09, -0.62, 0>,
      y*60*I)-z*0.6, 0.012 } #end
    cone { <0, -0.2, -0.6>, 0.14, <0, -0.6, -0.6>, 0.08 pigment { rgb <1, 0.86, 0.6> }
      finish { ambient 0 diffuse 0.5 emission 0.55 } }
    texture { M_Iron } translate <2.32*Side, 3.9, 0>
  }
#end

// ---- its neighbours ----

// left: stucco, shutters closed here and there, a curved gable
#declare M_Flowers = array[2]
#declare M_Flowers[0] = texture { pigment { srgb <0.82, 0.06, 0.10> } finish { ambient 0 diffuse 0.9 } }
#declare M_Flowers[1] = texture { pigment { srgb <0.20, 0.42, 0.12> } finish { ambient 0 diffuse 0.9 } }
#macro Stucco_House(X0, W, Floors, NB, T)
  #local BW = W/NB;
  mesh {
    #for (F, 0, Floors-1) #for (I, 0, NB-1)
      #local X = X0+BW*(I+0.5);  #local Y0 = (F = 0 ? 0 : 0.9+3.5*F);  #local Y1 = 0.9+3.5*(F+1);
      #if (F = 0 & I = int(NB/2))
        GF_Wall(X-BW/2, X+BW/2, Y0, Y1, <X, 0.1, 0>, 1.25, 2.5, 0.5)
        GF_Sash(<X, 0.1, 0>, 1.25, 2.5, 0.5, 2, 1, M_Sandstone, M_Door, M_Door)
        GF_Roll(<X, 0.1, 0>, 1.4, 2.5, 0.5, -0.02, 0.12, M_Sandstone)
      #else
        GF_Wall(X-BW/2, X+BW/2, Y0, Y1, <X, Y1-2.7, 0>, 1.15, 1.95, (F = 1 ? 0.75 : 0))
        GF_Sash(<X, Y1-2.7, 0>, 1.15, 1.95, (F = 1 ? 0.75 : 0), 2, 4, M_White, M_White, M_Pane)
        GF_Roll(<X, Y1-2.7, 0>, 1.30, 2.02, (F = 1 ? 0.75 : 0), -0.01, 0.07, M_White)
        #if (mod(I+F, 3) = 0 & F > 0)
          GF_Box_T(<X-1.15, Y1-2.7, -0.06>, <X-0.62, Y1-0.75, -0.01>, M_Door)
            GF_Box_T(<X+0.62, Y1-2.7, -0.06>, <X+1.15, Y1-0.75, -0.01>, M_Door)
        #end
        #if (F > 0 & mod(I*2+F, 3) = 1)   // geraniums
          GF_Box_T(<X-0.62, Y1-2.86, -0.34>, <X+0.62, Y1-2.62, -0.10>, M_Iron)
          #for (K, 1, 90)
            #local P = <X+1.3*(rand(S)-0.5), Y1-2.62+0.3*rand(S)-0.12*rand(S), -0.22+0.24*(rand(S)-0.5)>;
            triangle { P, P+0.09*<rand(S)-0.5, rand(S), -rand(S)>*2, P+0.09*<rand(S)-0.5, rand(S)-0.5,
              -rand(S)>*2 texture { M_Flowers[int(rand(S)*1.99)] } }
          #end
        #end
      #end
    #end #end
    GF_Box_T(<X0, 4.25, -0.12>, <X0+W, 4.42, 0>, M_Sandstone)
    GF_Box_T(<X0-0.1, 0.9+3.5*Floors-0.02, -0.35>, <X0+W+0.1, 0.9+3.5*Floors+0.16, 0>, M_White)
    GF_Box_T(<X0-0.1, 0.9+3.5*Floors+0.16, -0.5>, <X0+W+0.1, 0.9+3.5*Floors+0.28, 0>, M_White)
    GF_Box_T(<X0, 0, -0.08>, <X0+W, 0.7, 0>, M_Granite)
    texture { T }
  }
  prism {
    linear_spline 0, 12, 5, <X0-0.2, 0>, <X0+W+0.2, 0>, <X0+W-0.2, 5.2>, <X0+0.2, 5.2>, <X0-0.2, 0>
    rotate x*-90 scale <1, 1, -1> translate y*(0.9+3.5*Floors+0.25) matrix <1, 0, 0, 0, 1, 0.55, 0, 0, 1, 0,
      0, -7> texture { M_Tiles }
  }
#end
Stucco_House(-20.2, 12.1, 3, 5, M_Ochre)
Stucco_House(-30, 9.6, 2, 4, Stucco(<0.74, 0.76, 0.70>))
// right: an older house of darker brick with a stepped gable and a hoist
#declare Step_N = 5;
mesh {
  #for (F, 0, 2) #for (I, 0, 3)
    #local X = 8.3+2.5*(I+0.5);  #local Y1 = 0.7+3.4*(F+1);
    GF_Wall(X-1.25, X+1.25, (F ? Y1-3.4 : 0), Y1, <X, Y1-2.75, 0>, 1.35, 1.6, 0.6)
    GF_Sash(<X, Y1-2.75, 0>, 1.35, 1.6, 0.6, 3, 4, M_Brick_2, M_White, M_Pane)
    GF_Roll(<X, Y1-2.75, 0>, 1.45, 1.6, 0.6, 0.0, 0.07, M_Sandstone)
  #end #end
  #for (K, 0, Step_N-1)
    #local A = 8.3+1.0*K;  #local B = 18.3-1.0*K;  #local Y0 = 10.9+1.75*K;
    #if (K < 4)
      #local M = (A+B)/2;
      GF_Wall(A, B, Y0, Y0+1.75, <M, Y0+0.3, 0>, (mod(K, 2) ? 0.9 : 1.2), 0.7, 0.55)
      #if (mod(K, 2)) GF_Niche(<M, Y0+0.3, 0>, 0.9, 0.7, 0.55, M_Brick_2, M_Glazed, M_Plaster)
      #else GF_Sash(<M, Y0+0.3, 0>, 1.2, 0.7, 0.55, 2, 2, M_Brick_2, M_Door, M_Door) #end
    #else
      GF_Quad(<A, Y0, 0>, <B, Y0, 0>, <B, Y0+1.75, 0>, <A, Y0+1.75, 0>)
    #end
    GF_Box_T(<A-0.1, Y0+1.68, -0.12>, <A+1.1, Y0+1.85, 0.5>, M_Sandstone)
    GF_Box_T(<B-1.1, Y0+1.68, -0.12>, <B+0.1, Y0+1.85, 0.5>, M_Sandstone)
    GF_Quad(<A, Y0, 0>, <A, Y0, 0.5>, <A, Y0+1.7, 0.5>, <A, Y0+1.7, 0>)
    GF_Quad(<B, Y0, 0>, <B, Y0, 0.5>, <B, Y0+1.7, 0.5>, <B, Y0+1.7, 0>)
    #for (Side, 0, 1) GF_Ring(<(Side ? B-0.75 : A+0.75), Y0+0.8, 0>, 0.26, 0.07, 0.0, M_Glazed) #end
  #end
  GF_Box_T(<8.3, 0, -0.1>, <18.3, 0.75, 0>, M_Granite)
  GF_Box_T(<8.25, 10.75, -0.16>, <18.35, 10.92, 0>, M_Sandstone)
  GF_Box_T(<13.15, 17.3, -1.3>, <13.45, 17.6, 0.2>, M_Door)
  texture { M_Brick_2 }
}
cylinder { <13.3, 17.3, -1.15>, <13.3, 15.9, -1.15>, 0.02 texture { M_Iron } }
prism { linear_spline 0.3, 12, 4, <8.4, 10.8>, <18.2, 10.8>, <13.3, 19>, <8.4, 10.8> rotate x*-90
  scale <1, 1, -1> texture { M_Tiles } }
box { <8.4, 0, 0.3>, <18.2, 10.9, 12> texture { M_Brick_2 } }
box { <-30, 0, 0.3>, <-8.1, 7.9, 12> texture { M_Ochre } }
Stucco_House(18.6, 9, 2, 4, Stucco(<0.84, 0.60, 0.50>))

// ---- the street: setts, still wet in the hollows ----

#declare Sett_Dry = texture {
  pigment {
    brick pigment { srgb <0.20, 0.18, 0.16> }, pigment { cells color_map { [0 srgb <0.40, 0.37, 0.34>]
      [0.5 srgb <0.50, 0.46, 0.42>] [1 srgb <0.34, 0.33, 0.32>] } scale <0.19, 0.12, 0.12> }
    brick_size <0.19, 0.12, 0.12> mortar 0.018 rotate x*90
  }
  normal { bumps 0.5 scale 0.09 }
  finish { ambient 0 diffuse 0.8 }
}
#declare Sett_Wet = texture {
  pigment {
    brick pigment { srgb <0.07, 0.06, 0.055> }, pigment { cells color_map { [0 srgb <0.20, 0.185, 0.17>]
      [1 srgb <0.27, 0.25, 0.23>] } scale <0.19, 0.12, 0.12> }
    brick_size <0.19, 0.12, 0.12> mortar 0.018 rotate x*90
  }
  normal { bumps 0.012 scale 0.5 }
  finish { ambient 0 diffuse 0.6 specular 0.5 roughness 0.01 reflection { 0.12, 0.9 falloff 3 } }
}
plane {
  y, 0
  texture { bozo turbulence 0.35 texture_map { [0.50 Sett_Dry] [0.56 Sett_Wet] }
    scale <2.6, 1, 1.7> translate <1.3, 0, 0.4> }
}
// a kerb of granite and flags along the houses
box { <-60, -1, -2.3>, <60, 0.10, 0.2> texture { pigment { brick srgb <0.36, 0.34, 0.31>,
  srgb <0.56, 0.53, 0.48> brick_size <1.3, 0.4, 0.75> mortar 0.02 } normal { granite 0.15 }
  finish { ambient 0 diffuse 0.8 } } }
box { <-60, -1, -2.6>, <60, 0.13, -2.3> texture { M_Granite } }
#for (X, -27, 24, 3)
  #if (abs(X) > 2.5)
    mesh { Turned_Pieces(array[8] { <0.16, 0, 0>, <0.15, 0.1, 0>, <0.12, 0.16, 0>, <0.10, 0.75, 0>,
      <0.14, 0.82, 0>, <0.10, 0.90, 0>, <0.09, 0.97, 0>, <0, 1.03, 0> }, 8, 3, 16) texture { M_Iron }
      translate <X, 0.1, -2.1> }
  #end
#end
// box trees in tubs beside the door
#for (Side, -1, 1, 2)
  union {
    mesh { Turned_Pieces(array[5] { <0.28, 0, 0>, <0.30, 0.1, 0>, <0.36, 0.5, 0>, <0.36, 0.5, 0>,
      <0.30, 0.48, 0> }, 5, 3, 24) texture { M_Sandstone } }
    mesh {
      #for (I, 1, 1500)
        #local A = 2*pi*rand(S);  #local Z = 2*rand(S)-1;  #local D = <cos(A)*sqrt(1-Z*Z), Z,
          sin(A)*sqrt(1-Z*Z)>;
        #local P = D*0.46*(0.8+0.25*rand(S))+y*1.0;
        triangle { P, P+0.07*<rand(S)-0.5, rand(S)-0.3, rand(S)-0.5>*2, P+0.07*<rand(S)-0.5, rand(S)-0.3,
          rand(S)-0.5>*2 }
      #end
      pigment { srgb <0.16, 0.30, 0.09> } finish { ambient 0 diffuse 0.9 }
    }
    sphere { y*1.0, 0.38 pigment { srgb <0.04, 0.08, 0.03> } }
    cylinder { y*0.4, y*0.8, 0.05 texture { M_Door } }
    translate <2.75*Side, 0.1, -0.75>
  }
#end
// a bicycle against the wall
#macro Rod(A, B, R) cylinder { A, B, R } #end
union {
  #for (I, 0, 1)
    torus { 0.33, 0.018 rotate x*90 translate <1.05*I, 0.34, 0> pigment { srgb 0.05 }
      finish { ambient 0 diffuse 0.7 } }
    torus { 0.30, 0.010 rotate x*90 translate <1.05*I, 0.34, 0> pigment { srgb 0.7 }
      finish { ambient 0 diffuse 0.7 } }
    #for (K, 0, 11) Rod(<1.05*I, 0.34, 0>, <1.05*I, 0.34, 0>+0.3*<cos(pi*K/6), sin(pi*K/6), 0>, 0.003) #end
  #end
  Rod(<0, 0.34, 0>, <0.42, 0.32, 0>, 0.014) Rod(<0, 0.34, 0>, <0.30, 0.82, 0>, 0.012)
    Rod(<0.42, 0.32, 0>, <0.27, 0.95, 0>, 0.017)
  Rod(<0.42, 0.32, 0>, <0.90, 0.80, 0>, 0.018) Rod(<0.30, 0.82, 0>, <0.88, 0.88, 0>, 0.017)
    Rod(<1.05, 0.34, 0>, <0.86, 1.02, 0>, 0.017)
  Rod(<0.86, 1.02, -0.26>, <0.86, 1.02, 0.26>, 0.013) Rod(<0.80, 1.0, -0.26>, <0.86, 1.02, -0.26>, 0.016)
  sphere { 0, 1 scale <0.14, 0.04, 0.08> translate <0.25, 0.98, 0> pigment { srgb <0.25, 0.13, 0.06> } }
  torus { 0.09, 0.012 rotate x*90 translate <0.42, 0.32, 0> }
  pigment { srgb <0.10, 0.26, 0.24> } finish { ambient 0 diffuse 0.8 specular 0.4 }
  rotate x*8 translate <4.6, 0.1, -0.42>
}
