// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A penalty kick in a full stadium. focal_plane sets the plane of sharp focus upright along the line of the shot: striker,
// keeper, goal and the supporters behind the goal are sharp. The blur of everything else makes the stadium look like a
// model.
//
//   ./render scenes/gallery/miniature_stadium.pov +W1280 +H720
//
// Try: Declare=Stop=1.4 for the blur of a smaller model, 8 for that of a larger one; focal_plane { y, 0 } for a sharp pitch
// and blurred stands.
//
// One unit is a metre; scene_unit 1000/87 is the scale H0. The pitch lies at y = 0 along x; the
// near stand is at -z.

#version 3.7;
#ifndef (Samples) #declare Samples = 160; #end
#ifndef (Stop) #declare Stop = 2; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "town_streets.inc"
#include "harbour_things.inc"

camera {
  perspective
  right x*image_width/image_height
  location <-34, 46, -82>
  look_at <34, 8, 16>
  angle 39
  blur_samples Samples  confidence 0.95  variance 1/4000
  tilt_lens {
    scene_unit 1000/87
    focal_plane { z, 0.5 }
    f_stop Stop
  }
}

light_source { <-150, 74, -66>*1000 rgb <1.00, 0.82, 0.58>*2.35 parallel point_at 0 }
light_source { <60, 160, -60>*1000 rgb <0.52, 0.68, 1.00>*0.42 parallel point_at 0 shadowless }
light_source { <40, 60, 160>*1000 rgb <0.60, 0.72, 1.00>*0.20 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.90, 0.86, 0.78>] [0.5 srgb <0.36, 0.56, 0.82>] } }
  }
#declare S = seed(1954);

// ---- the pitch: 105 by 68 metres, mown in stripes ----

#declare Grass = texture {
  pigment {
    gradient x
    pigment_map {
      [0.5 granite color_map { [0.3 srgb <0.21, 0.44, 0.10>] [0.7 srgb <0.27, 0.52, 0.13>] } scale 3]
      [0.5 granite color_map { [0.3 srgb <0.30, 0.56, 0.14>] [0.7 srgb <0.37, 0.63, 0.18>] } scale 3]
    }
    scale 10.5 translate x*52.5
  }
  finish { F_Matt }
}
box { <-62, -1, -42>, <62, 0, 42> texture { Grass } }
#declare Line = texture { pigment { srgb 0.97 } finish { F_Matt } }
#macro Stroke(X0, Z0, X1, Z1) box { <min(X0, X1)-0.09, 0, min(Z0, Z1)-0.09>,
  <max(X0, X1)+0.09, 0.02, max(Z0, Z1)+0.09> } #end
#macro Arc(C, R) difference { cylinder { 0, y*0.02, R+0.09 } cylinder { -y, y, R-0.09 } translate C } #end
union {
  Stroke(-52.5, -34, 52.5, -34) Stroke(-52.5, 34, 52.5, 34) Stroke(0, -34, 0, 34)
  Arc(0, 9.15) cylinder { 0, y*0.025, 0.3 }
  #for (Side, -1, 1, 2)
    Stroke(52.5*Side, -34, 52.5*Side, 34)
    Stroke(36*Side, -20.16, 36*Side, 20.16) Stroke(36*Side, 20.16, 52.5*Side, 20.16) Stroke(36*Side, -20.16,
      52.5*Side, -20.16)
    Stroke(47*Side, -9.16, 47*Side, 9.16) Stroke(47*Side, 9.16, 52.5*Side, 9.16) Stroke(47*Side, -9.16,
      52.5*Side, -9.16)
    cylinder { 0, y*0.025, 0.22 translate x*41.5*Side }
    intersection { Arc(x*41.5*Side, 9.15) box { <0, -1, -10>, <36, 1, 10> scale <Side, 1, 1> } bounded_by
      { box { <-53, -1, -10>, <53, 1, 10> } } }
    #for (K, -1, 1, 2) intersection { Arc(<52.5*Side, 0, 34*K>, 1) box { <-52.5, -1, -34>, <52.5, 1, 34> } }
      #end
  #end
  texture { Line }
}
// red running track around it, and the boards with advertisements
difference {
  box { <-78, -1, -54>, <78, -0.02, 54> }
  box { <-62, -2, -42>, <62, 1, 42> }
  Speckled(<0.13, 0.30, 0.46>, <0.18, 0.36, 0.53>, 3)
}
#for (I, 1, 4)
  difference {
    box { <-64.5-2.2*I, -0.02, -43-2.2*I>, <64.5+2.2*I, 0.0, 43+2.2*I> }
    box { <-64.4-2.2*I, -2, -42.9-2.2*I>, <64.4+2.2*I, 1, 42.9+2.2*I> }
    texture { Line }
  }
