// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A chess set before the first move. With a 90 mm lens at a wide aperture, one piece would be sharp. Turned about its
// vertical axis (swing), the lens keeps the whole row of white pieces sharp, from the near rook to the far one, while the
// black pieces are blurred.
//
//   ./render scenes/gallery/chess_by_swing.pov +W1280 +H720
//
// Try: Declare=Turned_Lens=0 for an ordinary lens. Without swing, a similar depth of field needs about f_stop 11, which also
// makes the background sharper.
//
// One unit is a centimetre. The swing follows from the hinge rule: sin(swing) = focal length / J,
// where J is how far beside the lens the plane of sharp focus passes it; here to the right, so the
// swing is negative.

#version 3.7;
#ifndef (Samples) #declare Samples = 128; #end
#ifndef (Turned_Lens) #declare Turned_Lens = yes; #end
global_settings { assumed_gamma 1 max_trace_level 3 adc_bailout 0.02 }
#include "chess_set.inc"

#declare Square = 5.5;
#declare Row = -3.5*Square;                       // z of White's pieces
#declare Eye = <66, 19, -88>;
#declare Subject = <3.5, 4, Row>;
#declare To = vnormalize((Subject-Eye)*<1, 0, 1>);
#declare Hinge = (Row-Eye.z)/-To.x;               // J in centimetres

camera {
  perspective
  right x*image_width/image_height
  location Eye
  look_at Subject+<-0.5, -0.4, 0>
  focal_point Subject
  blur_samples Samples  confidence 0.95  variance 1/4000
  tilt_lens {
    scene_unit 10
    focal_length 90
    f_stop 2.8
    blades 9
    swing (Turned_Lens ? -degrees(asin(9/Hinge)) : 0)
  }
}

// ---- light: a window to the left, its glow from the room, a warm lamp far behind ----

light_source {
  <-120, 95, 60>, rgb <1.00, 0.80, 0.56>*3.5
  area_light <40, 0, 60>, <0, 70, 0>, 3, 3 adaptive 1 jitter
}
light_source { <60, 140, -120>, rgb <1.00, 0.86, 0.72>*0.27 shadowless }
light_source { <150, 60, 140>, rgb <1.00, 0.66, 0.36>*0.22 shadowless }

// what polished wood reflects, and what the lens sees beyond the table
#declare Room = union {
  box { <-100, 40, 0>, <-20, 130, 1> pigment { rgb <1.0, 0.84, 0.64>*1.5 } }
  box { <-62, 40, -1>, <-58, 130, 0> pigment { rgb 0.02 } }
  box { <-100, 84, -1>, <-20, 88, 0> pigment { rgb 0.02 } }
  finish { ambient 0 diffuse 0 emission 1 }
}
object { Room rotate y*-64 translate <-150, 0, 60> no_shadow no_image }
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.018, 0.011, 0.008>] [0.5 rgb <0.035, 0.022, 0.016>]
      [0.58 rgb <0.09, 0.055, 0.035>] [1 rgb <0.14, 0.11, 0.09>] }
    scale 2 translate -y
  }
}
// lamps of the room: specks of light, spread by the open lens into discs with nine edges
#declare S = seed(64);
#for (I, 1, 30)
  #local A = radians(-60+42*rand(S));
  #local R = 260+120*rand(S);
  sphere {
    Eye*<1, 0, 1>+<sin(A)*R, -32+50*rand(S), cos(A)*R>, 3.2
    pigment { rgb <1.00, 0.50+0.25*rand(S), 0.18+0.2*rand(S)>*(0.45+0.55*rand(S)) }
    finish { ambient 0 diffuse 0 emission 1 }
    no_shadow
  }
#end

// ---- materials ----

