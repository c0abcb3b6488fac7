// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file inner_focus.h
/// Lenses that focus by moving groups of glass while the film stays.
///
/// A prescription may state the distances between its surfaces for infinity and for one or more nearer focuses: states 0, 1, 2, ...
/// Between two states each distance is interpolated linearly. Real cams differ there, and so does the sharpness, but not the focus:
/// the state is solved for the wanted focus.
///
/// The film stands at the image of infinity of state 0, plus the difference of the last row's thickness between the state and infinity.
/// Files state that back focus in few digits; with the traced one, state 0 is focused at infinity exactly. For a focus nearer than the last
/// state, or beyond infinity, as a tilted plane may need, the film moves, as in a lens on bellows.

#ifndef TILT_LENS_INNER_FOCUS_H
#define TILT_LENS_INNER_FOCUS_H

#include <functional>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// The lens in a state: the rows' thicknesses are those of the state, and no group moves any more.
Prescription InState(const Prescription& prescription, double state);

/// Distance in mm from H' to the film of an untilted lens in a state.
double FilmPlaceOf(const Prescription& prescription, double state);

/// Distance in mm from the first surface to the focus in a state, by paraxial rays; negative: beyond infinity.
double ObjectDistanceOf(const Prescription& prescription, double state);

/// The state that focuses the lens without moving the film, or the nearest to it.
/// @param filmVergence  for a focal length (mm), the inverse of the distance from H' (1/mm) at which an ideal lens needs the film;
///     negative infinity if no distance is large enough
double StateFor(const Prescription& prescription, const std::function<double(double focalLength)>& filmVergence);

/// Checks the stated object distances against traced ones.
/// @param line  that states them
/// @throws PrescriptionError
void RequireFocuses(const Prescription& prescription, int line);

}  // namespace tilt_lens

#endif
