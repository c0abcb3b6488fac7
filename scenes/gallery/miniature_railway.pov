// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// An express train leaves a station. Three points define the plane of sharp focus: the engine's buffers, the last coach,
// and a point at the height of a chimney above the track between them. The plane stands upright along the train, and the
// blur on both sides of it makes the station look like a model.
//
//   ./render scenes/gallery/miniature_railway.pov +W1280 +H720
//
// Try: points on the goods train (radius 138); Declare=Stop=4; no focal_points.
//
// One unit is a metre, scene_unit 1000/87 is the scale H0. All tracks are circles about the origin.

#version 3.7;
#ifndef (Samples) #declare Samples = 160; #end
#ifndef (Stop) #declare Stop = 1.4; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "town_streets.inc"
#include "railway_things.inc"

#declare Main = 150;                            // radius of the express's track
#declare Head = -10;  #declare Tail = 25;       // where it is, in degrees
camera {
  perspective
  right x*image_width/image_height
  location <-48, 40, 62>
  look_at Rail_At(Main, -3.5)+<0, 0, -3>
  angle 36
  blur_samples Samples  confidence 0.95  variance 1/5000
  tilt_lens {
    scene_unit 1000/87
    f_stop Stop
    focal_points Rail_At(Main, Head-3)+y*1, Rail_At(Main, Tail)+y*1, Rail_At(Main, 0)+y*5
  }
}

light_source { <-130, 84, -30>*1000 rgb <1.00, 0.80, 0.54>*2.4 parallel point_at 0 }
light_source { <60, 160, -90>*1000 rgb <0.52, 0.68, 1.00>*0.40 parallel point_at 0 shadowless }
light_source { <-30, 50, -160>*1000 rgb <0.62, 0.74, 1.00>*0.20 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.92, 0.84, 0.70>] [0.4 srgb <0.50, 0.66, 0.84>] } }
  }
#declare S = seed(141);

// ---- the ground ----

#declare Heath = texture {
  pigment {
    granite turbulence 0.3
    color_map { [0.15 srgb <0.24, 0.40, 0.11>] [0.5 srgb <0.40, 0.52, 0.17>] [0.75 srgb <0.58, 0.56, 0.27>]
      [0.95 srgb <0.50, 0.42, 0.26>] }
    scale 22
  }
  finish { F_Matt }
}
box { <-600, -2, -300>, <600, -0.35, 700> texture { Heath } }
#declare Stones = texture {
  pigment { granite color_map { [0.2 srgb <0.34, 0.30, 0.27>] [0.5 srgb <0.50, 0.45, 0.40>]
    [0.8 srgb <0.64, 0.58, 0.51>] } scale 1.4 }
  finish { F_Matt }
}
Ballast(131, 156.5, -75, 75, Stones)
Ballast(164.5, 172, -75, 75, Stones)

// ---- tracks, with their turnouts ----

#declare Radii = array[6] { 133.2, 138, 145.2, 150, 154.6, 168.2 }
#for (I, 0, 5) Track(Radii[I], Radii[I], -75, 75) #end
Track(145.2, 150, -16, -4) Track(150, 154.6, -31, -19) Track(154.6, 150, 4, 16)
Track(138, 133.2, -20, -8) Track(145.2, 138, -34, -20) Track(150, 145.2, 14, 27)
Platform(157, 163.4, -30, 60, T_Pavement)

// ---- trains ----

#macro On_Track(What, R, A) object { What rotate y*A translate Rail_At(R, A) } #end
#declare Metre = 180/pi/Main;                   // degrees of a metre on the main track
#declare Livery = array[3]
#declare Livery[0] = texture { pigment { srgb <0.46, 0.055, 0.075> } finish { ambient 0.05 diffuse 0.75
  specular 0.5 roughness 0.02 reflection 0.03 } }
#declare Livery[1] = texture { pigment { srgb <0.10, 0.17, 0.33> } finish { ambient 0.05 diffuse 0.75
  specular 0.5 roughness 0.02 reflection 0.03 } }
#declare Livery[2] = texture { pigment { srgb <0.20, 0.33, 0.22> } finish { ambient 0.05 diffuse 0.75
  specular 0.5 roughness 0.02 reflection 0.03 } }
#declare Coach_A = Express_Coach(22, T_Stripe_A, T_Metal)
#declare Coach_B = Express_Coach(22, T_Canvas, T_Concrete)
On_Track(object { Thing_Engine rotate y*180 }, Main, Head)
#for (I, 0, 4)
  On_Track(object { Coach_A texture { Livery[(I = 3 ? 1 : 0)] } }, Main, Head+(26.2+23*I)*Metre)
#end
// at the platform: a local train
#for (I, 0, 3) On_Track(object { Coach_B texture { Livery[2] } }, 154.6, -24+8.7*I+26) #end
#for (I, 0, 4) On_Track(object { Coach_A texture { Livery[1] } }, 168.2, -32+8*I) #end
// goods
#macro Goods(R, A, Kind, C)
  object {
    #switch (Kind) #case (0) Wagon_Box #break #case (1) Wagon_Tank #break #case (2) Wagon_Coal #break #else
      Wagon_Logs #end
    texture { Town_Body[C] } rotate y*A translate Rail_At(R, A)
  }
