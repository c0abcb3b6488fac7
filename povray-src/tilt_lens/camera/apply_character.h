// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file apply_character.h
/// Gives the ideal lens a real one's aberrations.

#ifndef TILT_LENS_APPLY_CHARACTER_H
#define TILT_LENS_APPLY_CHARACTER_H

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// @throws OpticsError  the picture folds back within the frame; the frame reaches behind the lens; the vignetting rim is narrower than
///                      the aperture
void ApplyCharacter(Lens& lens, const Statement& given);

} // namespace tilt_lens

#endif
