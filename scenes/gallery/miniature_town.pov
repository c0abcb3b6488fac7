// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A town that looks like a model railway. The plane of sharp focus stands upright through the market
// square instead of facing the camera (reverse tilt). The street in front and the hills behind are as blurred as in a
// photograph of a small object.
//
//   ./render scenes/gallery/miniature_town.pov +W1280 +H720
//
// (./render alone makes this picture, too.)
//
// Try focus_tilt 0 (an ordinary lens), f_stop 8, or a focal_point elsewhere in the town.
//
// One unit is a metre of the town, and scene_unit makes it a model of Z scale (1:220). The camera is 1.2 m from the model,
// and this short distance makes the blur large.

#version 3.7;
#ifndef (Samples) #declare Samples = 160; #end
global_settings { assumed_gamma 1 max_trace_level 4 }
#include "town_streets.inc"

#declare Focus = <22, 3, 26>;

camera {
  perspective
  right x*image_width/image_height
  location <-80, 133, -192>
  look_at <22, 0, 26>
  angle 39
  focal_point Focus
  blur_samples Samples  confidence 0.95  variance 1/1000
  tilt_lens {
    scene_unit 1000/220
    focus_tilt -36
    f_stop 1.5
  }
}

light_source { <-150, 135, -45>*1000 color rgb <1.00, 0.91, 0.76>*2.0 parallel point_at 0 }
light_source { <40, 160, -90>*1000 color rgb <0.55, 0.72, 1.00>*0.42 parallel point_at 0 shadowless }
light_source { <-30, 60, -160>*1000 color rgb <0.60, 0.75, 1.00>*0.22 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.80, 0.88, 0.95>] [0.6 srgb <0.30, 0.55, 0.88>] } } }

// ---- the ground, from the near bank to the hills ----

Slab_Of(-330, -19, 330, 172, 0, T_Asphalt)
Slab_Of(-330, 172, 420, 480, 0.05, T_Meadow)
Slab_Of(-330, -140, 330, -54, -0.6, T_Lawn)
box { <-330, -6, -57>, <330, -3, -18> texture { T_Water } }
box { <-330, -6, -55>, <330, -0.3, -53.6> texture { T_Quay } }
box { <-330, -6, -20>, <-8, 0.9, -19> texture { T_Quay } }
box { <8, -6, -20>, <330, 0.9, -19> texture { T_Quay } }

// ---- the river: a bridge of three arches, boats ----

difference {
  box { <-8, -6, -58>, <8, 0, -18> }
  #for (I, 0, 2) cylinder { <-9, -3.6, -49.5+12*I>, <9, -3.6, -49.5+12*I>, 3.1 } #end
  texture { T_Quay }
}
box { <-6, 0, -70>, <6, 0.03, -18> texture { T_Asphalt } }
#for (Side, -1, 1, 2)
  box { <Side*6, 0, -70>, <Side*7.6, 0.2, -19> texture { T_Pavement } }
  box { <Side*7.6, 0, -58>, <Side*8, 1.1, -18.5> texture { T_Quay } }
  #for (U, -56, -20, 12) Lamp_At(<Side*7.4, 0.2, U>) #end
#end
#for (I, 1, 14) Person_At(<(rand(S) < 0.5 ? -6.8 : 6.8), 0.2, -20-36*rand(S)>) #end
object {
  Boat(Paint_Textures[3]) texture { Paint_Textures[1] }
  scale 1.3 rotate y*8 translate <24, -3.2, -33>
}
object {
  Boat(Paint_Textures[2]) texture { Paint_Textures[0] }
  rotate y*-4 translate <-24, -3.2, -24>
}
object { Boat(T_Timber) texture { Paint_Textures[5] } rotate y*184 translate <42, -3.2, -23> }
object {
  Boat(Paint_Textures[3]) texture { Paint_Textures[7] }
  rotate y*170 translate <-38, -3.2, -42>
}
object { Boat(T_Timber) texture { Paint_Textures[3] } rotate y*2 translate <66, -3.2, -24> }
#for (I, 1, 40) Tree_At(<-110+220*rand(S), -0.6, -60-22*rand(S)>) #end

// ---- streets: markings, crossings, traffic ----

