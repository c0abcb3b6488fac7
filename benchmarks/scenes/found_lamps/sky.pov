// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Suns that a pigment of the sky shows.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Eye = <0, 0, -10>;
#declare Look = 0;
#declare Sharp = 0;
#declare Aperture = 1.5;
#include "found_lamps/camera.inc"

light_source { <20, 30, -30>, rgb 1 }
sphere { <-1.5, -1, 0>, 0.8 pigment { rgb <0.2, 0.4, 0.6> } }
#declare Step = 0.11;
#declare Width = Radius/22;     // of a sun, from its middle to its rim, in the ball of directions
#if (defined(Known) | !Lamps)
  background { rgb 0.08 }
  #if (Lamps)
    // as many spheres, which are as good as infinitely far away
    #for (I, -4, 3)
      #for (J, -3, 2)
        #declare X_ = (I + 0.5)*Step;
        #declare Y_ = (J + 0.5)*Step;
        sphere { 1e6*<X_, Y_, sqrt(1 - X_*X_ - Y_*Y_)>, 1e6*sin(2*asin(Width/2)) texture { Announced } }
      #end
    #end
  #end
#else
  #declare Middle = function(C) { (floor(C/Step) + 0.5)*Step }
  #declare Depth_ = function(A, B) { sqrt(max(0, 1 - A*A - B*B)) }
  sky_sphere
  {
    pigment
    {
      function { select(pow(x - Middle(x), 2) + pow(y - Middle(y), 2) + pow(z - Depth_(Middle(x), Middle(y)), 2) - Width*Width, 1, 0) }
      color_map { [0.5 rgb 0.08] [0.5 Warm*Glow] }
    }
  }
#end
