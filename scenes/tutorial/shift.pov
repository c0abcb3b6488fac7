// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Shift: a tall house from across the street, with vertical walls.
//
//   ./render scenes/tutorial/shift.pov +W640 +H360 +A0.2
//
// Look for: the camera looks straight ahead at eye level, so that the walls are parallel. The gables are in the picture
// because the frame is moved up over the film plane, instead of turning the camera up.
// Try: shift <0, 0>, which shows more street and no gables; shift <0, 0> with look_at <0, 9, 0>, with converging walls.
//
// Without an aperture this is a pinhole picture; a shift needs no aperture.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "town_streets.inc"

camera {
  perspective
  right x*image_width/image_height
  location <0, 1.7, -33>
  look_at <0, 1.7, 0>
  angle 66
  tilt_lens { shift <0, 8> }
}

light_source { <-150, 150, -110>*1000 color rgb <1.00, 0.91, 0.76>*1.9 parallel point_at 0 }
light_source { <90, 120, -100>*1000 color rgb <0.55, 0.72, 1.00>*0.4 parallel point_at 0 shadowless }
sky_sphere {
  pigment { gradient y color_map { [0 srgb <0.86, 0.92, 0.97>] [0.7 srgb <0.28, 0.52, 0.86>] } }
  pigment {
    bozo turbulence 0.6 octaves 5
    color_map { [0.5 srgbt <1, 1, 1, 1>] [0.8 srgbt <1, 1, 1, 0.15>] }
    scale <0.5, 0.16, 0.5>
  }
}

plane { y, 0 texture { T_Asphalt } }
box { <-80, -1, -4>, <80, 0.15, 40> texture { T_Pavement } }
Dashes(-60, 60, -10, no)

#macro House_At(X, W, Floors, Style, Shop, Roof, Wall)
  object {
    House(W, 11, Floors, Style, Shop, Roof_Textures[Roof], S)
    Town_Plain(Wall_Colours[Wall])
    translate <X, 0.15, 0>
  }
#end
House_At(-22.9, 8.4, 3, HOUSE_EAVES, no, 2, 5)
House_At(-14.5, 8.5, 4, HOUSE_GABLE, yes, 4, 7)
House_At(-6, 12, 4, HOUSE_STEPPED, yes, 1, 3)
House_At(6, 8.2, 4, HOUSE_GABLE, yes, 0, 1)
House_At(14.2, 9, 3, HOUSE_STEPPED, no, 2, 9)

Lamp_At(<-7.2, 0.15, -3.4>) Lamp_At(<7.4, 0.15, -3.4>)
Bush_At(<-13.5, 0.15, -0.9>) Bush_At(<5, 0.15, -0.9>) Bush_At(<13.6, 0.15, -0.9>)
Car_At(<-5.5, 0, -5.6>, 180)
Car_At(<12.5, 0, -5.6>, 180)
#for (I, 1, 9) Person_At(<-16+32*rand(S), 0.15, -1.8-1.4*rand(S)>) #end