#end
#declare Slogans = array[6] { "SCHEIMPFLUG", "f/1.4", "HINGE & SONS", "TILT", "SHIFT", "MERKLINGER" }
#macro Board(P, Turn, K)
  union {
    box { <-4.4, 0, 0>, <4.4, 0.95, 0.12> pigment { srgb Car_Colours[mod(K*5+2, 9)]*0.9+0.05 }
      finish { F_Matt } }
    #local TX = text { internal 1, Slogans[mod(K, 6)], 0.04, 0 scale <0.86, 0.86, 1> };
    object { TX translate <-(max_extent(TX).x+min_extent(TX).x)/2, 0.2, -0.03> pigment {
      srgb (mod(K*5+2, 9) = 3 | mod(K*5+2, 9) = 2 ? <0.1, 0.1, 0.2> : <0.97, 0.97, 0.97>) }
      finish { F_Matt } }
    rotate y*Turn translate P
  }
#end
#for (I, 0, 12) Board(<-54+9*I, 0, 39.5>, 0, I) Board(<-54+9*I, 0, -39.5>, 180, I) #end
#for (I, 0, 7) Board(<58.5, 0, -32+9*I>, 90, I+3) Board(<-58.5, 0, -32+9*I>, -90, I+1) #end

// ---- goals, flags, players ----

#macro Goal(Side)
  mesh {
    Bar_T(<52.5*Side, 0, -3.66>, <52.5*Side, 2.5, -3.66>, 0.16, T_Frame)
    Bar_T(<52.5*Side, 0, 3.66>, <52.5*Side, 2.5, 3.66>, 0.16, T_Frame)
    Bar_T(<52.5*Side, 2.5, -3.74>, <52.5*Side, 2.5, 3.74>, 0.16, T_Frame)
    #for (I, 0, 18)   // net
      #local Z = -3.66+7.32*I/18;
      Bar_T(<52.5*Side, 2.45, Z>, <53.7*Side, 2.4, Z>, 0.03, T_Stripe_A)
      Bar_T(<53.7*Side, 2.4, Z>, <54.6*Side, 0, Z>, 0.03, T_Stripe_A)
    #end
    #for (I, 0, 7) Bar_T(<(53.7+0.9*I/7)*Side, 2.4-2.4*I/7, -3.66>, <(53.7+0.9*I/7)*Side, 2.4-2.4*I/7,
      3.66>, 0.03, T_Stripe_A) #end
    #for (I, 0, 6) #for (K, -1, 1, 2)
      Bar_T(<(52.5+2*I/6)*Side, 0, 3.66*K>, <(52.5+1.2*I/6)*Side, 2.42, 3.66*K>, 0.03, T_Stripe_A)
      Bar_T(<52.5*Side, 2.4*I/6, 3.66*K>, <(54.6-0.9*I/6)*Side, 2.4*I/6, 3.66*K>, 0.03, T_Stripe_A)
    #end #end
  }
#end
Goal(1) Goal(-1)
#for (I, 0, 3)
  #local P = <(mod(I, 2) ? 52.5 : -52.5), 0, (I > 1 ? 34 : -34)>;
  cylinder { P, P+y*1.6, 0.04 texture { T_Stripe_A } }
  triangle { P+y*1.6, P+y*1.15, P+<0.55, 1.4, 0.2> texture { T_Orange } }
#end
// A player: legs apart as in a step, arms; shirt from the object. Looks toward +x.
#macro Player(Stride, Arms, T_Shorts)
  mesh {
    #for (K, -1, 1, 2)
      Bar_T(<0.30*Stride*K, 0, 0.12*K>, <0, 0.85, 0.1*K>, 0.17, T_Skin)
      Bar_T(<0.30*Stride*K, 0, 0.12*K>, <0.20*Stride*K, 0.32, 0.11*K>, 0.20, T_Stripe_A)
      Bar_T(<0.18*Stride*K, 0.5, 0.12*K>, <0, 0.95, 0.09*K>, 0.26, T_Shorts)
      Bar_T(<0.0, 1.42, 0.22*K>, <-0.20*Stride*K, 1.42-0.42*cos(Arms), (0.30+0.42*sin(Arms))*K>, 0.13,
        T_Skin)
      Bar_T(<0.0, 1.45, 0.18*K>, <-0.10*Stride*K, 1.44-0.2*cos(Arms), (0.27+0.2*sin(Arms))*K>, 0.19,
        T_Shorts)
    #end
    Stem(<0, 0, 0>, 7, 0.9, 0.20, 1.2, 0.25)
    Stem(<0, 0, 0>, 7, 1.2, 0.25, 1.5, 0.20)
    Ball_Pieces_T(<0.02, 1.68, 0>, <0.13, 0.16, 0.12>, T_Skin)
    Ball_Pieces_T(<-0.02, 1.74, 0>, <0.135, 0.13, 0.125>, T_Bark)
  }
