// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The set-ups of tilt_lens.inc: one scene, with one macro in the camera.
//
//   ./render scenes/tutorial/macros.pov +W640 +H360                     the miniature look
//   ./render scenes/tutorial/macros.pov +W640 +H360 Declare=Look=1      sharp all over the ground
//   ./render scenes/tutorial/macros.pov +W640 +H360 Declare=Look=2      a real 24 mm lens, shifted up
//   ./render scenes/tutorial/macros.pov +W640 +H360 Declare=Look=3      sharp from a bench to a far roof
//
// Look for: the same village green as a toy; sharp all over the ground, from hedge to wood; seen from a lawn chair through
// a shifted lens; and sharp along a plane that rises from the near bench to the roofs behind.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "tilt_lens.inc"
#include "town_streets.inc"

#ifndef (Look)
  #declare Look = 0;
#end

#declare Eye  = <-40, 52, -88>;
#declare Pond = <0, 0, 4>;

camera {
  perspective
  right x*image_width/image_height
  #switch (Look)
    #case (0)
      location Eye  look_at Pond  angle 34
      Tilt_Lens_Miniature(Eye, Pond, 1)
    #break
    #case (1)
      location Eye  look_at Pond  angle 34
      Tilt_Lens_On_Ground(0, 20, 1.4)
    #break
    #case (2)
      location <-4, 1.3, -26>  look_at <-4, 1.3, 4>
      Tilt_Lens_Canon_TS_E_24(1000, 3.5, 0, 0, <0, 5>)
    #break
    #case (3)
      location Eye  look_at Pond  angle 34
      Tilt_Lens_Near_Far(Eye, Pond, <0, 0.5, -5>, <0, 9, 60>, 20, 1.4)
    #break
  #end
  blur_samples 16, 128  confidence 0.95  variance 1/3000
}

light_source { <-150, 130, -60>*1000 color rgb <1.00, 0.91, 0.76>*2 parallel point_at 0 }
light_source { <40, 160, -90>*1000 color rgb <0.55, 0.72, 1.00>*0.5 parallel point_at 0 shadowless }
sky_sphere { pigment { gradient y color_map { [0 srgb <0.80, 0.88, 0.95>] [0.6 srgb <0.30, 0.55, 0.88>] } } }

plane { y, 0 texture { T_Meadow } }
cylinder { <0, -1, 4>, <0, 0.06, 4>, 7.5 texture { T_Sand } }
cylinder { <0, -1, 4>, <0, 0.10, 4>, 6.4 texture { T_Water } }
box { <-200, -1, -19>, <200, 0.05, -13> texture { T_Asphalt } }
Dashes(-100, 100, -16, no)
Cars(<-60, 0.05, -17.4>, <60, 0.05, -17.4>, 13, 0.5, 0)
Cars(<-60, 0.05, -14.6>, <60, 0.05, -14.6>, 13, 0.5, 180)
Gardens(-60, 16, 60, 80, 6, 3)
Gardens(-62, -13, -16, 12, 2, 1)
Gardens(18, -13, 64, 12, 2, 1)
#for (I, 0, 11) Person_At(<0, 0.06, 4>+vrotate(x*7.2, y*360*rand(S))) #end
#for (I, 0, 5) object { Thing_Bench rotate y*60*I translate <0, 0, 4>+vrotate(z*9, y*60*I) } #end
#for (I, 0, 9) Tree_At(<0, 0, 4>+vrotate(z*(11+2*rand(S)), y*(22*I-100))) #end
#for (I, 1, 150) Conifer_At(<-110+220*rand(S), 0, 84+60*rand(S)>) #end
