// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A game of chess at night, through a fast lens of 1975: the surfaces of the Zeiss Planar 1.4/50, wide open, swung so that the row of
// pieces through the king is sharp. Its rims make cat's eyes of the lamps, its spherical aberration gathers their light at the
// rim, and its glasses disperse it.
//
//   ./render scenes/gallery/chess_at_night.pov +W1280 +H720
//
// Try: Declare=Glass=0 for an ideal lens of the same numbers; Declare=File=4 for a Nikkor of f/1.1 (1 to 4); Declare=Swung=0 for a lens
// without swing. Declare=Samples=2000 leaves less noise at the rims of the lamps.
//
// One unit is a centimetre (scene_unit 10).

#version 3.7;
#ifndef (Samples) #declare Samples = 256; #end
#ifndef (Glass) #declare Glass = yes; #end
#ifndef (Swung) #declare Swung = yes; #end
#ifndef (File) #declare File = 1; #end
#declare Files = array[4] { "zeiss_planar_50.dat", "leica_summicron_52.dat", "minolta_50.json", "nikon_nikkor_n_50.dat" }
global_settings { assumed_gamma 1 max_trace_level 3 }

#declare Night_Away = 70;
camera {
  perspective
  right x*image_width/image_height
  location <0, 10.5, -Night_Away>
  look_at <0, 7.6, 0>
  focal_point <0, 6, 0>
  blur_samples Samples  confidence 0.9  variance 1/3000
  tilt_lens {
    scene_unit 10
    #if (Glass) prescription concat("lenses/", Files[File-1]), 50  dispersion on #else focal_length 50  f_stop 1.4 #end
    swing (Swung ? degrees(asin(5/Night_Away)) : 0)
  }
}
#include "chess_at_night.inc"
