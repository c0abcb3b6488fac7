// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A fishing harbour on a summer evening, as a model on a table. Tilt_Lens_Miniature writes the whole block from the
// camera's place, the subject and one number, the strength of the blur.
//
//   ./render scenes/gallery/miniature_harbour.pov +W1280 +H720
//
// Try: Declare=Strength=0.4 for less blur, 2 for a toy, 0.02 for a photograph of a real harbour.
//
// One unit is a metre. The water lies at y = -3, the quays at y = 0.

#version 3.7;
#ifndef (Samples) #declare Samples = 160; #end
#ifndef (Strength) #declare Strength = 1; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "tilt_lens.inc"
#include "town_streets.inc"
#include "harbour_things.inc"

#declare Eye = <-92, 92, -128>;
#declare Subject = <2, 2, 4>;
camera {
  perspective
  right x*image_width/image_height
  location Eye
  look_at Subject+<2, 0, 6>
  angle 37
  blur_samples Samples  confidence 0.95  variance 1/4000
  Tilt_Lens_Miniature(Eye, Subject, Strength)
}

// ---- an hour before sunset ----

light_source { <-190, 78, 10>*1000 rgb <1.00, 0.74, 0.46>*2.5 parallel point_at 0 }
light_source { <40, 160, -90>*1000 rgb <0.50, 0.66, 1.00>*0.40 parallel point_at 0 shadowless }
light_source { <-30, 40, -160>*1000 rgb <0.66, 0.74, 1.00>*0.20 parallel point_at 0 shadowless }
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.95, 0.72, 0.48>] [0.2 rgb <0.55, 0.62, 0.68>] [0.6 rgb <0.16, 0.32, 0.55>] }
  }
}
#declare Sea = texture {
  pigment { rgb <0.012, 0.075, 0.085> }
  normal { average normal_map { [1 bumps 0.5 scale <2.6, 1, 1.4>]
    [1 bumps 0.35 scale <0.7, 1, 0.5> rotate y*30] } }
  finish { ambient 0 diffuse 0.5 specular 0.7 roughness 0.01 reflection { 0.05, 0.65 falloff 3 } }
}
plane { y, -3 texture { Sea } }

// ---- quays: a basin open to the left, a mole with its lighthouse ----

#declare T_Wall = texture {
  pigment {
    brick srgb <0.40, 0.36, 0.31>, srgb <0.62, 0.56, 0.48> brick_size <1.6, 0.7, 1> mortar 0.08
  }
  finish { F_Matt }
}
#macro Quay(X0, Z0, X1, Z1)
  box { <X0, -6, Z0>, <X1, -0.1, Z1> texture { T_Wall } }
  box { <X0-0.25, -0.35, Z0-0.25>, <X1+0.25, 0, Z1+0.25> texture { T_Quay } }
  box { <X0+1, -0.3, Z0+1>, <X1-1, 0.06, Z1-1> texture { T_Cobbles } }
#end
Quay(-20, 30, 160, 200)        // the town
Quay(48, -60, 160, 60)         // the right-hand quay
Quay(-140, 62, 0, 200)
Quay(-62, -34, -54, 2)         // the mole
Quay(-62, -34, 8, -27)
object { Lighthouse scale 0.9 translate <-57.6, 0, -1.8> }
// tyres as fenders, ladders, bollards
mesh {
  #for (X, -16, 44, 5) Ball_Pieces_T(<X, -1.3, 29.6>, <0.55, 0.55, 0.25>, T_Tyre) #end
  #for (Z, -54, 26, 5) Ball_Pieces_T(<47.6, -1.3, Z>, <0.25, 0.55, 0.55>, T_Tyre) #end
  #for (X, -18, 46, 6) Stem_T(<X, 0, 31.4>, 8, 0, 0.3, 0.8, 0.4, T_Iron) #end
  #for (Z, -56, 26, 6) Stem_T(<49.4, 0, Z>, 8, 0, 0.3, 0.8, 0.4, T_Iron) #end
  #for (X, -50, 4, 6) Stem_T(<X, 0, -28>, 8, 0, 0.3, 0.8, 0.4, T_Iron) #end
  #for (I, 0, 5) #for (K, 0, 9)
    Bar_T(<-9+11*I, -3+0.35*K, 29.55>, <-8.4+11*I, -3+0.35*K, 29.55>, 0.09, T_Metal)
  #end #end
}
#declare Planks = array[2]
#declare Planks[0] = T_Deck  #declare Planks[1] = T_Timber
// a jetty of planks on piles, with fingers
#macro Jetty(A, L, Turn)
  mesh {
    #for (I, 0, int(L/0.5)-1)
      Brick_T(<I*0.5, 0, -1.3-0.1*rand(S)>, <I*0.5+0.44, 0.12+0.03*rand(S), 1.3+0.1*rand(S)>,
        Planks[Pick(2)])
    #end
    #for (I, 0, int(L/6)) #for (Side, -1, 1, 2)
      Stem_T(<I*6+0.3, 0, 1.45*Side>, 8, -4, 0.22, 1.1, 0.2, T_Beam)
      Stem_T(<I*6+0.3, 0, 1.45*Side>, 8, 1.1, 0.23, 1.2, 0.1, T_Frame)
    #end #end
    rotate y*Turn translate A
  }