#end
#declare Town_Body = array[4]
#declare Town_Body[0] = Town_Plain(<0.42, 0.20, 0.13>)
#declare Town_Body[1] = Town_Plain(<0.50, 0.27, 0.17>)
#declare Town_Body[2] = Town_Plain(<0.30, 0.32, 0.33>)
#declare Town_Body[3] = Town_Plain(<0.22, 0.33, 0.26>)
#for (I, 0, 8) Goods(138, -6+5.1*I, mod(I*7+int(I/3), 4), Pick(4)) #end
#for (I, 0, 4) Goods(133.2, 3+5.0*I, mod(I*3+1, 4), Pick(4)) #end
#for (I, 0, 3) Goods(133.2, -26-5.0*I, mod(I, 3), Pick(4)) #end

// ---- beside the line ----

#for (I, 0, 12)
  #local A = -38+7*I;
  object { Wire_Mast(2.3) rotate y*(A-90) translate Rail_At(147.6, A) }
  #if (I < 12)
    mesh {
      #for (K, 0, 1)
        #local R = (K ? 145.25 : 149.9);
        #for (J, 0, 6)
          #local B = A+J;
          Bar_T(Rail_At(R, B)+y*5.9, Rail_At(R, B+1)+y*5.9, 0.04, T_Wire)
          Bar_T(Rail_At(R, B)+y*(6.9-0.55*sin(pi*J/7)), Rail_At(R, B+1)+y*(6.9-0.55*sin(pi*(J+1)/7)), 0.04,
            T_Wire)
          Bar_T(Rail_At(R, B)+y*5.9, Rail_At(R, B)+y*(6.9-0.55*sin(pi*J/7)), 0.025, T_Wire)
        #end
      #end
    }
  #end
  object { Wire_Mast(-2.3) rotate y*(A-90) translate Rail_At(147.6, A) }
#end
object { Semaphore(8, 42) rotate y*-20 translate Rail_At(141.6, -17) }
object { Semaphore(8, 0) rotate y*-18 translate Rail_At(141.6, -13.5) }
object { Semaphore(6, 0) rotate y*-10 translate Rail_At(135.6, -11) }
object { Semaphore(7, 42) rotate y*10 translate Rail_At(141.6, 16) }
// point levers and relay boxes
#for (I, 0, 15)
  #local P = Rail_At((mod(I, 2) ? 141.2 : 135.5), -34+4.4*I);
  mesh { Brick_T(P-<0.3, 0, 0.2>, P+<0.3, 0.9, 0.2>, T_Metal) Brick_T(P+<0.7, 0, -0.1>, P+<0.9, 1.3, 0.1>,
    T_Yellow) }
