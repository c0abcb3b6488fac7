// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/frame.h"
#include "backend/render/light_path.h"

#include "backend/shape/boxes.h"
#include "backend/shape/discs.h"
#include "backend/shape/planes.h"
#include "backend/shape/polygon.h"
#include "backend/shape/triangle.h"

// must be last
#include "base/povdebug.h"

namespace pov
{

bool LightPath::IsFlat(const ObjectBase& object)
{
    return typeid(object) == typeid(Box) || typeid(object) == typeid(Plane) || typeid(object) == typeid(Disc) ||
           typeid(object) == typeid(Polygon) || typeid(object) == typeid(Triangle);
}

} // namespace pov
