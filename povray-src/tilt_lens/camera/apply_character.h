// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file apply_character.h
/// The part of Solve() (optics.h) that makes an ideal lens a real one.

#ifndef TILT_LENS_APPLY_CHARACTER_H
#define TILT_LENS_APPLY_CHARACTER_H

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// Gives a solved ideal lens its distortion and field curvature.
/// @throws OpticsError  a picture that folds back within the frame, a frame that reaches behind the lens, a vignetting rim that
///                      is narrower than the aperture
void ApplyCharacter(Lens& lens, const Statement& given);

} // namespace tilt_lens

#endif
