// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// A wall that fills the picture and is blurred alike with and without tilt: the wall leans with the plane
// of sharp focus so that at each pixel the vergence of wall and focus differ by the same. Its pattern
// depends on the direction from the eye alone, so that both walls look the same.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 0, 0>;
#declare Look = <0, 0, 1>;
#declare Angle = 50;
#declare Focus = <0, 0, 2>;
#declare Aperture = 0.2;
#declare Lean = 30;
#include "camera.inc"

// The plane of focus is k.X = 1; the wall m.X = 1 with m = k - z/6: seen untilted, 3 away.
#declare Wall = Normal_/Distance_ - z/6;
plane
{
  Wall/vlength(Wall), 1/vlength(Wall)
  pigment
  {
    function { select(sin(60*x/z)*sin(60*y/z), 0, 1) }
    color_map { [0 color rgb <0.1, 0.15, 0.3>] [1 color rgb <0.95, 0.9, 0.8>] }
  }
  finish { ambient 0 diffuse 0 emission 1 }
}
