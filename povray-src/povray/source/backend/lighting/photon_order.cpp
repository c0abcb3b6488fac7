// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <vector>

#include "backend/frame.h"
#include "backend/lighting/photons.h"
#include "backend/lighting/photon_order.h"

#include "base/povdebug.h"

namespace pov
{

void OrderPhotons(PhotonMap& map)
{
    std::vector<Photon> photons(map.numPhotons);
    for (int i = 0; i < map.numPhotons; i++)
        photons[i] = PHOTON_AMF(map.head, i);
    const auto values = [](const Photon& p)
    { return std::tie(p.Loc[X], p.Loc[Y], p.Loc[Z], p.colour[0], p.colour[1], p.colour[2], p.colour[3], p.theta, p.phi, p.info); };
    std::sort(photons.begin(), photons.end(), [&](const Photon& a, const Photon& b) { return values(a) < values(b); });
    for (int i = 0; i < map.numPhotons; i++)
        PHOTON_AMF(map.head, i) = photons[i];
    std::srand(1);  // the C library's initial state
}

} // namespace pov
