// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A bridge at dusk. A 50 mm lens at f/1.4 shows the lamps of the far bank as hexagons, the shape of its diaphragm with six
// blades. Swing turns the plane of sharp focus along the railing, so that the locks are sharp from the near one to the far
// one.
//
//   ./render scenes/gallery/city_lights.pov +W1280 +H720
//
// Try: Declare=Blades=5, or 0 for a round diaphragm; Declare=Swung=0 for a lens without swing, with which one lock is sharp.
// Small bright lights far out of focus need many samples: Declare=Samples=2000 gives a picture with little noise.
//
// One unit is a centimetre (scene_unit 10). The camera is level; the swing follows from the hinge rule.

#version 3.7;
#ifndef (Samples) #declare Samples = 192; #end
#ifndef (Blades) #declare Blades = 6; #end
#ifndef (Swung) #declare Swung = yes; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "turned.inc"

#declare Eye = <60, 107, -60>;
#declare Subject = <-4, 107, 0>;
#declare To = vnormalize(Subject-Eye);
#declare Hinge = -Eye.z/-To.x;    // J: where the railing's plane passes beside the lens, to its right
camera {
  perspective
  right x*image_width/image_height
  location Eye
  look_at Subject
  focal_point Subject
  blur_samples Samples  confidence 0.9  variance 1/1500
  tilt_lens {
    scene_unit 10
    focal_length 50
    f_stop 1.4
    shift <0, -2.6>
    #if (Blades > 2) blades Blades, 12 #end
    swing (Swung ? -degrees(asin(5/Hinge)) : 0)
  }
}
#declare S = seed(1909);

// ---- dusk ----

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <0.50, 0.20, 0.075>] [0.035 rgb <0.34, 0.17, 0.12>] [0.09 rgb <0.13, 0.12, 0.19>]
      [0.20 rgb <0.040, 0.068, 0.155>] [0.6 rgb <0.012, 0.022, 0.065>]
    }
  }
  pigment {
    bozo turbulence 0.5
    color_map { [0.45 rgbt 1] [0.8 rgbt <0.10, 0.05, 0.06, 0.55>] }
    scale <0.5, 0.07, 0.5>
  }
}
light_source { <130, 330, -150>, rgb <1.00, 0.66, 0.34>*2.6 fade_distance 330 fade_power 2 }
light_source { <-900, 300, -500>, rgb <1.00, 0.55, 0.30>*0.30 shadowless }
light_source { <-300, 500, 900>, rgb <0.35, 0.50, 1.00>*0.40 shadowless }

// ---- the far bank ----

#declare F_Glow = finish { ambient 0 diffuse 0 emission 1 }
// From the camera: degrees beside the axis, height in centimetres, distance.
#macro Far(Beside, Height, Distance)
  (<Eye.x, Height, Eye.z> + vrotate(vnormalize(To*<1, 0, 1>), y*(Beside))*Distance)
#end
#declare Windows = texture {
  pigment {
    cells
    color_map {
      [0.0 rgb <0.010, 0.012, 0.022>] [0.66 rgb <0.012, 0.014, 0.026>] [0.66 rgb <0.42, 0.22, 0.075>]
      [0.86 rgb <0.58, 0.34, 0.14>] [0.86 rgb <0.18, 0.25, 0.33>] [0.93 rgb <0.02, 0.03, 0.05>]
    }
    scale <190, 300, 200>
  }
  finish { F_Glow }
}
#for (I, 0, 33)
  #local B = -25+50*I/33+1.2*(rand(S)-0.5);
  #local H = 1300+1500*rand(S)*rand(S)+(mod(I, 9) = 4 ? 2400 : 0)*rand(S);
  #local D = 27500+4000*rand(S);
  box {
    <-450-250*rand(S), -600, 0>, <450+250*rand(S), H, 900>
    texture { Windows translate <rand(S)*500, rand(S)*900, 17*I> }
    rotate y*(degrees(atan2(To.x, To.z))+B) translate Far(B, 0, D)
  }
