// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 9(d): a landscape, as (c) with twice the aperture.
//
//   ./render scenes/paper/landscape_d.pov +W960 +H720
//
// Look for: the same plane sharp, all else twice as blurred as in (c).

#version 3.7;
global_settings { assumed_gamma 1 }
#include "landscape_objects.inc"

camera
{
  Landscape_Camera(32)
  tilt_lens { focal_plane { z, Village_Green.z } denoise Denoise }
}
