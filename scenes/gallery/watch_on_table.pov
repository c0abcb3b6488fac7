// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A wristwatch for a catalogue. The lens is near and its aperture wide, so that with an ordinary lens a strip of the dial
// would be sharp. Here the plane of sharp focus is the dial itself: all indices from 6 to 12 are sharp at f/1.8, and pen,
// notebook and cup are blurred.
//
//   ./render scenes/gallery/watch_on_table.pov +W1280 +H720
//
// Try: Declare=Turned_Lens=0 for an ordinary lens.
// The program reports by how much the lens is turned: 13 degrees. Most real lenses reach less; a photographer would use
// a longer lens from farther away.
//
// One unit is a millimetre (scene_unit 1). The watch lies with its dial level, at y = 9.

#version 3.7;
#ifndef (Samples) #declare Samples = 128; #end
#ifndef (Turned_Lens) #declare Turned_Lens = yes; #end
global_settings { assumed_gamma 1 max_trace_level 5 adc_bailout 0.02 }
#include "turned.inc"

#declare Dial = 9;
#declare Subject = <2, Dial, 4>;
camera {
  perspective
  right x*image_width/image_height
  location Subject+255*<-0.22, 0.62, -0.75>
  look_at Subject+<11, 0, 3>
  #if (!Turned_Lens) focal_point Subject #end
  blur_samples Samples  confidence 0.9  variance 1/4000
  tilt_lens {
    film_width 23.6
    focal_length 46
    scene_unit 1
    f_stop 1.8
    blades 9
    #if (Turned_Lens) focal_plane { y, Dial } #end
  }
}

// ---- light: a large soft box behind, its reflection, a strip from the right ----

light_source {
  <-160, 420, 330>, rgb <1.00, 0.95, 0.88>*1.55
  area_light <170, 0, 60>, <0, 90, -140>, 3, 3 adaptive 1 jitter
}
light_source { <380, 240, -160>, rgb <1.00, 0.74, 0.48>*0.30 shadowless }
light_source { <-300, 300, -260>, rgb <0.62, 0.76, 1.00>*0.14 shadowless }

#macro Panel_Light(C)
  texture { pigment { C } finish { ambient 0 diffuse 0 emission 1 } }
#end
union {
  box { <-210, 0, -150>, <210, 4, 150> Panel_Light(rgb <1.00, 0.96, 0.90>*2.6) rotate x*-42
    translate <-130, 410, 420> }
  box { <-300, 60, 0>, <320, 330, 4> 
    texture {
      pigment { gradient y color_map { [0 rgb <0.14, 0.12, 0.10>] [1 rgb <1.1, 1.02, 0.94>] } scale 330 }
      finish { ambient 0 diffuse 0 emission 1 }
    }
    rotate y*12 translate <60, 0, 520>
  }
  box { <-4, -20, -220>, <0, 200, 220> Panel_Light(rgb <1.00, 0.78, 0.52>*1.2) translate <420, 30, 40> }
  box { <-4, -10, -200>, <0, 160, 200> Panel_Light(rgb <0.55, 0.70, 1.00>*0.5) translate <-430, 40, -60> }
  no_shadow no_image
}
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb 0.01] [0.5 rgb <0.035, 0.028, 0.024>] [0.6 rgb <0.10, 0.085, 0.075>]
      [0.8 rgb <0.10, 0.10, 0.11>] [1 rgb <0.30, 0.29, 0.29>] }
    scale 2 translate -y
  }
}

// ---- materials ----

#macro Metal(C, Rough)
  texture {
    pigment { C }
    finish { ambient 0 diffuse 0.06 specular 0.8 roughness Rough metallic reflection { 0.74, 0.90 metallic }
      }
  }
