// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file inner_focus.h
/// Lenses that focus by moving groups of their glass, while the film stays.
///
/// A prescription may state the distances between its surfaces for infinity and for one or more nearer focuses. These are states 0,
/// 1, 2, ... of the lens; between two of them each distance changes evenly. Makers' cams differ from that between the states, and the
/// sharpness with them; the focus itself does not, because the state is sought in which the lens is focused where it is to be.
///
/// The film stands as far behind the last surface as the image of infinity does in state 0, and farther by what the thickness of the
/// last row is greater in the state than at infinity. Files state that back focus in few digits; with the traced one, state 0 is
/// focused at infinity exactly. What no state reaches, nearer than the last one or beyond infinity, as a turned plane may be, the
/// film's own way makes up for, as in a lens on bellows.

#ifndef TILT_LENS_INNER_FOCUS_H
#define TILT_LENS_INNER_FOCUS_H

#include <functional>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// The lens in a state: its rows' thicknesses are those of it, and no group moves any more.
Prescription InState(const Prescription& prescription, double state);

/// How far behind H' (mm) the film of an unturned lens stands in a state.
double FilmPlaceOf(const Prescription& prescription, double state);

/// From the first surface to what the lens is focused on in a state (mm), by rays near the axis; negative: beyond infinity.
double ObjectDistanceOf(const Prescription& prescription, double state);

/// The state in which a lens is focused without moving its film, or the nearest one to it.
/// @param filmVergence  for a focal length (mm) the inverse of the distance from H' (1/mm) at which the film of an ideal lens must stand;
///                      negative infinity where none is far enough
double StateFor(const Prescription& prescription, const std::function<double(double focalLength)>& filmVergence);

/// Whether glass and film are focused where the file says that they are.
/// @param line  that says so
/// @throws PrescriptionError
void RequireFocuses(const Prescription& prescription, int line);

} // namespace tilt_lens

#endif