#end
// A church's spires and dome, and hills, against the last light.
#for (I, 0, 1)
  cone { Far(-7.6+0.9*I, 1500, 27400), 260, Far(-7.6+0.9*I, 5200, 27400), 20
    pigment { rgb <0.02, 0.022, 0.04> } finish { F_Glow } }
#end
sphere { 0, 900 scale <1, 1.15, 1> translate Far(7.5, 2300, 27000) pigment { rgb <0.03, 0.05, 0.06> }
  finish { F_Glow } }
cylinder { Far(7.5, -600, 27000), Far(7.5, 2500, 27000), 870 texture { Windows } }
#for (I, 0, 11)
  sphere { 0, 1 scale <9000, 1900+1700*rand(S), 4000> translate Far(-42+8*I, -600, 60000)
    pigment { rgb <0.035, 0.035, 0.075> } finish { F_Glow } }
#end
box { <-40000, -600, 0>, <40000, -180, 400> rotate y*degrees(atan2(To.x, To.z)) translate Far(0, 0, 26500)
  pigment { rgb <0.05, 0.04, 0.035> } finish { F_Glow } }

// Lamps: a ball whose image with a pinhole is 14 pixels of 1280 wide.
#macro Lamp(Beside, Height, Distance, C)
  sphere { Far(Beside, Height, Distance), Distance*0.0040 pigment { rgb C } finish { F_Glow } no_shadow }
#end
#declare Warm = <1.00, 0.50, 0.15>*13;
#declare Gold = <1.00, 0.64, 0.28>*13;
#declare Cold = <0.70, 0.86, 1.00>*10;
#for (I, 0, 9)
  Lamp(-24+3.3*I+0.5*rand(S), 200+90*rand(S), 24500, Warm*(0.7+0.5*rand(S)))
#end
#for (I, 0, 16)
  #local C = (rand(S) < 0.66 ? Gold : (rand(S) < 0.6 ? Cold : <1.0, 0.10, 0.06>*7));
  Lamp(-24+48*rand(S), 700+2500*pow(rand(S), 1.6), 26000, C*(0.3+0.6*rand(S)))
#end
#for (I, 0, 9)   // the next bridge: lamps in an arch, and their strings of red and white traffic
  #local X = I/9;
  Lamp(9+13.5*X, 150+1500*X*(1-X), 15000+9000*(1-X), Gold*0.7)
#end
#for (I, 0, 4) Lamp(-20+5.3*I+2*rand(S), -60, 24000, (mod(I, 2) ? <1.0, 0.09, 0.04>*7 : Cold*0.7)) #end
// a boat
#for (I, 0, 3) Lamp(-13.5+0.6*I, -520, 14000+300*I,
  <0.15, 1.0, 0.55>*(I = 1 ? 4 : 0)+Gold*(I = 1 ? 0 : 0.5)) #end

plane {
  y, -600
  pigment { rgb <0.008, 0.014, 0.03> }
  normal { bumps 0.11 scale <420, 1, 170> rotate y*degrees(atan2(To.x, To.z)) }
  finish { ambient 0 diffuse 0.2 reflection { 0.25, 0.9 falloff 3 } }
}

// ---- the railing: along x, at z = 0 ----

#declare F_Wet = finish { ambient 0.015 diffuse 0.55 specular 0.9 roughness 0.012 reflection
  { 0.02, 0.35 falloff 3 } }