#end
#declare M_Steel = Metal(rgb <0.80, 0.80, 0.82>, 0.008)
#declare M_Brushed = texture {
  pigment { rgb <0.62, 0.62, 0.64> }
  finish { ambient 0 diffuse 0.18 specular 0.6 roughness 0.05 metallic reflection { 0.35, 0.6 metallic } }
}
#declare M_Gold = Metal(rgb <0.86, 0.60, 0.30>, 0.008)
#declare M_Dial = texture {
  pigment {
    radial frequency 2
    color_map {
      [0.00 srgb <0.020, 0.070, 0.150>] [0.22 srgb <0.055, 0.185, 0.36>] [0.30 srgb <0.09, 0.27, 0.47>]
      [0.38 srgb <0.055, 0.185, 0.36>] [0.62 srgb <0.018, 0.060, 0.135>] [1.00 srgb <0.020, 0.070, 0.150>]
    }
    rotate y*38
  }
  normal { radial 0.06 frequency 240 scallop_wave }
  finish { ambient 0 diffuse 0.8 specular 0.35 roughness 0.03 reflection 0.03 }
}
#declare M_Ring = texture {
  pigment { srgb <0.03, 0.09, 0.17> }
  normal { wood 0.35 scale 0.34 rotate x*90 sine_wave }
  finish { ambient 0 diffuse 0.8 specular 0.6 roughness 0.02 reflection 0.05 }
}
#declare M_White = texture { pigment { srgb <0.93, 0.92, 0.88> } finish { ambient 0.02 diffuse 0.85 } }
#declare M_Leather = texture {
  pigment {
    granite turbulence 0.2 color_map { [0.2 srgb <0.36, 0.19, 0.09>] [0.55 srgb <0.47, 0.26, 0.12>]
      [0.9 srgb <0.53, 0.31, 0.16>] }
    scale 9
  }
  normal { average normal_map { [1 crackle 0.45 scale 0.9 turbulence 0.15] [1 granite 0.25 scale 3] } }
  finish { ambient 0 diffuse 0.75 specular 0.18 roughness 0.06 }
}
#declare M_Thread = texture { pigment { srgb <0.86, 0.78, 0.62> } finish { ambient 0 diffuse 0.85 } }
#declare M_Lacquer = texture {
  pigment { srgb <0.05, 0.03, 0.035> }
  finish { ambient 0 diffuse 0.6 specular 0.8 roughness 0.004 reflection { 0.04, 0.5 fresnel off falloff 3 }
    }
}

// ---- the watch: 12 o'clock toward +z, the crown toward +x ----

#declare Case = union {
  mesh {
    Turned_Pieces(array[16] { <14, 0.6, 0>, <16, 0.6, 0>, <17.6, 1.0, 0>, <18.6, 2.2, 0>, <18.6, 2.2, 0>,
      <19.6, 2.6, 0>,
      <19.9, 4.4, 0>, <19.6, 7.4, 0>, <19.6, 7.4, 0>, <19.1, 7.9, 0>, <19.1, 7.9, 0>, <19.0, 8.2, 0>,
        <18.4, 9.6, 0>,
      <17.4, 10.5, 0>, <17.0, 10.6, 0>, <17.0, 10.6, 0> }, 16, 4, 120)
    texture { M_Steel }
  }
  mesh {   // the slope inside, down to the dial
    Turned_Pieces(array[3] { <17.0, 10.6, 0>, <16.6, 10.2, 0>, <15.6, Dial, 0> }, 3, 3, 120)
    texture { M_Steel }
  }
  #for (I, 0, 3)
    #local SX = (mod(I, 2) ? 1 : -1);  #local SZ = (I < 2 ? 1 : -1);
    mesh {   // lugs
      Tube_Pieces(array[6] { <13.2, 4.6, 0>, <17.0, 4.8, 0>, <20.4, 4.0, 0>, <22.9, 2.2, 0>, <23.6, 1.2, 0>,
        <23.6, 1.2, 0> },
                  array[6] { <2.7, 1.25, 0>, <2.5, 1.2, 0>, <2.0, 1.15, 0>, <1.2, 1.0, 0>, <0.8, 0.8, 0>,
                    <0.0, 0.0, 0> }, 5, 24)
      texture { M_Steel }
      rotate y*-90*SZ
      translate <SX*11.6, 0.6, 0>
    }
  #end
  // crown
  difference {
    cylinder { <19.6, 5, 0>, <23.4, 5, 0>, 2.9 }
    #for (I, 0, 27) cylinder { <20.3, 0, 2.95>, <24, 0, 2.95>, 0.24 rotate x*360/28*I translate y*5 } #end
    texture { M_Steel }
  }
  sphere { 0, 1 scale <0.5, 2.6, 2.6> translate <23.35, 5, 0> texture { M_Brushed } }
}