#declare F_Polish = finish {
  ambient 0.0 diffuse 0.75 specular 0.25 roughness 0.02 reflection { 0.01, 0.20 fresnel on } conserve_energy
}
// Wood with grain along y: rings seen from the side, with pores.
#macro Wood(Light, Dark, Size)
  texture {
    pigment {
      wood turbulence <0.06, 0.015, 0.06> octaves 4 omega 0.5
      color_map { [0 srgb Light] [0.55 srgb Light*0.6+Dark*0.4] [0.85 srgb Dark] [1 srgb Light*0.9+Dark*0.1]
        }
      rotate x*91.5 rotate z*1.2 scale <Size, Size*9, Size> 
    }
    finish { F_Polish }
  }
  texture {
    pigment {
      bozo turbulence 0.2 color_map { [0.5 srgbt <0, 0, 0, 1>]
        [0.62 srgbt <Dark.x*0.4, Dark.y*0.4, Dark.z*0.4, 0.55>] }
      scale <0.035, 1.1, 0.035>*Size*1.6
    }
    finish { F_Polish }
  }
#end
#declare M_White = Wood(<0.93, 0.76, 0.50>, <0.86, 0.62, 0.35>, 0.30)
#declare M_Black = Wood(<0.27, 0.10, 0.055>, <0.08, 0.028, 0.018>, 0.42)
#declare M_Maple = Wood(<0.86, 0.70, 0.47>, <0.74, 0.54, 0.32>, 0.8)
#declare M_Walnut = Wood(<0.36, 0.19, 0.10>, <0.18, 0.085, 0.045>, 0.8)
#declare M_Table = Wood(<0.24, 0.12, 0.065>, <0.10, 0.045, 0.025>, 2.6)

// ---- board and table ----

#for (I, 0, 7) #for (J, 0, 7)
  box {
    <-Square/2+0.012, -1, -Square/2+0.012>, <Square/2-0.012, 0, Square/2-0.012>
    #if (mod(I+J, 2) = 0) texture { M_Walnut rotate x*90 translate <I*7.3, J*3.1, J*11.7> }
    #else texture { M_Maple rotate x*90 translate <I*3.7, J*5.9, J*13.1+I> } #end
    translate <(I-3.5)*Square, 0, (J-3.5)*Square>
  }
#end #end
#declare Half = 4*Square;
box { <-Half, -1.2, -Half>, <Half, -0.03, Half> pigment { srgb <0.1, 0.05, 0.03> } }
#for (I, 0, 3)
  prism {
      linear_spline -Half-2.6, Half+2.6, 6, <0, -0.9>, <0.0, 0.02>, <0.35, 0.02>, <2.3, -0.05>,
        <2.75, -0.9>, <0, -0.9>
      rotate x*-90
    texture { M_Walnut scale 1.2 rotate x*90 translate <I*5, 0, I*17> }
    rotate y*180
    clipped_by { plane { vnormalize(<-1, 0, 1>), Half*0.7072 } plane { vnormalize(<-1, 0, -1>), Half*0.7072
      } }
    rotate y*180
    translate x*Half
    rotate y*90*I
  }
#end
box { <-85, -9, -85>, <150, -1.0, 52> texture { M_Table rotate z*90 } }

// ---- the pieces ----

#macro Piece(What, File, Rank, Is_White)
  #local Turn = (rand(S)-0.5)*24;
  object {
    What
    #if (Is_White) texture { M_White translate <rand(S)*20, rand(S)*20, rand(S)*20> rotate y*360*rand(S) }
    #else          texture { M_Black translate <rand(S)*20, rand(S)*20, rand(S)*20> rotate y*360*rand(S) }
      #end
    rotate y*Turn
    translate <(File-3.5)*Square+(rand(S)-0.5)*0.4, 0, (Rank-3.5)*Square+(rand(S)-0.5)*0.4>
  }
#end
#for (I, 0, 1)
  #local R = 7*I;
  #for (Side, 0, 1)
    Piece(Chess_Rook, 7*Side, R, 1-I)
    Piece(object { Chess_Knight rotate y*(I ? 90 : -90) }, 1+5*Side, R, 1-I)
    Piece(object { Chess_Bishop rotate y*(200*Side+60) }, 2+3*Side, R, 1-I)
  #end
  Piece(Chess_Queen, 3, R, 1-I)
  Piece(object { Chess_King rotate y*25 }, 4, R, 1-I)
  #for (F, 0, 7) Piece(Chess_Pawn, F, 1+5*I, 1-I) #end
#end
