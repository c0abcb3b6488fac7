// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file inner_focus.h
/// Lenses that focus by moving groups of glass while the film stays (docs/lenses.md). A prescription may state distances between surfaces
/// for infinity and nearer focuses, states 0, 1, 2, ...; between states they are linear, and the state is solved for the wanted focus.
///
/// The film stands at the traced image of infinity of state 0, plus the last row's difference of thickness between the state and infinity.
/// Nearer than the last state or beyond infinity, as a tilted plane may need, the film moves.

#ifndef TILT_LENS_INNER_FOCUS_H
#define TILT_LENS_INNER_FOCUS_H

#include <functional>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// The lens with the state's thicknesses and fixed groups.
Prescription InState(const Prescription& prescription, double state);

/// mm from H' to an untilted lens's film.
double FilmPlaceOf(const Prescription& prescription, double state);

/// Distance of the focus from the first surface, mm, by paraxial rays; negative: beyond infinity.
double ObjectDistanceOf(const Prescription& prescription, double state);

/// The state that focuses without moving the film, or the nearest.
/// @param filmVergence  1/mm, for a focal length in mm: inverse distance from H' at which an ideal lens needs the film; negative infinity
///                      if no distance is large enough
double StateFor(const Prescription& prescription, const std::function<double(double focalLength)>& filmVergence);

/// Checks stated object distances against traced ones.
/// @param line  of the statement
/// @throws PrescriptionError
void RequireFocuses(const Prescription& prescription, int line);

} // namespace tilt_lens

#endif
