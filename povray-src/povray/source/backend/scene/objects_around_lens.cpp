// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/objects_around_lens.h"

#include <algorithm>
#include <cmath>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/shape/boxes.h"
#include "backend/shape/planes.h"
#include "backend/shape/spheres.h"
#include "tilt_lens/glass/glass_lens.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Along a world axis; an aperture picture fills the square around the disc.
double HalfExtent(double x, double y, bool square)
{
    return square ? std::fabs(x) + std::fabs(y) : std::hypot(x, y);
}

/// World coordinates, scene units.
struct LensBox
{
    double low[3], high[3];
};

/// Rays start on the first surface.
LensBox BoxOfGlass(const Camera& camera, const tilt_lens::SolvedLens& lens)
{
    const tilt_lens::GlassLens::Front front = lens.glass->FrontBox();
    const double normal[3] = {lens.normal.x, lens.normal.y, lens.normal.z};
    LensBox box;
    for (int i = X; i <= Z; i++)
    {
        const double across = front.radius * std::sqrt(std::max(0.0, 1.0 - normal[i] * normal[i]));
        const double first = front.low * normal[i], second = front.high * normal[i], room = 1e-9 * std::fabs(camera.Location[i]);
        box.low[i] = camera.Location[i] + lens.millimetre * (std::min(first, second) - across) - room;
        box.high[i] = camera.Location[i] + lens.millimetre * (std::max(first, second) + across) + room;
    }
    return box;
}

LensBox BoxOfLens(const Camera& camera, const tilt_lens::SolvedLens& lens)
{
    if (lens.glass)
        return BoxOfGlass(camera, lens);
    const bool square = camera.Bokeh != NULL;
    const double half[3] = {HalfExtent(lens.lensX.x, lens.lensY.x, square), HalfExtent(lens.lensX.y, lens.lensY.y, square),
                            HalfExtent(lens.lensX.z, lens.lensY.z, square)};
    LensBox box;
    for (int i = X; i <= Z; i++)
    {
        const double room = half[i] + 1e-9 * std::fabs(camera.Location[i]);
        box.low[i] = camera.Location[i] - room;
        box.high[i] = camera.Location[i] + room;
    }
    return box;
}

bool IsApart(const LensBox& box, const ObjectBase& object)
{
    for (int i = X; i <= Z; i++)
    {
        const double low = object.BBox.Lower_Left[i], high = low + object.BBox.Lengths[i];
        const double room = 1e-6 * (std::fabs(low) + std::fabs(high));  // objects' boxes are single precision
        if (box.high[i] + room < low || box.low[i] - room > high)
            return true;
    }
    return false;
}

int CornersInside(const LensBox& box, const ObjectBase& object)
{
    int inside = 0;
    for (int corner = 0; corner < 8; corner++)
    {
        const VECTOR point = {corner & 1 ? box.low[X] : box.high[X], corner & 2 ? box.low[Y] : box.high[Y],
                              corner & 4 ? box.low[Z] : box.high[Z]};
        inside += object.Inside(point, NULL);
    }
    return inside;
}

bool IsConvexSolid(const ObjectBase& object)
{
    const bool solid = dynamic_cast<const Sphere*>(&object) != NULL || dynamic_cast<const Box*>(&object) != NULL;
    return solid && !Test_Flag((&object), INVERTED_FLAG);
}

} // namespace

std::vector<ObjectAroundLens> ObjectsAroundLens(const Camera& camera, const tilt_lens::SolvedLens& lens, const SceneData& scene)
{
    const LensBox box = BoxOfLens(camera, lens);
    std::vector<ObjectAroundLens> objects;
    for (ObjectPtr object : scene.objects)
    {
        if (object->interior == NULL || IsApart(box, *object))
            continue;
        const bool plane = dynamic_cast<const Plane*>(object) != NULL;
        const int inside = plane || IsConvexSolid(*object) ? CornersInside(box, *object) : 0;
        if (plane && inside == 0)
            continue;  // a plane's outside is convex, so it contains no point of the lens's box
        objects.push_back({object, inside == 8});
    }
    return objects;
}

} // namespace pov
