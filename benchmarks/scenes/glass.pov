// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Mirrors and glass over a checkered floor: what is seen in them is as far away as its whole way of light.

#version 3.7;
global_settings { assumed_gamma 1.0 max_trace_level 8 }
#declare Eye = <0, 1.7, -5>;
#declare Look = <0, 0.5, 1>;
#declare Angle = 55;
#declare Focus = <0, 0.4, 0.5>;
#declare Aperture = 0.35;
#declare Lean = 60;
#include "camera.inc"

light_source { <-6, 9, -6>, color rgb 0.9 }
sky_sphere { pigment { gradient y color_map { [0 color rgb <0.8, 0.85, 0.9>] [0.6 color rgb <0.3, 0.5, 0.8>] } } }
plane
{
  y, 0
  pigment { checker color rgb <0.85, 0.8, 0.7>, color rgb <0.25, 0.15, 0.1> scale 0.4 }
  finish { ambient 0.1 diffuse 0.7 reflection 0.08 }
}
#declare Mirror = finish { ambient 0 diffuse 0.05 specular 0.6 roughness 0.01 reflection 0.85 }
box { <-3.2, 0, 4>, <3.2, 2.6, 4.1> pigment { color rgb 0.9 } finish { Mirror } }
#declare Dice = seed(11);
#for (I, 0, 17)
  #local Place = <rand(Dice)*5 - 2.5, 0, I/3 - 2>;
  #switch (mod(I, 3))
    #case (0)
      sphere { Place + 0.35*y, 0.35 pigment { color rgb <0.9, 0.85, 0.7> } finish { Mirror } }
    #break
    #case (1)
      sphere
      {
        Place + 0.35*y, 0.35
        pigment { color rgbf <0.95, 1, 0.97, 0.95> }
        finish { ambient 0 diffuse 0 specular 0.7 roughness 0.005 reflection { 0.02, 0.6 fresnel } conserve_energy }
        interior { ior 1.5 }
      }
    #break
    #else
      cylinder
      {
        Place, Place + 0.7*y, 0.22
        pigment { color rgb <rand(Dice), rand(Dice), rand(Dice)> } finish { ambient 0.1 diffuse 0.7 phong 0.4 }
      }
  #end
#end
