// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file scene_attributes.h
/// Attributes of the parser's final message.

#ifndef POVRAY_BASE_SCENE_ATTRIBUTES_H
#define POVRAY_BASE_SCENE_ATTRIBUTES_H

namespace pov_base
{

enum
{
    kPOVAttrib_TiltLens = 'TilL'  ///< bool: the camera has a `tilt_lens` block
};

} // namespace pov_base

#endif
