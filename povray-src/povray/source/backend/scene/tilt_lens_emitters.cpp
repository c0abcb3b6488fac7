// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_emitters.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/lighting/point.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects.h"
#include "backend/scene/plain_textures.h"
#include "backend/scene/scene.h"
#include "backend/scene/tilt_lens_highlights.h"
#include "backend/scene/tilt_lens_mirrors.h"
#include "backend/shape/csg.h"
#include "backend/shape/spheres.h"
#include "tilt_lens/settings.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

double LightOf(ObjectPtr object, const RGBColour& ambientLight)
{
    double brightest = 0.0;
    ForEachPlainTexture(object, [&](const TEXTURE& plain)
    {
        const RGBColour glow = GlowOf(*plain.Finish, ambientLight);
        if (plain.Pigment->Type == PLAIN_PATTERN)
            for (int c = pRED; c <= pBLUE; c++)
                brightest = std::max(brightest, double(plain.Pigment->colour[c]) * glow[c]);
        else if (const double pattern = BrightestColourOf(*plain.Pigment); std::isfinite(pattern))
            brightest = std::max(brightest, pattern * BrightestOf(glow));
        else
            brightest = std::max(brightest, BrightestOf(glow));
    });
    return brightest;
}

/// Bounding sphere, relative to the camera's location.
/// @param around  radiance around the object
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

bool IsInfinite(ObjectPtr object)
{
    return object->BBox.Lengths[X] > CRITICAL_LENGTH;
}

/// Greatest radiance without light sources; white if there is a sky or fog.
double RadianceOfBackground(const SceneData& scene)
{
    double brightest = BrightestOf(RGBColour(scene.backgroundColour));
    for (ObjectPtr object : scene.objects)
        if (IsInfinite(object))
            brightest = std::max(brightest, LightOf(object, scene.ambientLight));
    const bool sky = scene.skysphere != NULL || scene.fog != NULL;
    return sky ? std::max(brightest, tilt_lens::Settings::greatestLitRadiance) : brightest;
}

/// Above this radiance, an object outshines lit surfaces, or the background where nothing is lit. With radiosity all objects light the
/// scene, so it is white.
double LeastRadiance(const SceneData& scene)
{
    double lights = 0.0;
    for (const auto* list : {&scene.lightSources, &scene.lightGroupLightSources})
        for (const LightSource* light : *list)
            lights += BrightestOf(light->colour);
    if (scene.radiositySettings.radiosityEnabled)
        return tilt_lens::Settings::greatestLitRadiance;
    const double around = lights > 0.0 ? tilt_lens::Settings::litShare * lights : RadianceOfBackground(scene);
    return std::min(around, tilt_lens::Settings::greatestLitRadiance);
}

/// Visits the parts of unions in place of these.
template<class Objects, class Visit>
void ForEachObject(const Objects& objects, const Visit& visit)
{
    for (ObjectPtr object : objects)
    {
        const CompoundObject* compound = dynamic_cast<const CompoundObject*>(object);
        if (compound != NULL && dynamic_cast<const CSGIntersection*>(object) == NULL)
            ForEachObject(compound->children, visit);
        else
            visit(object);
    }
}

class Collector
{
  public:
    Collector(const SceneData& scene, const Camera& camera) : scene(scene), camera(camera), leastRadiance(LeastRadiance(scene)) {}

    void Add(ObjectPtr object)
    {
        if (IsInfinite(object))
            return;  // samples cannot miss it
        AddHighlights(object, scene, camera, leastRadiance, seen);
        const double light = LightOf(object, scene.ambientLight);
        if (!(light > leastRadiance))
            return;
        const tilt_lens::Emitter emitter = EmitterOf(object, camera, light, leastRadiance);
        if (!Test_Flag(object, NO_IMAGE_FLAG))
            seen.push_back(emitter);
        if (!Test_Flag(object, NO_REFLECTION_FLAG))
            reflected.push_back(emitter);
    }

    std::vector<tilt_lens::Emitter> Emitters() const
    {
        std::vector<tilt_lens::Emitter> all = seen;
        std::vector<tilt_lens::FlatMirror> mirrors;
        if (!reflected.empty())
            ForEachObject(scene.objects, [&](ObjectPtr object) { AddFlatMirrors(object, FromPov(camera.Location), mirrors); });
        for (const tilt_lens::Emitter& image : tilt_lens::MirrorImages(reflected, mirrors, camera.TiltLens.lens->diameter))
            all.push_back(image);
        return all;
    }

  private:
    const SceneData& scene;
    const Camera& camera;
    double leastRadiance;
    std::vector<tilt_lens::Emitter> seen, reflected;
};

} // namespace

std::vector<tilt_lens::Emitter> EmittersOf(const SceneData& scene, const Camera& camera)
{
    Collector collector(scene, camera);
    ForEachObject(scene.objects, [&collector](ObjectPtr object) { collector.Add(object); });
    return collector.Emitters();
}

} // namespace pov
