// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_emitters.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/lighting/point.h"
#include "backend/scene/camera.h"
#include "backend/scene/scene.h"
#include "backend/shape/csg.h"
#include "backend/shape/spheres.h"
#include "backend/texture/texture.h"
#include "tilt_lens/settings.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

double LightOf(const TEXTURE* texture, const RGBColour& ambientLight)
{
    double brightest = 0.0;
    for (; texture != NULL; texture = reinterpret_cast<const TEXTURE*>(texture->Next))
    {
        if (texture->Type != PLAIN_PATTERN || texture->Finish == NULL || texture->Pigment == NULL)
            continue;
        const PIGMENT& pigment = *texture->Pigment;
        for (int c = pRED; c <= pBLUE; c++)
        {
            // a pattern's colours are seldom above white
            const double colour = pigment.Type == PLAIN_PATTERN ? pigment.colour[c] : 1.0;
            const double glow = texture->Finish->Emission[c] + texture->Finish->Ambient[c] * ambientLight[c];
            brightest = std::max(brightest, colour * glow);
        }
    }
    return brightest;
}

/// Bounding sphere, relative to the camera's location.
/// @param light, around  radiance of the object, greatest radiance around it
tilt_lens::Emitter EmitterOf(ObjectPtr object, const Camera& camera, double light, double around)
{
    const Vec3 location = FromPov(camera.Location);
    const Sphere* sphere = dynamic_cast<const Sphere*>(object);
    if (sphere != NULL && sphere->Trans == NULL)
        return {FromPov(sphere->Center) - location, sphere->Radius, light, around};
    const BBOX& box = object->BBox;
    const Vec3 half{0.5 * box.Lengths[X], 0.5 * box.Lengths[Y], 0.5 * box.Lengths[Z]};
    const Vec3 low{box.Lower_Left[X], box.Lower_Left[Y], box.Lower_Left[Z]};
    return {low + half - location, Length(half), light, around};
}

/// Radiance above which an object outshines lit surfaces, which are seldom brighter than the sum of the light sources. At most white;
/// white if radiosity or other objects light the scene.
double LeastRadiance(const SceneData& scene)
{
    double lights = 0.0;
    for (const auto* list : {&scene.lightSources, &scene.lightGroupLightSources})
        for (const LightSource* light : *list)
            lights += std::max({0.0, double(light->colour[pRED]), double(light->colour[pGREEN]), double(light->colour[pBLUE])});
    const bool known = lights > 0.0 && !scene.radiositySettings.radiosityEnabled;
    return known ? std::min(lights, tilt_lens::settings.greatestLitRadiance) : tilt_lens::settings.greatestLitRadiance;
}

void Collect(ObjectPtr object, const SceneData& scene, const Camera& camera, double leastRadiance,
             std::vector<tilt_lens::Emitter>& emitters)
{
    const CompoundObject* compound = dynamic_cast<const CompoundObject*>(object);
    if (compound != NULL && dynamic_cast<const CSGIntersection*>(object) == NULL)
    {
        for (ObjectPtr part : compound->children)
            Collect(part, scene, camera, leastRadiance, emitters);
        return;
    }
    if (object->BBox.Lengths[X] > CRITICAL_LENGTH)
        return;  // infinite: samples cannot miss it
    const double light = LightOf(object->Texture, scene.ambientLight);
    if (light > leastRadiance)
        emitters.push_back(EmitterOf(object, camera, light, leastRadiance));
}

} // namespace

std::vector<tilt_lens::Emitter> EmittersOf(const SceneData& scene, const Camera& camera)
{
    std::vector<tilt_lens::Emitter> emitters;
    const double leastRadiance = LeastRadiance(scene);
    for (ObjectPtr object : scene.objects)
        Collect(object, scene, camera, leastRadiance, emitters);
    return emitters;
}

} // namespace pov
