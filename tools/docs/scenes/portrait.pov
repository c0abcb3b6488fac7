// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// The picture by which docs/lenses.md portrays each lens: the game of chess of the gallery. The camera stands so far away that the
// white king is as large with each lens.
//   Lens      0 ideal, or the number of a lens of the table below, in the order of lenses.csv
//   Shape     0 wide open, 1 stopped down to f/8, 2 wide open, swung so that the row of chessmen is sharp
//
// One unit is a centimetre.

#version 3.7;
global_settings { assumed_gamma 1  max_trace_level 3 }
#ifndef (Lens) #declare Lens = 0; #end
#ifndef (Shape) #declare Shape = 0; #end

// files and focal lengths; that of the retrofocus lens is made smaller for 35 mm film
#declare Files = array[12] {
  "", "tronnier_gauss_50.dat", "leica_summicron_52.dat", "zeiss_planar_50.dat", "nikon_nikkor_n_50.dat", "angenieux_55.dat",
  "nikon_nikkor_52.dat", "nikon_micro_nikkor_200.json", "minolta_50.json", "zeiss_master_prime_100.json", "canon_rf_51.json",
  "nikon_retrofocus.dat" }
#declare Focal = array[12] { 50, 50, 52, 50, 50, 55, 51.6, 200, 50, 100, 51, 28 }
#declare Night_Away = 58*Focal[Lens]/50;

camera {
  right x*image_width/image_height
  location <0, 10.5, -Night_Away>  look_at <0, 7.6, 0>
  focal_point <0, 6, 0>
  blur_samples 64, 512  variance 1/15000
  tilt_lens {
    scene_unit 10
    #if (Lens = 0)
      focal_length 50  f_stop (Shape = 1 ? 8 : 1.4)
    #else
      prescription concat("lenses/", Files[Lens]), Focal[Lens]
      #if (Shape = 1) f_stop 8 #end
    #end
    // the hinge rule: the plane through the row passes the lens as far beside it as the king is away
    #if (Shape = 2) swing degrees(asin(Focal[Lens]/10/Night_Away)) #end
  }
}
#include "chess_at_night.inc"