#declare M_Iron = texture {
  pigment { granite color_map { [0.2 srgb <0.09, 0.16, 0.15>] [0.75 srgb <0.16, 0.25, 0.23>]
    [0.86 srgb <0.34, 0.20, 0.12>] } scale 3 }
  normal { average normal_map { [1 bumps 0.22 scale 0.12] [1 wrinkles 0.3 scale 0.7] } }
  finish { F_Wet }
}
union {
  cylinder { -500*x, 200*x, 1 scale <1, 1.35, 3.4> translate y*104.2 }
  cylinder { -500*x, 200*x, 1 scale <1, 0.9, 2.2> translate y*102.4 }
  box { <-500, 101, -1.0>, <200, 102.2, 1.0> }
  box { <-500, 94.3, -0.55>, <200, 96.4, 0.55> }
  cylinder { <-500, 96.4, 0>, <200, 96.4, 0>, 0.62 }
  box { <-500, 60, -0.55>, <200, 61.6, 0.55> }
  texture { M_Iron }
}
#declare Baluster = mesh {
  Turned_Pieces(array[22] { <1.0, 60, 0>, <1.5, 62, 0>, <1.5, 64, 0>, <0.8, 65, 0>, <0.75, 70, 0>,
    <1.2, 80, 0>, <1.55, 84, 0>,
    <1.2, 86.5, 0>, <0.75, 87.3, 0>, <0.75, 87.3, 0>, <1.35, 87.7, 0>, <1.35, 88.7, 0>, <0.75, 89.1, 0>,
      <0.75, 89.1, 0>,
    <0.72, 93, 0>, <0.75, 96, 0>, <0.75, 98.2, 0>, <0.75, 98.2, 0>, <1.3, 98.9, 0>, <1.35, 99.9, 0>,
      <0.9, 100.8, 0>, <0.9, 101.5, 0> }, 22, 4, 24)
}
#for (X, -380, 140, 13) object { Baluster texture { M_Iron } translate x*X } #end
// scrolls between the balusters
#for (X, -380, 140, 13)
  union {
    torus { 2.3, 0.36 rotate x*90 translate <6.5, 98.7, 0> }
    torus { 1.0, 0.3 rotate x*90 translate <3.1, 98.0, 0> }
    torus { 1.0, 0.3 rotate x*90 translate <9.9, 98.0, 0> }
    texture { M_Iron } translate x*X
  }
#end
// rain on the rail: drops that shine
#declare Drop = texture {
  pigment { rgbt <0.75, 0.85, 0.9, 0.82> }
  finish { ambient 0 diffuse 0.05 specular 2.2 roughness 0.003 reflection { 0.06, 0.6 falloff 3 } }
}
#for (I, 1, 460)
  #local T = (rand(S)-0.5)*150;  #local X = -170+250*rand(S);
  #local R = 0.10+0.22*pow(rand(S), 2.5);
  sphere { 0, R scale <1+0.5*rand(S), 0.62, 1> translate y*0.02 translate <X, 104.2+1.35*cos(radians(T)),
    3.4*sin(radians(T))> texture { Drop } }
#end
#for (I, 1, 70)   // and hanging below it
  sphere { 0, 0.2 scale <0.8, 1.3, 0.8> translate <-170+250*rand(S), 102.75-0.05*rand(S), -2.0+0.5*rand(S)>
    texture { Drop } }
#end

// ---- love locks ----

#declare M_Shackle = texture { pigment { rgb <0.66, 0.66, 0.68> } finish { ambient 0.01 diffuse 0.3 specular
  0.9 roughness 0.01 metallic reflection 0.45 } }
#macro Enamel(C)
  texture {
    pigment { granite color_map { [0.0 srgb C*0.82] [0.72 srgb C] [0.86 srgb C*0.55+0.12] } scale 1.4 }
    normal { wrinkles 0.12 scale 0.5 }
    finish { ambient 0.015 diffuse 0.62 specular 0.7 roughness 0.015 reflection { 0.03, 0.3 falloff 3 } }
  }