#declare Street_X = array[3] { -75, 75, 140 }
#declare Street_Z = array[2] { 50, 108 }
#for (I, 0, 1) Dashes(-140, 210, Street_Z[I], no) #end
#for (I, 0, 2) Dashes(-8, 160, Street_X[I], yes) #end
Dashes(-140, 210, -14, no)
#for (I, 0, 1)
  #declare Z = Street_Z[I];
  Zebra(<0, 0, Z-8.5>, 15, yes)
  Zebra(<0, 0, Z+8>, 15, yes)
  Zebra(<-10.5, 0, Z>, 9, no)
  Zebra(<10.5, 0, Z>, 9, no)
  Zebra(<75, 0, Z-7.5>, 8, yes)
  Zebra(<68, 0, Z>, 9, no)
#end
Zebra(<0, 0, -7>, 15, yes)
Zebra(<11, 0, -14>, 9, no)
Zebra(<-11, 0, -14>, 9, no)
Zebra(<40, 0, -14>, 9, no)

// the avenue: tram track between two lanes
box { <-3.2, 0, -70>, <3.2, 0.04, 176> texture { T_Pavement } }  // above the asphalt of the bridge
#for (I, 0, 3)
  #declare X = -2.35+1.44*mod(I, 2)+3.26*int(I/2);
  box { <X-0.08, 0, -70>, <X+0.08, 0.05, 176> texture { T_Rail } }
#end
#for (I, 0, 1)
  object { Thing_Tram texture { Paint_Textures[0] } rotate y*-90 translate <1.63, 0.03, 4-13.4*I> }
  object { Thing_Tram texture { Paint_Textures[2] } rotate y*90 translate <-1.63, 0.03, 88-13.4*I> }
#end
Cars(<5.2, 0, -50>, <5.2, 0, 160>, 11, 0.5, -90)
Cars(<-5.2, 0, -50>, <-5.2, 0, 160>, 11, 0.5, 90)
object { Thing_Bus texture { Paint_Textures[8] } rotate y*-90 translate <5.4, 0, 66> }

Cars(<-140, 0, -16.4>, <-14, 0, -16.4>, 12, 0.5, 0)
Cars(<31, 0, -16.4>, <200, 0, -16.4>, 12, 0.5, 0)
Cars(<-140, 0, -11.6>, <-14, 0, -11.6>, 13, 0.45, 180)
Cars(<16, 0, -11.6>, <45, 0, -11.6>, 13, 0.6, 180)
Cars(<64, 0, -11.6>, <200, 0, -11.6>, 13, 0.5, 180)
object { Thing_Lorry texture { Paint_Textures[7] } translate <23, 0, -16.5> }
object { Thing_Bus texture { Paint_Textures[0] } rotate y*180 translate <53, 0, -11.5> }
#for (I, 0, 1)
  #declare Z = Street_Z[I];
  Cars(<-140, 0, Z-2.4>, <-14, 0, Z-2.4>, 11, 0.45, 0)
  Cars(<14, 0, Z-2.4>, <205, 0, Z-2.4>, 12, 0.5, 0)
  Cars(<14, 0, Z+2.4>, <205, 0, Z+2.4>, 12, 0.5, 180)
#end
object { Thing_Bus texture { Paint_Textures[2] } translate <34, 0, 47.4> }
#for (I, 0, 2)
  Cars(<Street_X[I]+2.2, 0, 0>, <Street_X[I]+2.2, 0, 160>, 12, 0.45, -90)
  Cars(<Street_X[I]-2.2, 0, 0>, <Street_X[I]-2.2, 0, 160>, 12, 0.45, 90)
#end

// ---- blocks ----

Closed_Block(-136, -9, -79.5, 44.5, 0.5, 1.2)
Closed_Block(-70.5, -9, -8, 44.5, 0.55, 1.4)
Closed_Block(-70.5, 55.5, -8, 103.5, 0.5, 1.6)
Closed_Block(-70.5, 112.5, -8, 160.5, 0.4, 1)
Closed_Block(8, 55.5, 70.5, 103.5, 0.9, 1.8)
Closed_Block(8, 112.5, 70.5, 160.5, 0.4, 1.2)
Closed_Block(79.5, 55.5, 135.5, 103.5, 0.5, 1.2)
Gardens(79.5, 112.5, 135.5, 160.5, 3, 2)
Gardens(144.5, 0, 205, 44.5, 3, 2)
Gardens(144.5, 55.5, 205, 103.5, 3, 2)
Gardens(144.5, 112.5, 205, 160.5, 3, 2)
Gardens(-140, 112.5, -79.5, 160.5, 3, 2)