#end
Jetty(<7, -1.2, 29.8>, 44, 90)
Jetty(<27, -1.2, 29.8>, 36, 90)

// ---- boats ----

#declare Covers = array[3]
#declare Covers[0] = T_Sail  #declare Covers[1] = T_Canvas  #declare Covers[2] = T_Net
#declare Yachts = array[4]
#for (I, 0, 3) #declare Yachts[I] = Yacht(8.5+1.5*I, Covers[mod(I, 3)]) #end
#declare Hulls = array[6]
#declare Hull_Colours = array[6] {
  <0.95, 0.94, 0.90>, <0.10, 0.20, 0.38>, <0.93, 0.92, 0.88>, <0.55, 0.09, 0.08>, <0.10, 0.34, 0.32>,
    <0.96, 0.95, 0.93>
}
#for (I, 0, 5)
  #declare Hulls[I] = texture { pigment { srgb Hull_Colours[I] } finish { ambient 0.05 diffuse 0.8 specular
    0.4 roughness 0.02 reflection 0.03 } }
#end
#for (I, 0, 6)
  object { Yachts[Pick(4)] texture { Hulls[Pick(6)] } rotate y*(180+5*(rand(S)-0.5))
    rotate x*2*(rand(S)-0.5) translate <13.8, -3, -11+5.2*I> }
  #if (I != 2)
    object { Yachts[Pick(4)] texture { Hulls[Pick(6)] } rotate y*4*(rand(S)-0.5) rotate x*2*(rand(S)-0.5)
      translate <20.4, -3, -4.5+5.2*I> }
  #end
  #if (I > 0)
    object { Yachts[Pick(4)] texture { Hulls[Pick(6)] } rotate y*(180+4*(rand(S)-0.5))
      translate <33.6, -3, -4+5.2*I> }
  #end
#end
#declare Trawlers = array[3]
#declare Trawlers[0] = Trawler(17, T_Frame, S)
#declare Trawlers[1] = Trawler(21, T_Awning[3], S)
#declare Trawlers[2] = Trawler(15, T_Frame, S)
object { Trawlers[0] texture { Hulls[3] } rotate y*180 translate <-8, -3, 26.2> }
object { Trawlers[2] texture { Hulls[4] } rotate y*3 translate <-7, -3, 20.6> }
object { Trawlers[1] texture { Hulls[1] } rotate y*90 translate <43.6, -3, -6> }
object { Trawlers[0] texture { Hulls[4] } rotate y*-90 translate <43.8, -3, -30> }
object { Trawlers[2] texture { Hulls[3] } rotate y*-14 translate <-30, -3, 9> }       // coming in
#for (I, 1, 14)   // its wake
  #for (Side, -1, 1, 2)
    sphere { 0, 1 scale <1.5+0.05*I, 0.05, 0.25+0.03*I> rotate y*(-14+16*Side)
      translate <-30, -2.99, 9>+vrotate(<5-1.25*I, 0, Side*(1.8+0.30*I)>, y*-14)
             pigment { rgbt <0.7, 0.82, 0.82, 0.55+0.03*I> } finish { ambient 0.05 diffuse 0.8 } }
  #end
#end
object { Trawlers[1] texture { Hulls[3] } rotate y*2 translate <-24, -3, -23.5> }
#declare Rowing_Boat = Dinghy()
#for (I, 0, 9)
  object { Rowing_Boat texture { Paint_Textures[Pick(9)] } rotate y*(80+30*(rand(S)-0.5))
    translate <-46+3.4*I, -3, 57.4+2*rand(S)> }
#end
#for (I, 0, 3) object { Rowing_Boat texture { Paint_Textures[Pick(9)] } rotate y*360*rand(S)
  translate <-44+11*I+4*rand(S), -3, 34+12*rand(S)> } #end
object { Yachts[3] texture { Hulls[0] } rotate y*28 translate <-62, -3, 30> }
object { Yachts[2] texture { Hulls[1] } rotate y*-20 translate <-84, -3, -14> }
object { Yachts[1] texture { Hulls[3] } rotate y*-160 translate <-20, -3, -56> }
object { Trawlers[0] texture { Hulls[1] } rotate y*170 translate <22, -3, -50> }
#for (I, 1, 24)   // mooring buoys
  sphere { <-48+46*rand(S), -2.85, 8+44*rand(S)>, 0.35 texture { T_Orange } }