#end
#declare M_Brass = texture {
  pigment { granite color_map { [0.1 rgb <0.52, 0.30, 0.075>] [0.75 rgb <0.64, 0.39, 0.11>]
    [0.95 rgb <0.36, 0.20, 0.055>] } scale 2.2 }
  normal { bumps 0.05 scale 0.7 }
  finish { ambient 0.01 diffuse 0.45 specular 1.2 roughness 0.03 metallic reflection 0.3 }
}
#declare Shackle = mesh {
  Tube_Pieces(array[9] { <-1.15, -1.2, 0>, <-1.15, 0.6, 0>, <-1.13, 1.6, 0>, <-0.85, 2.3, 0>, <0, 2.65, 0>,
    <0.85, 2.3, 0>,
                         <1.13, 1.6, 0>, <1.15, 0.6, 0>, <1.15, -1.2, 0> },
              array[9] { 0.33*(x+y), 0.33*(x+y), 0.33*(x+y), 0.33*(x+y), 0.33*(x+y), 0.33*(x+y), 0.33*(x+y),
                0.33*(x+y), 0.33*(x+y) }, 3, 16)
}
#declare Heart = intersection {
  union {
    cylinder { <-1.0, 0.9, -0.7>, <-1.0, 0.9, 0.7>, 1.12 }
    cylinder { <1.0, 0.9, -0.7>, <1.0, 0.9, 0.7>, 1.12 }
    prism {
      linear_spline -0.7, 0.7, 6, <-1.83, 0.14>, <0, -2.1>, <1.83, 0.14>, <1.3, 1.1>, <-1.3, 1.1>,
        <-1.83, 0.14>
      rotate x*-90
    }
  }
  sphere { 0, 1 scale <2.5, 2.5, 0.95> }
  translate y*-0.6
}
#declare Names = array[8] { "A + M", "J & K", "EVA", "1909", "L + T", "NO & IDA", "PIA", "B + O" }
#declare Paints = array[5] { <0.62, 0.035, 0.05>, <0.05, 0.16, 0.42>, <0.70, 0.72, 0.74>,
  <0.05, 0.30, 0.24>, <0.78, 0.22, 0.34> }
#macro Lock(Kind, Place)
  union {
    object { Shackle texture { M_Shackle } }
    #if (Kind = 6)
      object { Heart scale 1.15 translate y*-0.9 Enamel(Paints[0]) }
    #else
      union {
        superellipsoid { <0.18, 0.22> scale <2.0, 1.62, 0.82> translate y*-1.5 }
        box { <-1.86, -2.9, -0.835>, <1.86, -2.72, 0.835> }
        box { <-1.86, -0.32, -0.835>, <1.86, -0.14, 0.835> }
        #if (Kind = 0 | Kind > 4) texture { M_Brass } #else Enamel(Paints[Kind]) #end
      }
      #local TX = text { internal 1, Names[Place], 0.1, 0 scale <0.82, 0.82, 1> };
      object {
        TX translate <-(max_extent(TX).x+min_extent(TX).x)/2, -1.75, -0.86>
        #if (Kind = 0 | Kind > 4) pigment { rgb <0.10, 0.055, 0.02> } #else
          pigment { rgb <0.75, 0.70, 0.58> } #end
        finish { ambient 0.01 diffuse 0.6 specular 0.4 }
      }
    #end
    cylinder { <-1.15, -0.2, 0>, <-1.15, 0.16, 0>, 0.5 texture { M_Shackle } }
    cylinder { <1.15, -0.2, 0>, <1.15, 0.16, 0>, 0.5 texture { M_Shackle } }
    scale (Kind = 6 ? 1.05 : 0.92+0.3*rand(S))
    translate y*-1.75 rotate y*(rand(S)-0.5)*36 rotate z*(rand(S)-0.5)*22
    translate y*96.6
  }
#end
#local X = 62;
#local N = 0;
#while (X > -330)
  #local Kind = int(rand(S)*7.999);
  object { Lock(Kind, mod(N, 8)) translate <X, 0, -0.9*rand(S)-0.3> }
  #local X = X-(3.4+5.6*rand(S)*(rand(S) < 0.75));
  #local N = N+1;
#end