#macro Index(Angle, R0, R1, W)
  // a facetted baton: two polished slopes
  #local H = 0.24;
  mesh {
    triangle { <-W, 0, R0>, <0, H, R0+0.35>, <0, H, R1-0.35> } triangle { <-W, 0, R0>, <0, H, R1-0.35>,
      <-W, 0, R1> }
    triangle { <W, 0, R0>, <0, H, R0+0.35>, <0, H, R1-0.35> } triangle { <W, 0, R0>, <0, H, R1-0.35>,
      <W, 0, R1> }
    triangle { <-W, 0, R0>, <W, 0, R0>, <0, H, R0+0.35> } triangle { <-W, 0, R1>, <W, 0, R1>,
      <0, H, R1-0.35> }
    texture { M_Steel }
    rotate y*Angle translate y*Dial
  }
#end
// A hand with a ridge along its middle.
#macro Hand(Angle, Length, W, Y, M)
  mesh {
    triangle { <-W*0.7, 0, -3>, <0, 0.3, -3.4>, <0, 0.42, 3> } triangle { <W*0.7, 0, -3>, <0, 0.3, -3.4>,
      <0, 0.42, 3> }
    triangle { <-W*0.7, 0, -3>, <0, 0.42, 3>, <-W, 0, 3> } triangle { <W*0.7, 0, -3>, <0, 0.42, 3>,
      <W, 0, 3> }
    triangle { <-W, 0, 3>, <0, 0.42, 3>, <0, 0.2, Length> } triangle { <W, 0, 3>, <0, 0.42, 3>,
      <0, 0.2, Length> }
    texture { M }
    rotate y*Angle translate y*(Dial+Y)
  }
#end
#macro Print(Words, Size, Where)
  #local PR_T = text { internal 1, Words, 0.02, 0 scale <Size, Size, 1> };
  object {
    PR_T
    translate -x*(max_extent(PR_T).x+min_extent(PR_T).x)/2
    rotate x*90 translate Where+y*(Dial+0.02)
    texture { M_White }
  }