// ---- market square ----

Pavement(8, -9, 70.5, 44.5)
box { <10.5, 0, -6.5>, <68, 0.22, 42> texture { T_Cobbles } }
Street_Front(8, -9, 70.5, 44.5)

// Pointed window of a church wall.
#macro Church_Window(P, R, N, W, H)
  Panel(P-R*0.25, R, N, W+0.5, H, 0.05, T_Frame)
  triangle { P-R*0.25+y*H+N*0.05, P+R*(W+0.25)+y*H+N*0.05, P+R*W/2+y*(H+1.6)+N*0.05 texture { T_Frame } }
  Panel(P, R, N, W, H, 0.1, T_Glass)
  triangle { P+y*H+N*0.1, P+R*W+y*H+N*0.1, P+R*W/2+y*(H+1.2)+N*0.1 texture { T_Glass } }
#end
#declare Church = union {
  mesh {
    Brick(<0, 0, 0>, <26, 9, 11>)
    triangle { <0, 9, 0>, <0, 9, 11>, <0, 17.4, 5.5> }
    triangle { <26, 9, 0>, <26, 9, 11>, <26, 17.4, 5.5> }
    Quad_T(<-0.4, 8.5, -0.5>, <26.5, 8.5, -0.5>, <26.5, 17.7, 5.5>, <-0.4, 17.7, 5.5>, T_Slate)
    Quad_T(<-0.4, 8.5, 11.5>, <26.5, 8.5, 11.5>, <26.5, 17.7, 5.5>, <-0.4, 17.7, 5.5>, T_Slate)
    #for (I, 0, 4)
      Church_Window(<2.2+5.2*I, 2, 0>, x, -z, 1.8, 4.2)
    #end
    #for (I, 0, 5) Brick(<-0.3+5.2*I, 0, -1.1>, <0.6+5.2*I, 6.5, 0>) #end
    Brick(<-7, 0, 2>, <0, 25, 9>)
    #for (I, 0, 1)
      Church_Window(<-4.3, 4+7*I, 2>, x, -z, 1.6, 2.6)
      Church_Window(<-7, 4+7*I, 6.3>, -z, -x, 1.6, 2.6)
    #end
    #for (I, 1, 3) Brick_T(<-7.25, 8.2*I, 1.75>, <0.25, 8.2*I+0.4, 9.25>, T_Frame) #end
    #for (I, 0, 1)   // clock
      #local R = (I ? -z : x);  #local N = (I ? -x : -z);
      #local P = (I ? <-7, 18.8, 5.5> : <-3.5, 18.8, 2>);
      Panel(P-R*1.8-y*1.8, R, N, 3.6, 3.6, 0.1, T_Glass)
      Panel(P-R*1.6-y*1.6, R, N, 3.2, 3.2, 0.15, T_Frame)
      Panel(P-R*0.15, R, N, 0.3, 1.4, 0.2, T_Glass)
      Panel(P-y*0.15, R, N, 1.0, 0.3, 0.2, T_Glass)
    #end
    #local A = <-7.5, 25, 1.5>;  #local B = <0.5, 25, 1.5>;
    #local C = <0.5, 25, 9.5>;  #local D = <-7.5, 25, 9.5>;
    #local M = <-3.5, 44, 5.5>;
    Quad_T(A, B, C, D, T_Frame)
    triangle { A, B, M texture { T_Copper } }
    triangle { B, C, M texture { T_Copper } }
    triangle { C, D, M texture { T_Copper } }
    triangle { D, A, M texture { T_Copper } }
    texture { T_Stone }
  }
  cylinder { <-3.5, 43, 5.5>, <-3.5, 47, 5.5>, 0.15 }
  sphere { <-3.5, 45.4, 5.5>, 0.5 }
  texture { Paint_Textures[2] }
}
object { Church translate <36, 0.2, 25> }

// stalls in two rows, a fountain, a café
#declare Stalls = array[5]
#declare Parasols = array[5]
#for (I, 0, 4)
  #declare Stalls[I] = Market_Stall(T_Awning[I])
  #declare Parasols[I] = Parasol(T_Awning[I])
