// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Aperture: how wide the lens is open, and the shape of its diaphragm.
//
//   ./render scenes/tutorial/aperture.pov +W640 +H360
//   ./render scenes/tutorial/aperture.pov +W640 +H360 Declare=Stop=5.6
//   ./render scenes/tutorial/aperture.pov +W640 +H360 Declare=Blades=0
//
// Look for: each light behind the pawns appears as an image of the diaphragm: a hexagon here, a disc with Blades=0.
// With a larger f-number (Stop=5.6) the images are smaller. The pawn in front is sharp in all pictures.
// The image is upright behind the plane of sharp focus, and upside down in front of it (Blades=5 shows this).

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tutorial_set.inc"

#ifndef (Stop)
  #declare Stop = 2.8;
#end
#ifndef (Blades)
  #declare Blades = 6;
#end

camera {
  perspective
  right x*image_width/image_height
  location <0, 9, -55>
  look_at <0, 7.6, 0>
  angle 30
  focal_point <-4, 6, 0>
  blur_samples 64, 1024  confidence 0.95  variance 1/10000
  tilt_lens {
    scene_unit 10                    // one unit is 10 mm
    f_stop Stop
    #if (Blades)
      blades Blades, 10
    #end
  }
}

light_source { <-120, 200, -160> color rgb <1.0, 0.80, 0.55>*0.9 parallel point_at 0 }
light_source { <60, 60, 160> color rgb <0.35, 0.5, 1.0>*0.35 parallel point_at 0 shadowless }
background { color srgb <0.03, 0.04, 0.10> }
box { <-300, -4, -60>, <300, 0, 60> texture { Set_Wood finish { reflection 0.08 } } }

object { Set_Pawn(11) Set_Colour(<0.80, 0.10, 0.08>) translate <-4, 0, 0> }
object { Set_Pawn(11) Set_Colour(<0.92, 0.90, 0.84>) translate <7, 0, 20> }
object { Set_Pawn(11) Set_Colour(<0.92, 0.90, 0.84>) translate <-16, 0, 32> }

// Strings of lights that sag between their posts.
#declare S = seed(3);
#declare Light_Colours = array[5] {
  <1.0, 0.62, 0.20>, <1.0, 0.75, 0.40>, <1.0, 0.25, 0.15>, <0.25, 0.65, 1.0>, <0.35, 1.0, 0.40>
}
#for (J, 0, 2)
  #for (I, 0, 21)
    #declare U = (I+0.5*rand(S))/21;
    sphere {
      <-62+124*U, 14+7*J-24*U*(1-U)+2*rand(S), 80+16*J>, 0.6
      pigment { color srgb Light_Colours[int(rand(S)*4.99)] }
      finish { ambient 0 diffuse 0 emission 9 }
      no_shadow
    }
  #end
#end
