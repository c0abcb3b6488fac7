// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Small bright discs, parallel to the film, on black: what a point becomes behind this lens. The
// experiment writes marks.inc: the array Marks of { middle, radius }, and the camera's numbers.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "marks.inc"

camera
{
  perspective
  location Eye
  right image_width/image_height*x
  look_at Target
  focal_point Through
  blur_samples Samples  variance 0
  tilt_lens
  {
    film_width Film_Width
    scene_unit Scene_Unit
    focal_length Focal_Length
    f_stop F_Stop
    tilt Tilt
    shift Shift
  }
}

// a sky, so that no samples are aimed at the discs: evenly spread ones measure such large discs better
sky_sphere { pigment { rgb 0 } }

#default { finish { ambient 0 diffuse 0 emission 1 } }

#for (I, 0, dimension_size(Marks, 1)-1)
  disc { Marks[I][0], Target-Eye, Marks[I][1].x pigment { color rgb 1 } }
#end
