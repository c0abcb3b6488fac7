// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file apply_prescription.h
/// The part of Solve() (optics.h) that replaces the ideal lens by glass.

#ifndef TILT_LENS_APPLY_PRESCRIPTION_H
#define TILT_LENS_APPLY_PRESCRIPTION_H

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

/// The statement of an ideal lens with the prescription's focal length and f-number; unchanged without a prescription.
Statement IdealStatement(const Statement& given);

/// The statement with its prescription in a focus state (inner_focus.h); unchanged if the lens moves no groups.
Statement WithGroups(const Statement& given, double state);

/// Gives a solved ideal lens the glass of its prescription.
/// @throws OpticsError  an aperture wider than the glass; a film within the glass
void ApplyPrescription(Lens& lens, const Statement& given);

} // namespace tilt_lens

#endif