#end
#declare Face = union {
  difference {
    cylinder { y*(Dial-1), y*Dial, 15.7 }
    cylinder { y*(Dial-0.35), y*(Dial+1), 3.9 translate z*-7.2 }
    box { <9.5, Dial-0.4, -1.25>, <12.7, Dial+1, 1.25> }
    texture { M_Dial }
  }
  cylinder { y*(Dial-0.9), y*(Dial-0.3), 3.95 texture { M_Ring } translate z*-7.2 }
  torus { 3.9, 0.11 texture { M_Steel } translate <0, Dial, -7.2> }
  box { <9.5, Dial-0.6, -1.25>, <12.7, Dial-0.35, 1.25> texture { M_White } }
  object {
    text { internal 1, "24", 0.02, 0 scale <2.0, 2.0, 1> } rotate x*90 translate <10.05, Dial-0.33, -0.72>
    pigment { srgb 0.02 } finish { ambient 0 }
  }
  difference {
    box { <9.2, Dial, -1.55>, <13, Dial+0.3, 1.55> }
    box { <9.6, Dial-1, -1.15>, <12.6, Dial+1, 1.15> }
    texture { M_Steel }
  }
  #for (I, 1, 11)
    #if (I != 3 & I != 6) Index(30*I, 9.4, 13.2, 0.62) #end
  #end
  Index(-4.6, 9.4, 13.2, 0.62) Index(4.6, 9.4, 13.2, 0.62) Index(180, 11.6, 13.2, 0.62)
  #for (I, 0, 59)
    box {
      <(mod(I, 5) ? -0.06 : -0.13), Dial, 13.75>, <(mod(I, 5) ? 0.06 : 0.13), Dial+0.02,
        (mod(I, 5) ? 14.6 : 15.0)>
      texture { M_White } rotate y*6*I
    }
    #if (mod(I, 5) = 0)
      cylinder { <0, Dial+0.02, 3.2>, <0, Dial-0.28, 3.55>, 0.05 texture { M_White } rotate y*6*I
        translate z*-7.2 }
    #end
  #end
  Print("SCHEIMPFLUG", 1.28, z*5.0)
  Print("AUTOMATIC", 0.78, z*3.7)
  Print("hinge rule 1904", 0.72, z*-2.6)
  Hand(-59.0+2.4, 8.6, 0.85, 0.7, M_Steel)                        // 10:08
  Hand(49.5, 13.4, 0.68, 1.25, M_Steel)
  union {
    box { <-0.09, 0, -3.6>, <0.09, 0.16, 14.2> }
    cylinder { <0, 0, -3.9>, <0, 0.16, -3.9>, 0.62 }
    cylinder { 0, y*0.25, 0.75 }
    pigment { srgb <0.85, 0.25, 0.06> } finish { ambient 0 diffuse 0.8 specular 0.4 roughness 0.02 }
    rotate y*204 translate y*(Dial+1.75)
  }
  mesh { Ball_Pieces(y*(Dial+1.9), <0.55, 0.35, 0.55>, 0, 8, 20) texture { M_Steel } }
  box { <-0.08, Dial+0.05, -0.8>, <0.08, Dial+0.14, 3.1> texture { M_White } rotate y*118 translate z*-7.2 }
  // crystal: a thin dome that only reflects
  mesh {
    Turned_Pieces(array[4] { <16.9, 10.55, 0>, <13, 11.35, 0>, <7, 11.8, 0>, <0.001, 11.95, 0> }, 4, 5, 60)
    texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 specular 0 reflection { 0.012, 0.25 falloff 4
      } } }
    no_shadow
  }
}