#end

// ---- on the quays ----

object { Quay_Crane(T_Awning[1], 150, 48) translate <56, 0.1, -18> }
object { Quay_Crane(T_Yellow, 70, 34) translate <56, 0.1, -46> }
#for (I, 0, 1) box { <52.7+6.8*I-0.1, 0, -60>, <52.7+6.8*I+0.1, 0.16, 28> texture { T_Rail } } #end
#declare Stuff = array[4]
#for (I, 0, 3) #declare Stuff[I] = Quay_Stuff(S) #end
#for (I, 0, 10) object { Stuff[mod(I, 4)] rotate y*360*rand(S) translate <-17+6*I, 0.06, 33.4+1.6*rand(S)> }
  #end
#for (I, 0, 8) object { Stuff[mod(I, 4)] rotate y*360*rand(S) translate <50.8, 0.06, -56+9*I> } #end
#for (I, 0, 5) object { Stuff[mod(I, 4)] rotate y*90*rand(S) translate <-44+9*I, 0.06, -30.2> } #end
#for (I, 1, 70) Person_At(<-18+64*rand(S), 0.06, 32.5+7*rand(S)>) #end
#for (I, 1, 14) Person_At(<-52+58*rand(S), 0.06, -29-3*rand(S)>) #end
#for (I, 1, 10) Person_At(<(rand(S) < 0.5 ? 7 : 27)+1.6*(rand(S)-0.5), -1.05, 28-36*rand(S)>) #end
#for (I, 1, 14) Person_At(<52+8*rand(S), 0.06, 26-60*rand(S)>) #end
#for (I, 0, 6) Lamp_At(<-16+10*I, 0.06, 37>) #end
Cars(<-18, 0.06, 40>, <150, 0.06, 40>, 8, 0.55, 0)
Cars(<64, 0.06, -50>, <64, 0.06, 26>, 9, 0.5, -90)
object { Thing_Lorry texture { Paint_Textures[1] } rotate y*90 translate <60, 0.1, 6> }
object { Thing_Van texture { Paint_Textures[3] } rotate y*30 translate <20, 0.06, 35.5> }
// fishermen's sheds and stores on the right-hand quay, with goods in between
#macro Store(X, Z, W, D, C)
  object {
    House(W, D, 1+int(rand(S)*1.99), HOUSE_GABLE, no, Roof_Textures[Pick(7)], S) Town_Plain(C)
    rotate y*90 translate <X, 0.06, Z>
  }
#end
#for (I, 0, 6) Store(69, -48+11.5*I, 10.5, 15,
  (mod(I, 2) ? <0.52, 0.13, 0.10> : <0.60, 0.20, 0.14>)*(0.9+0.3*rand(S))) #end
#for (I, 0, 5) Store(90, -52+12.5*I, 11.5, 17, <0.70, 0.60, 0.46>*(0.8+0.3*rand(S))) #end
#for (I, 0, 8)
  object { Parasol(T_Awning[mod(I, 5)]) translate <-15+3.3*I+rand(S), 0.06, 36.6+2*(rand(S))> }
#end

// ---- the town behind ----

#macro Row_Of_Houses(X0, X1, Z)
  Terrace(<X0, 0.06, Z>, 0, X1-X0, 0.7, 2.0)
#end
Row_Of_Houses(-18, 47, 43.5)
Row_Of_Houses(-18, 47, 63)
Row_Of_Houses(-18, 47, 80)
Row_Of_Houses(52, 118, 48)
Row_Of_Houses(52, 118, 68)
Row_Of_Houses(-80, -24, 70)
Row_Of_Houses(-80, -24, 88)
Row_Of_Houses(-80, 120, 106)
#for (I, 1, 40) Tree_At(<-100+230*rand(S), 0, 57+5*rand(S)+(rand(S) < 0.5 ? 20 : 0)>) #end
box { <-400, -4, 122>, <500, 0.2, 900> texture { T_Meadow } }
#for (I, 1, 11)
  sphere { 0, 1 scale <60+50*rand(S), 12+14*rand(S), 40+20*rand(S)> translate <-160+40*I, -2,
    170+60*rand(S)> texture { T_Meadow } }
#end
#for (I, 1, 240)
  #if (rand(S) < 0.5) Conifer_At(<-150+420*rand(S), 0.2, 122+70*rand(S)>) #else
    Tree_At(<-150+420*rand(S), 0.2, 122+60*rand(S)>) #end
#end
