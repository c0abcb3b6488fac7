// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Lamps that glow by colours of a pattern.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }

// as Array() sets lamps, but painted on a wall
#declare Dark = rgb 0.05;
#if (defined(Known) | !Lamps)
  plane { -z, -12.001 pigment { Dark } finish { emission 1 diffuse 0 ambient 0 } }
  #if (Lamps)
    #for (I, 0, 5)
      #for (J, 0, 3)
        disc { <2.6*I - 6.5 + 0.3*J, 2.2*J - 3.3, 12>, z, Radius texture { Announced } }
      #end
    #end
  #end
#else
  #declare Row = function(Y) { min(3, max(0, floor((Y + 3.3)/2.2 + 0.5))) }
  #declare Column = function(X, Y) { min(5, max(0, floor((X + 6.5 - 0.3*Row(Y))/2.6 + 0.5))) }
  plane
  {
    -z, -12
    pigment
    {
      function { select(pow(x - 2.6*Column(x, y) + 6.5 - 0.3*Row(y), 2) + pow(y - 2.2*Row(y) + 3.3, 2) - Radius*Radius, 1, 0) }
      color_map { [0.5 Dark] [0.5 Warm*Glow] }
    }
    finish { emission 1 diffuse 0 ambient 0 }
  }
#end
