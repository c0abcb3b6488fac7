// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file photon_order.h
/// Makes photon maps, their tree and sums of light, independent of the order of threads.

#ifndef POVRAY_BACKEND_PHOTON_ORDER_H
#define POVRAY_BACKEND_PHOTON_ORDER_H

namespace pov
{

class PhotonMap;

/// Call before a map becomes a tree. Resets the C library's random numbers.
void OrderPhotons(PhotonMap& map);

} // namespace pov

#endif
