// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_mirrors.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/scene/objects.h"
#include "backend/scene/plain_textures.h"
#include "backend/scene/tilt_lens_camera.h"
#include "backend/shape/boxes.h"
#include "backend/shape/planes.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

/// Brightest channel, between grazing and perpendicular rays.
double ReflectanceOf(const TEXTURE* texture)
{
    double greatest = 0.0;
    ForEachPlainTexture(texture, [&greatest](const TEXTURE& plain)
    {
        for (int c = pRED; c <= pBLUE && plain.Tnormal == NULL; c++)
            greatest = std::max(greatest, 0.5 * (double(plain.Finish->Reflection_Min[c]) + double(plain.Finish->Reflection_Max[c])));
    });
    return greatest;
}

tilt_lens::FlatMirror PlaneMirror(const Plane& plane, const Vec3& location, double reflectance)
{
    const Vec3 normal = FromPov(plane.Normal_Vector);
    const Vec3 foot = (-plane.Distance / Dot(normal, normal)) * normal;
    const Vec3 aside = Cross(normal, std::abs(normal.x) < std::abs(normal.y) ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0});
    const Vec3 corner = TransformedPoint(foot, plane.Trans);
    return {corner - location,
            {TransformedPoint(foot + aside, plane.Trans) - corner, TransformedPoint(foot + Cross(normal, aside), plane.Trans) - corner},
            true,
            reflectance};
}

/// Faces reflect towards the location, which may be within the box.
void AddFaces(const Box& box, const Vec3& location, double reflectance, std::vector<tilt_lens::FlatMirror>& mirrors)
{
    const Vec3 centre = TransformedPoint(0.5 * (FromPov(box.bounds[0]) + FromPov(box.bounds[1])), box.Trans);
    VECTOR eye = {location.x, location.y, location.z};
    const bool within = box.Inside(eye, NULL) != bool(Test_Flag(&box, INVERTED_FLAG));
    for (int axis = 0; axis < 3; axis++)
        for (int side = 0; side < 2; side++)
        {
            const auto corner = [&](int first, int second)
            {
                VECTOR v;
                v[axis] = box.bounds[side][axis];
                v[(axis + 1) % 3] = box.bounds[first][(axis + 1) % 3];
                v[(axis + 2) % 3] = box.bounds[second][(axis + 2) % 3];
                return TransformedPoint(FromPov(v), box.Trans);
            };
            const Vec3 at = corner(0, 0), along = corner(1, 0) - at, up = corner(0, 1) - at;
            const bool outwards = Dot(Cross(along, up), at - centre) > 0.0;
            mirrors.push_back({at - location, {outwards != within ? along : up, outwards != within ? up : along}, false, reflectance});
        }
}

} // namespace

void AddFlatMirrors(ObjectPtr object, const Vec3& location, std::vector<tilt_lens::FlatMirror>& mirrors)
{
    const Plane* plane = dynamic_cast<const Plane*>(object);
    const Box* box = dynamic_cast<const Box*>(object);
    if ((plane == NULL && box == NULL) || Test_Flag(object, NO_IMAGE_FLAG))
        return;
    const double reflectance = ReflectanceOf(object->Texture);
    if (!(reflectance > 0.0))
        return;
    if (plane != NULL)
        mirrors.push_back(PlaneMirror(*plane, location, reflectance));
    else
        AddFaces(*box, location, reflectance, mirrors);
}

} // namespace pov
