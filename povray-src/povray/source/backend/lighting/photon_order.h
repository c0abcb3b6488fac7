// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file photon_order.h
/// Photon maps that do not depend on threads. Each pair of a light and its target is shot by one thread, whichever
/// is free, with random numbers of its own (Trace::BeginPhotons); what the threads have then lies in the order of the
/// threads, on which the tree and the sums of light depend.

#ifndef POVRAY_BACKEND_PHOTON_ORDER_H
#define POVRAY_BACKEND_PHOTON_ORDER_H

namespace pov
{

class PhotonMap;

/// Puts the photons of a map that is not yet a tree into the order of their values, and begins anew the C library's
/// random numbers, by which the map's density is estimated.
void OrderPhotons(PhotonMap& map);

} // namespace pov

#endif
