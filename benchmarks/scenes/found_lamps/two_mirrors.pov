// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps that are seen by way of two mirrors, as in a periscope that lies on its side.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#declare Brightness = 2;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } no_reflection }
#macro Mirror(Left, Right)
  box { <Left, -40, 0>, <Right, 40, 0.0001> pigment { rgb 0 } finish { reflection 0.9 diffuse 0 ambient 0 } rotate 45*y translate 12*z }
#end
Mirror(-20, 9)
object { Mirror(-60, 32) translate -50*x }
#if (Lamps) union { Array(0, Announced) scale 4 translate <-50, 0, 60> } #end