// One half of the strap, from the lugs down to the table and along it; with seams.
#declare Strap_Line = array[8] {
  <18.5, 4.3, 0>, <22.5, 4.2, 0>, <28, 3.0, 0>, <36, 1.9, 0>, <50, 1.8, 0>, <66, 1.8, 0>, <84, 1.8, 0>,
    <98, 1.8, 0>
}
#macro Strap_Half(Turn)
  #local U_Steps = 70;
  union {
    mesh {
      #for (I, 0, U_Steps-1)
        #local A = Curve_Point(Strap_Line, 8, 7*I/U_Steps);
        #local B = Curve_Point(Strap_Line, 8, 7*(I+1)/U_Steps-1e-6);
        #local DA = vnormalize(Curve_Point(Strap_Line, 8, min(7, 7*I/U_Steps+0.03))-Curve_Point(Strap_Line,
          8, max(0, 7*I/U_Steps-0.03)));
        #local DB = vnormalize(Curve_Point(Strap_Line, 8,
          min(7, 7*(I+1)/U_Steps+0.03))-Curve_Point(Strap_Line, 8, 7*(I+1)/U_Steps-0.03));
        #local NA = <-DA.y, DA.x, 0>;  #local NB = <-DB.y, DB.x, 0>;
        #local WA = 9.8-1.3*I/U_Steps;  #local WB = 9.8-1.3*(I+1)/U_Steps;
        // padded section: twelve facets over the top, straight edges
        #for (K, 0, 15)
          #local P = -1+K/8;  #local Q = -1+(K+1)/8;
          #local HP = 1.75*pow(max(0, 1-pow(abs(P), 6)), 0.5)*(0.72+0.28*cos(P*pi/2));
          #local HQ = 1.75*pow(max(0, 1-pow(abs(Q), 6)), 0.5)*(0.72+0.28*cos(Q*pi/2));
          #local NP = vnormalize(z*(HP-1.75*(0.72+0.28*cos(min(1, P+0.05)*pi/2)))*0+NA+z*P*P*P*0.8);
          #local NQ = vnormalize(NA+z*Q*Q*Q*0.8);
          #local MP = vnormalize(NB+z*P*P*P*0.8);  #local MQ = vnormalize(NB+z*Q*Q*Q*0.8);
          smooth_triangle { A+NA*HP+z*P*WA, NP, A+NA*HQ+z*Q*WA, NQ, B+NB*HQ+z*Q*WB, MQ }
          smooth_triangle { A+NA*HP+z*P*WA, NP, B+NB*HQ+z*Q*WB, MQ, B+NB*HP+z*P*WB, MP }
        #end
        #for (Side, -1, 1, 2)
          triangle { A+z*Side*WA, B+z*Side*WB, B-NB*1.7+z*Side*WB*0.99 }
          triangle { A+z*Side*WA, B-NB*1.7+z*Side*WB*0.99, A-NA*1.7+z*Side*WA*0.99 }
        #end
      #end
      texture { M_Leather }
    }
    #for (I, 1, 46)
      #local U = 0.35+6.4*I/46;
      #local A = Curve_Point(Strap_Line, 8, U);
      #local D = vnormalize(Curve_Point(Strap_Line, 8, U+0.03)-Curve_Point(Strap_Line, 8, U-0.03));
      #for (Side, -1, 1, 2)
        #local W = (9.8-1.3*U/7)*0.86*Side;
        sphere {
          0, 1 scale <0.85, 0.2, 0.22> rotate z*degrees(atan2(D.y, D.x)) rotate y*4*Side
          translate A+<-D.y, D.x, 0>*1.3+z*W texture { M_Thread }
        }
      #end
    #end
    rotate y*Turn
  }
#end
#declare Watch = union {
  object { Case }
  object { Face }
  Strap_Half(-90)
  Strap_Half(90)
}
object { Watch rotate y*-18 }

// ---- the table and what lies on it ----

#declare M_Table = texture {
  pigment {
    wood turbulence <0.10, 0.03, 0.10> octaves 5 omega 0.55
    color_map { [0 srgb <0.30, 0.17, 0.10>] [0.5 srgb <0.24, 0.13, 0.075>] [0.8 srgb <0.16, 0.085, 0.05>]
      [1 srgb <0.28, 0.155, 0.09>] }
    rotate x*92 rotate y*1.5 scale <4.2, 4.2, 60> translate <12, -6, 0>
  }
  normal { wrinkles 0.12 scale <0.8, 1, 14> }
  finish { ambient 0 diffuse 0.72 specular 0.22 roughness 0.04 reflection { 0.012, 0.14 falloff 3 } }
}
#for (I, -4, 4)
  box {
    <I*74+0.4, -20, -400>, <I*74+73.6, 0, 460>
    texture { M_Table translate <I*31.7, I*13.3, I*157> }
  }
#end
box { <-600, -30, -400>, <600, -0.8, 460> pigment { srgb 0.02 } }