#end
#for (I, 0, 11)
  object {
    Stalls[mod(I*3+int(I/6), 5)]
    rotate y*4*(rand(S)-0.5) translate <31+5.6*mod(I, 6), 0.22, 3+7.5*int(I/6)>
  }
#end
union {
  cylinder { 0, y*0.7, 3.4 texture { T_Stone } }
  cylinder { y*0.5, y*0.75, 3.0 texture { T_Water } }
  cone { y*0.5, 0.7, y*3, 0.35 texture { T_Stone } }
  cylinder { y*2.6, y*2.9, 1.3 texture { T_Stone } }
  sphere { y*3.4, 0.5 texture { T_Copper } }
  translate <19.5, 0.2, 11>
}
#for (I, 0, 9)
  object {
    Parasols[mod(I, 5)]
    rotate y*360*rand(S) translate <13+3.4*mod(I, 5), 0.22, 33+4*int(I/5)> + Around(0.4)
  }
#end
#for (I, 1, 130)
  #declare P = <12+54*rand(S), 0.22, -4+26*rand(S)>;
  #if (vlength(P-<19.5, 0.22, 11>) > 4) Person_At(P) #end
#end
#for (I, 1, 20) Person_At(<12+16*rand(S), 0.22, 30+11*rand(S)>) #end
#for (I, 0, 8) Tree_At(<13+6.6*I, 0.2, -5>) #end
#for (I, 0, 3)
  Tree_At(<66.5, 0.2, 6+9*I>)
  object { Thing_Bench rotate y*90 translate <64, 0.22, 10+9*I> }
#end
#for (I, 0, 3) object { Thing_Bench translate <16+2.4*I, 0.22, 5> } #end

// ---- park ----

box { <79.5, -1, -9>, <135.5, 0.15, 44.5> texture { T_Lawn } }
Hedge(<80.2, 0.15, -8>, <80.2, 0.15, 44>)
Hedge(<80.2, 0.15, -8.2>, <134, 0.15, -8.2>)
cylinder { <104, 0, 16>, <104, 0.2, 16>, 13 texture { T_Sand } }
cylinder { <104, 0, 16>, <104, 0.24, 16>, 10.5 texture { T_Water } }
box { <80, 0, 15>, <92, 0.19, 18> texture { T_Sand } }
box { <102, 0, -8>, <105, 0.19, 4> texture { T_Sand } }
box { <102, 0, 28>, <105, 0.19, 44> texture { T_Sand } }
#for (I, 1, 46)
  #declare P = <83+50*rand(S), 0.15, -5+46*rand(S)>;
  #declare Q = (P-<104, 0, 16>)*(x+z);
  #if (vlength(Q) > 16) Tree_At(P) #else Person_At(<104, 0.2, 16>+vnormalize(Q)*11.8) #end
#end
#for (I, 1, 40) Bush_At(<81+54*rand(S), 0.15, (rand(S) < 0.5 ? -6 : 42)+2*rand(S)>) #end

// ---- railway, station, woods ----

box { <-330, 0, 175>, <420, 0.5, 188> texture { T_Ballast } }
#for (I, 0, 3)
  #declare Z = 177.8+1.5*mod(I, 2)+5*int(I/2);
  box { <-330, 0.5, Z-0.1>, <420, 0.75, Z+0.1> texture { T_Rail } }
#end
#for (U, -140, 300, 1.6)
  #for (I, 0, 1) box { <U, 0.4, 177.2+5*I>, <U+0.6, 0.6, 180+5*I> texture { T_Beam } } #end
#end
#for (I, 0, 5)
  object {
    Thing_Carriage texture { Paint_Textures[(I = 5 ? 4 : 0)] }
    translate <4+17.8*I, 0.7, 178.6>
  }
#end
object {
  House(30, 9, 2, HOUSE_HIP, no, Roof_Textures[1], S) Town_Plain(<0.80, 0.42, 0.28>)
  translate <22, 0, 163>
}
#for (U, -140, 260, 28)
  cylinder { <U, 0, 181.2>, <U, 8, 181.2>, 0.15 texture { T_Iron } }
  box { <U-0.1, 7.2, 177.8>, <U+0.1, 7.4, 184.6> texture { T_Iron } }
#end
#for (I, 1, 420)
  #declare P = <-130+450*rand(S), 0, 196+90*rand(S)>;
  #if (rand(S) < 0.55) Conifer_At(P) #else Tree_At(P) #end
#end
