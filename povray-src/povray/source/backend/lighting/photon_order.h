// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file photon_order.h
/// Makes photon maps independent of threads. Any free thread shoots the photons of a light and a target, with the random numbers of that
/// pair (Trace::BeginPhotons). The resulting order depends on the threads, and the tree and the sums of light depend on the order.

#ifndef POVRAY_BACKEND_PHOTON_ORDER_H
#define POVRAY_BACKEND_PHOTON_ORDER_H

namespace pov
{

class PhotonMap;

/// Sorts the photons of a map that is not yet a tree by their values. Also resets the C library's random numbers, from which the map's
/// density is estimated.
void OrderPhotons(PhotonMap& map);

} // namespace pov

#endif