// notebook
union {
  superellipsoid { <0.06, 0.2> scale <52, 1.1, 72> translate y*11.3 texture { M_Leather scale 2
    pigment { srgb <0.16, 0.05, 0.045> } } }
  superellipsoid { <0.06, 0.2> scale <52, 1.1, 72> translate y*1.1 texture { M_Leather scale 2
    pigment { srgb <0.16, 0.05, 0.045> } } }
  box {
    <-50, 2, -70>, <50, 10.5, 70>
    pigment { gradient y color_map { [0 srgb <0.80, 0.74, 0.62>] [0.5 srgb <0.90, 0.86, 0.76>] } scale 0.5 }
      finish { ambient 0 diffuse 0.8 }
  }
  box { <24, 0, -72.6>, <30, 12.7, 72.6> pigment { srgb 0.03 } finish { ambient 0 diffuse 0.6 } }
  rotate y*14 translate <-92, 0, 118>
}
// fountain pen
union {
  mesh {
    Turned_Pieces(array[22] { <0.4, -66, 0>, <3.2, -65.4, 0>, <4.4, -60, 0>, <5.0, -50, 0>, <5.6, -10, 0>,
      <5.6, -1, 0>, <5.6, -1, 0>,
      <6.0, -1, 0>, <6.0, -1, 0>, <6.3, 1, 0>, <6.3, 1, 0>, <6.6, 20, 0>, <6.5, 48, 0>, <6.2, 58, 0>,
        <6.2, 58, 0>, <6.0, 58.6, 0>,
      <5.8, 62, 0>, <5.0, 66, 0>, <3.5, 68, 0>, <1.5, 68.8, 0>, <0.4, 69, 0>, <0, 69, 0> }, 22, 3, 40)
    texture { M_Lacquer }
  }
  mesh {
    Turned_Pieces(array[5] { <6.0, -1.2, 0>, <6.75, -0.9, 0>, <6.75, 2.2, 0>, <6.75, 2.2, 0>,
      <6.3, 2.6, 0> }, 5, 3, 40)
    Turned_Pieces(array[5] { <6.2, 57, 0>, <6.5, 57.3, 0>, <6.5, 59.6, 0>, <6.5, 59.6, 0>, <6.0, 60, 0> },
      5, 3, 40)
    Tube_Pieces(array[5] { <6.6, 58.4, 0>, <9.0, 57, 0>, <9.0, 40, 0>, <8.2, 22, 0>, <7.2, 18, 0> },
                array[5] { <0.9, 1.6, 0>, <0.8, 1.6, 0>, <0.7, 1.5, 0>, <0.8, 1.3, 0>, <0.1, 0.1, 0> }, 4,
                  16)
    texture { M_Gold }
  }
  rotate y*-35 rotate z*90 rotate y*-64 translate <56, 6.8, 24>
}
// coffee
union {
  mesh {
    Turned_Pieces(array[12] { <0, 1, 0>, <30, 1, 0>, <30, 1, 0>, <33, 2.4, 0>, <52, 5.5, 0>, <64, 9.5, 0>,
      <65, 10.3, 0>, <64, 10.6, 0>,
      <50, 7.4, 0>, <30, 4.6, 0>, <24, 4.4, 0>, <0, 4.4, 0> }, 12, 4, 60)
    Turned_Pieces(array[12] { <17, 4.4, 0>, <19, 5.5, 0>, <17.6, 8, 0>, <24, 16, 0>, <34, 32, 0>,
      <38.5, 54, 0>, <39.5, 60, 0>, <38.6, 60.6, 0>,
      <37.4, 60, 0>, <36.5, 54, 0>, <32, 33, 0>, <20, 14, 0> }, 12, 4, 60)
    Tube_Pieces(array[7] { <34, 50, 0>, <44, 52, 0>, <53, 47, 0>, <54, 38, 0>, <48, 28, 0>, <38, 24, 0>,
      <30, 24, 0> },
                array[7] { <2, 3.6, 0>, <2.2, 3.8, 0>, <2.4, 4.2, 0>, <2.4, 4.2, 0>, <2.2, 4.0, 0>,
                  <2.2, 3.8, 0>, <2, 3.6, 0> }, 4, 16)
    texture {
      pigment { srgb <0.93, 0.92, 0.90> }
      finish { ambient 0 diffuse 0.78 specular 0.5 roughness 0.008 reflection { 0.03, 0.25 falloff 3 } }
    }
  }
  cylinder { y*44, y*51, 36 pigment { srgb <0.13, 0.065, 0.035> } finish { ambient 0 diffuse 0.7 reflection
    0.06 } }
  scale 0.72 rotate y*-70 translate <34, 0, 112>
}
