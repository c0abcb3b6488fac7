// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps that are seen by way of two mirrors, as in a periscope that lies on its side.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#declare Brightness = 5;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
#declare Mirror = box { <-15, -10, 0>, <15, 10, 0.1> pigment { rgb 0.05 } finish { reflection 0.9 diffuse 0.3 } }
object { Mirror rotate 45*y translate 8*z }
object { Mirror rotate 45*y translate <-16, 0, 8> }
Array(<-16, 0, 24>, Announced)
