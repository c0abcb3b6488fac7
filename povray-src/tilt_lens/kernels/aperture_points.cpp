// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/concentric.h"
#include "tilt_lens/kernels/variant.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

void MapToDisc(const double* u, const double* v, double* a, double* b, int count)
{
    for (int i = 0; i < count; i += kVectorWidth<Doubles>)
    {
        Doubles pointA, pointB;
        OnDisc(Load<Doubles>(u + i), Load<Doubles>(v + i), pointA, pointB);
        Store(a + i, pointA);
        Store(b + i, pointB);
    }
}

void FindPositions(const double* u, const double* v, double edges, double* positions, double* radii)
{
    for (int i = 0; i < 4; i += kVectorWidth<Doubles>)
    {
        Doubles position, radius;
        FindPosition(Load<Doubles>(u + i), Load<Doubles>(v + i), edges, position, radius);
        Store(positions + i, position);
        Store(radii + i, radius);
    }
}

} // namespace tilt_lens::TILT_LENS_VARIANT
