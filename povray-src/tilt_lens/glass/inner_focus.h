// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file inner_focus.h
/// Lenses that focus by moving groups of glass (docs/lenses.md, "Focus"). States 0, 1, 2, ... are infinity and the stated
/// nearer focuses; distances are linear in between. Beyond these focuses the film moves.

#ifndef TILT_LENS_INNER_FOCUS_H
#define TILT_LENS_INNER_FOCUS_H

#include <functional>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

Prescription InState(const Prescription& prescription, double state);

/// mm from H', without tilt.
double FilmPlaceOf(const Prescription& prescription, double state);

/// From the first surface, mm, by paraxial rays; negative: beyond infinity.
double ObjectDistanceOf(const Prescription& prescription, double state);

/// The state that focuses without moving the film, or the nearest.
/// @param filmVergence  inverse distance from H', 1/mm, at which an ideal lens of this focal length, mm, needs the film
double StateFor(const Prescription& prescription, const std::function<double(double focalLength)>& filmVergence);

/// @throws PrescriptionError  stated object distances differ from traced ones
void RequireFocuses(const Prescription& prescription, int line);

} // namespace tilt_lens

#endif
