// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Hills of rock and grass to the horizon, clouds, some haze.

#version 3.7;
global_settings { assumed_gamma 1.0 }
#declare Eye = <0, 2.2, -6>;
#declare Look = <0, 0.9, 2>;
#declare Angle = 58;
#declare Focus = <0, 0.5, 0>;
#declare Aperture = 0.3;
#declare Lean = 70;
#include "camera.inc"

light_source { <-60, 45, -30>, color rgb <1.15, 1.05, 0.9> parallel point_at 0 }
sky_sphere
{
  pigment { gradient y color_map { [0 color rgb <0.75, 0.82, 0.9>] [0.5 color rgb <0.25, 0.42, 0.75>] } }
  pigment { wrinkles scale <0.5, 0.1, 0.5> color_map { [0.4 color rgbt 1] [0.8 color rgbt <1, 1, 1, 0.2>] } }
}
#ifndef (Depth) fog { fog_type 1 distance 120 color rgb <0.75, 0.82, 0.9> } #end
height_field
{
  function 200, 200 { pattern { granite scale 1.1 poly_wave 1.2 } }
  smooth
  translate <-0.5, 0, -0.5>
  scale <40, 3, 40>
  translate <0, -0.9, 12>
  texture
  {
    slope y
    texture_map
    {
      [0.80 pigment { granite scale 0.5 color_map { [0 color rgb <0.20, 0.16, 0.12>] [1 color rgb <0.8, 0.72, 0.65>] } }]
      [0.88 pigment { bozo scale 0.1 turbulence 0.4 color_map { [0 color rgb <0.18, 0.28, 0.08>] [1 color rgb <0.45, 0.48, 0.2>] } }]
    }
  }
}
plane { y, -0.35 pigment { color rgb <0.12, 0.2, 0.28> } normal { bumps 0.15 scale 0.1 } finish { diffuse 0.4 reflection 0.35 specular 0.4 } }