#end
// the signal box between the tracks and the road
#declare Cabin_Mesh = mesh {
  Brick_T(<-4.5, -0.5, -1.9>, <4.5, 3.0, 1.9>, T_Chimney)
  Brick_T(<-4.8, 3.0, -2.2>, <4.8, 3.2, 2.2>, T_Frame)
  Brick_T(<-4.5, 3.2, -2.0>, <4.5, 6.0, 2.0>, T_Stripe_A)
  #for (I, 0, 6) #for (Side, -1, 1, 2) Panel(<-4.3+1.25*I, 3.9, 2*Side>, x, z*Side, 1.05, 1.5, 0.04,
    T_Glass) #end #end
  #for (I, 0, 2) Panel(<4.5, 3.9, -1.8+1.25*I>, z, x, 1.05, 1.5, 0.04, T_Glass)
    Panel(<-4.5, 3.9, -1.8+1.25*I>, z, -x, 1.05, 1.5, 0.04, T_Glass) #end
  Slope(<-5.3, 5.9, -2.8>, <-3.5, 7.6, 0>, <3.5, 7.6, 0>, <5.3, 5.9, -2.8>, Roof_Textures[2])
  Slope(<-5.3, 5.9, 2.8>, <-3.5, 7.6, 0>, <3.5, 7.6, 0>, <5.3, 5.9, 2.8>, Roof_Textures[2])
  triangle { <-5.3, 5.9, -2.8>, <-5.3, 5.9, 2.8>, <-3.5, 7.6, 0> texture { Roof_Textures[2] } }
  triangle { <5.3, 5.9, -2.8>, <5.3, 5.9, 2.8>, <3.5, 7.6, 0> texture { Roof_Textures[2] } }
  #for (I, 0, 9) Brick_T(<4.6+0.3*I, -0.5, -1.9>, <4.9+0.3*I, 3.0-0.33*I, -1.0>, T_Timber) #end
}
object { Cabin_Mesh rotate y*-23 translate Rail_At(127.4, -19) }
// a water tower
mesh {
  Stem_T(<0, 0, 0>, 16, 0, 2.6, 7, 2.2, T_Chimney)
  Stem_T(<0, 0, 0>, 16, 7, 2.4, 7.4, 3.2, T_Frame)
  Stem_T(<0, 0, 0>, 16, 7.4, 3.2, 10.6, 3.2, T_Concrete)
  Stem_T(<0, 0, 0>, 16, 10.6, 3.5, 12.4, 0.2, T_Slate)
  translate Rail_At(124.5, 9)
}
// platform: people, lamps, roof, benches
#for (I, 1, 110) Person_At(Rail_At(157.8+5*rand(S), -28+80*rand(S))+y*1.1) #end
#for (I, 0, 24) Lamp_At(Rail_At(160.2, -29+3.6*I)+y*1.1) #end
#for (I, 0, 13) object { Thing_Bench rotate y*(-24+5*I) translate Rail_At(160.9, -24+5*I)+y*1.1 } #end
mesh {
  #for (I, 0, 19)
    #local A = -8+2*I;
    Quad_T(Rail_At(157.4, A)+y*5.6, Rail_At(157.4, A+2)+y*5.6, Rail_At(160.2, A+2)+y*5.0,
      Rail_At(160.2, A)+y*5.0, T_Slate)
    Quad_T(Rail_At(163.0, A)+y*5.6, Rail_At(163.0, A+2)+y*5.6, Rail_At(160.2, A+2)+y*5.0,
      Rail_At(160.2, A)+y*5.0, T_Slate)
    Quad_T(Rail_At(157.4, A)+y*5.6, Rail_At(157.4, A+2)+y*5.6, Rail_At(157.4, A+2)+y*5.3,
      Rail_At(157.4, A)+y*5.3, T_Frame)
    #if (mod(I, 3) = 0) Bar_T(Rail_At(160.2, A)+y*1.1, Rail_At(160.2, A)+y*5.2, 0.24, T_Iron) #end
  #end
}
// the station building and its square
object {
  House(36, 11, 3, HOUSE_HIP, no, Roof_Textures[1], S) Town_Plain(<0.80, 0.46, 0.30>)
  rotate y*180 rotate y*12 translate Rail_At(190, 16)
}
object { House(12, 13, 4, HOUSE_GABLE, no, Roof_Textures[1], S) Town_Plain(<0.82, 0.50, 0.33>) rotate y*12
  translate Rail_At(177, 9) }
#for (I, 0, 4) #for (J, 0, 3)
  object {
    House(11+2*rand(S), 10, 2+int(2.9*rand(S)), Pick(4), (rand(S) < 0.4), Roof_Textures[Pick(7)], S)
      Town_Plain(Wall_Colours[Pick(14)])
    rotate y*(-30+17*I) translate Rail_At(205+22*J, -28+15*I+4*rand(S))
  }
  object {
    House(11+2*rand(S), 10, 2+int(2.9*rand(S)), Pick(4), (rand(S) < 0.4), Roof_Textures[Pick(7)], S)
      Town_Plain(Wall_Colours[Pick(14)])
    rotate y*(-24+17*I) translate Rail_At(205+22*J, -20+15*I+2*rand(S))
  }
#end #end
#for (I, 1, 260) Tree_At(Rail_At(176+120*rand(S), -50+110*rand(S))) #end
#for (I, 1, 150) Conifer_At(Rail_At(285+120*rand(S), -45+90*rand(S))) #end
// this side: a road with its traffic, sheds, bushes, coal and sleepers
Ballast(114.5, 121, -75, 75, T_Asphalt)
#for (I, 0, 60)
  #local A = -45+1.5*I;
  mesh { Quad_T(Rail_At(117.7, A)+y*0.13, Rail_At(117.9, A)+y*0.13, Rail_At(117.9, A+0.8)+y*0.13,
    Rail_At(117.7, A+0.8)+y*0.13, T_Frame) }
  #if (rand(S) < 0.34) object { Thing_Car texture { Paint_Textures[Pick(9)] } rotate y*(A+180)
    translate Rail_At(116.2, A)+y*0.13 } #end
  #if (rand(S) < 0.34) object { Thing_Car texture { Paint_Textures[Pick(9)] } rotate y*A
    translate Rail_At(119.4, A)+y*0.13 } #end
#end
object { Thing_Bus texture { Paint_Textures[2] } rotate y*-8 translate Rail_At(119.4, -8)+y*0.13 }
object { House(26, 9, 1, HOUSE_EAVES, no, Roof_Textures[3], S) Town_Plain(<0.56, 0.32, 0.24>) rotate y*14
  translate Rail_At(122.5, 14) }
#for (I, 1, 130)
  #local A = -40+90*rand(S);
  Bush_At(Rail_At(122+8*pow(rand(S), 1.6), A)-y*0.3)
#end
#for (I, 1, 60) Tree_At(Rail_At(86+26*rand(S), -45+90*rand(S))-y*0.3) #end
