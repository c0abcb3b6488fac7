// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later
//
// Nakane et al., Fig. 9(c): a landscape, reverse tilt: the plane of sharp focus perpendicular to the ground.
//
//   ./render scenes/paper/landscape_c.pov +W960 +H720
//
// Look for: church, green, keep, poplars and the red balloon sharp from foot to top, and the look of a
//          model before and behind them.

#version 3.7;
global_settings { assumed_gamma 1 }
#include "landscape_objects.inc"

camera
{
  Landscape_Camera(16)
  tilt_lens { focal_plane { z, Village_Green.z } denoise Denoise }
}