#end
#declare Players = array[4]
#declare Players[0] = Player(1, 0.5, T_Stripe_A)
#declare Players[1] = Player(0.5, 0.3, T_Stripe_A)
#declare Players[2] = Player(1.2, 0.7, T_Glass)
#declare Players[3] = Player(0.35, 0.25, T_Glass)
#macro Put(Team, X, Z, Turn)
  object {
    Players[2*mod(Team, 2)+Pick(2)]
    #if (Team = 0) texture { Bright_Textures[0] } #end
    #if (Team = 1) texture { Bright_Textures[3] } #end
    #if (Team = 2) texture { Bright_Textures[2] } #end
    #if (Team = 3) texture { Bright_Textures[4] } #end
    rotate y*Turn scale 1.12 translate <X, 0.02, Z>
  }
#end
Put(0, 38.6, 0.8, 8)                      // the striker, running up
Put(2, 52.1, -0.5, 180)                   // the keeper
Put(3, 43.5, 11.5, 200)                   // the referee
#declare Red_Team = array[8][2] { {33.4, -7.5}, {34.6, 6.8}, {32.2, 2.4}, {31.8, -12}, {34.6, 15}, {22, -3},
  {12, 14}, {8, -16} }
#declare White_Team = array[9][2] { {33.0, -5.6}, {34.2, -10.2}, {33.4, 8.7}, {31.5, 5.2}, {33.8, 12.6},
  {35, 17.8}, {26, 4}, {16, -10}, {14, 9} }
#for (I, 0, 7) Put(0, Red_Team[I][0], Red_Team[I][1], 30*(rand(S)-0.5)) #end
#for (I, 0, 8) Put(1, White_Team[I][0], White_Team[I][1], 40*(rand(S)-0.5)) #end
Put(0, -38, 0, 0) Put(1, -12, 3, 10)
sphere { <41.5, 0.16, 0>, 0.2 pigment { srgb 1 } finish { F_Matt } }
#for (I, 0, 13) Put(2-2*int(I/7), -21+1.1*I+5*(I > 6), -38, 90) #end   // substitutes on the touchline
#for (I, 0, 5) Put(3, 56.6, -30+12*I, 0) #end                             // photographers behind the goal

// ---- stands: rows of seats, a crowd in them, a roof on girders ----

// A row of the crowd as one mesh: shoulders and heads, scarves; colours from two clubs.
#declare T_Crowd = array[10]
#declare Crowd_Colours = array[10] {
  <0.66, 0.05, 0.06>, <0.55, 0.06, 0.07>, <0.92, 0.90, 0.86>, <0.20, 0.24, 0.34>, <0.12, 0.13, 0.16>,
  <0.62, 0.58, 0.50>, <0.85, 0.75, 0.20>, <0.30, 0.42, 0.60>, <0.70, 0.12, 0.14>, <0.42, 0.40, 0.40>
}
#for (I, 0, 9) #declare T_Crowd[I] = Town_Plain(Crowd_Colours[I]) #end
#macro Fan(P, T)
  Brick_T(P+<-0.24, 0, -0.15>, P+<0.24, 0.62, 0.15>, T)
  Brick_T(P+<-0.11, 0.62, -0.11>, P+<0.11, 0.90, 0.11>, T_Skin)
#end
// Ten metres of stand, N rows going back along +z and up.
#macro Sector(N, Share, Red)
  mesh {
    #for (R, 0, N-1)
      #local Z = 0.85*R;  #local Y = 1.6+0.5*R;
      Quad_T(<-5, Y-0.5, Z>, <5, Y-0.5, Z>, <5, Y, Z>, <-5, Y, Z>, T_Gravel)
      Quad_T(<-5, Y, Z>, <5, Y, Z>, <5, Y, Z+0.85>, <-5, Y, Z+0.85>, T_Gravel)
      #for (K, 0, 15)
        #if (K != 8)
          #local X = -4.7+0.6*K;
          #local P = <X+0.08*(rand(S)-0.5), Y, Z+0.35>;
          #if (rand(S) < Share)
            Fan(P+y*0.25*(rand(S) < 0.2), T_Crowd[(rand(S) < Red ? int(rand(S)*1.99) : int(rand(S)*9.99))])
          #else
            Brick_T(P-<0.22, 0, 0.1>, P+<0.22, 0.4, 0.1>, T_Red)
          #end
        #end
      #end
    #end
    Quad_T(<-5, 0, 0>, <5, 0, 0>, <5, 1.6, 0>, <-5, 1.6, 0>, T_Stripe_A)
    Brick_T(<-5, 1.6, -0.1>, <5, 2.3, 0>, T_Metal)
  }
