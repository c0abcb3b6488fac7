// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file apply_prescription.h
/// The part of Solve() (optics.h) that gives a lens its glass.

#ifndef TILT_LENS_APPLY_PRESCRIPTION_H
#define TILT_LENS_APPLY_PRESCRIPTION_H

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// What the statement says of an ideal lens with the focal length and the f-number of its prescription; a statement without one
/// stays as it is.
Statement IdealStatement(const Statement& given);

/// The statement with its prescription in a state of focus (inner_focus.h); one whose lens moves no groups stays as it is.
Statement WithGroups(const Statement& given, double state);

/// Gives a solved ideal lens the glass of its prescription.
/// @throws OpticsError  an aperture that is wider than the glass, a film that lies within the glass
void ApplyPrescription(Lens& lens, const Statement& given);

} // namespace tilt_lens

#endif
