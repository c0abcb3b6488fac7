// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Small lights in the dark, most of them far out of focus.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 1.6, -5>;
#declare Look = <0, 0.9, 2>;
#declare Angle = 60;
#declare Focus = <0, 0.4, 2>;
#declare Aperture = 1;
#declare Lean = 60;
#include "camera.inc"

#declare Brightness = 1;
#ifdef (Depth) #declare Brightness = 0.05; #end    // nothing may be clipped in a picture of depth
#declare Dice = seed(5);
#for (I, 1, 150)
  sphere
  {
    <rand(Dice)*16 - 8, rand(Dice)*5 - 1.0, rand(Dice)*25>, 0.03
    pigment { color rgb <0.5 + rand(Dice)/2, 0.5 + rand(Dice)/2, rand(Dice)> }
    finish { ambient 0 diffuse 0 emission Brightness*(2 + 18*rand(Dice)*rand(Dice)) }
  }
#end