#end
#declare Sectors = array[6]
#for (I, 0, 5) #declare Sectors[I] = Sector(26, (I = 4 ? 0.72 : 0.95),
  (I < 3 ? 0.22 : (I = 3 ? 0.5 : 0.05))) #end
#macro Stand(Count, Turn, Where, First)
  union {
    #for (I, 0, Count-1)
      object { Sectors[mod(I*2+First+int(I/3), 6)] translate x*(10.05*(I-(Count-1)/2)) }
    #end
    rotate y*Turn translate Where
  }
#end
Stand(13, 0, <0, 0, 55>, 0)
Stand(7, 90, <80, 0, 0>, 3)
Stand(7, -90, <-80, 0, 0>, 4)
Stand(13, 180, <0, 0, -55>, 2)
// the corners: quarter rings
#for (C, 0, 3)
  #local P = <(mod(C, 2) ? 1 : -1)*64.5, 0, (C > 1 ? 1 : -1)*36>;
  #for (K, 0, 1)
    object { Sectors[mod(C+K, 6)] translate z*19
      rotate y*((C = 3 ? 30+32*K : (C = 2 ? -30-32*K : (C = 1 ? 118+32*K : -118-32*K)))) translate P }
  #end
#end
// roofs over the far stand and the one behind the goal
#macro Roof(L, Turn, Where)
  mesh {
    #local N = int(L/10);
    #for (I, 0, N-1)
      #local X0 = -L/2+L*I/N;  #local X1 = X0+L/N;
      Quad_T(<X0, 19.5, 1>, <X1, 19.5, 1>, <X1, 21.5, 25>, <X0, 21.5, 25>, T_Frame)
      Quad_T(<X0, 19.1, 1>, <X1, 19.1, 1>, <X1, 21.1, 25>, <X0, 21.1, 25>, T_Stripe_A)
      Quad_T(<X0, 18.6, 1>, <X1, 18.6, 1>, <X1, 19.6, 1>, <X0, 19.6, 1>, T_Red)
      Quad_T(<X0, 0, 24>, <X1, 0, 24>, <X1, 21, 25>, <X0, 21, 25>, T_Chimney)
    #end
    #for (I, 0, N)
      #local X = -L/2+L*I/N;
      Lattice(<X, 22.6, 0>, <X, 23.8, 25>, 1.0, 1.8, 9, 0.14, T_Metal)
      Lattice(<X, 0, 26>, <X, 30, 26>, 1.2, 1.0, 9, 0.16, T_Metal)
      Bar_T(<X, 30, 26>, <X, 22.8, 3>, 0.12, T_Metal)
    #end
    rotate y*Turn translate Where
  }
#end
Roof(130, 0, <0, 0, 55>)
Roof(72, 90, <80, 0, 0>)
// floodlights
#for (I, 0, 3)
  #local P = <(mod(I, 2) ? 98 : -98), 0, (I > 1 ? 76 : -70)>;
  mesh {
    Lattice(P, P+y*44, 3.4, 1.2, 14, 0.22, T_Metal)
    #for (K, 0, 5) #for (M, 0, 4) Brick_T(P+<-3+K-0.4, 42.5+1.2*M, -0.5>, P+<-3+K+0.4, 43.5+1.2*M, 0.3>,
      T_Lamp) #end #end
  }
#end
// flags along the roof's edge
#for (I, 0, 12)
  #local P = <-60+10*I, 23.5, 56>;
  mesh { Bar_T(P, P+y*5, 0.12, T_Stripe_A) Quad_T(P+y*5, P+<2.6, 4.7, 0.5>, P+<2.5, 3.1, 0.3>, P+y*3.3,
    T_Awning[mod(I, 5)]) }
#end

// ---- the quarter around it ----

Slab_Of(-500, -300, 500, 600, -0.4, T_Asphalt)
#for (J, 0, 4) #for (I, 0, 7)
  #if (J > 0 | I > 5) Closed_Block(-250+66*I, 110+56*J, -190+66*I, 156+56*J, 0.3, 1.6) #end
#end #end
#for (I, 0, 2) Closed_Block(124+66*I, -40, 184+66*I, 6, 0.3, 1.4) Closed_Block(124+66*I, 16, 184+66*I, 62,
  0.3, 1.4) #end
#for (I, 1, 110) Tree_At(<-200+420*rand(S), 0, 88+18*rand(S)>) #end
#for (I, 0, 7) Cars(<-130, 0, 84+2.6*I>, <90, 0, 84+2.6*I>, 3.4, 0.0+0.85*(I < 2), 90) #end
