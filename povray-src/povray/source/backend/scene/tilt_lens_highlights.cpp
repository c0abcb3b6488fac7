// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_highlights.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/lighting/point.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects.h"
#include "backend/scene/plain_textures.h"
#include "backend/scene/scene.h"
#include "backend/scene/tilt_lens_camera.h"
#include "backend/shape/spheres.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

struct Gloss
{
    double peak = 0.0, exponent = 0.0;
};

/// The stronger of `specular` and `phong`. Phong's angle is twice that of the normal.
Gloss GlossOf(const TEXTURE* texture)
{
    Gloss gloss;
    ForEachPlainTexture(texture, [&gloss](const TEXTURE& plain)
    {
        const FINISH& finish = *plain.Finish;
        if (finish.Specular > gloss.peak)
            gloss = {finish.Specular, finish.Roughness};
        if (finish.Phong > gloss.peak)
            gloss = {finish.Phong, 4.0 * finish.Phong_Size};
    });
    return gloss;
}

} // namespace

void AddHighlights(ObjectPtr object, const SceneData& scene, const Camera& camera, double around, std::vector<tilt_lens::Emitter>& emitters)
{
    const Sphere* sphere = dynamic_cast<const Sphere*>(object);
    if (sphere == NULL || sphere->Trans != NULL || Test_Flag(object, NO_IMAGE_FLAG))
        return;
    const Gloss gloss = GlossOf(object->Texture);
    if (!(gloss.peak > 0.0))
        return;
    const tilt_lens::Vec3 location = FromPov(camera.Location);
    for (const LightSource* light : scene.lightSources)
    {
        if (light->Light_Type == FILL_LIGHT_SOURCE)
            continue;  // makes no highlights
        const double peak = gloss.peak * BrightestOf(light->colour);
        const std::optional<tilt_lens::Emitter> highlight = tilt_lens::HighlightOf(
            {FromPov(sphere->Center) - location, sphere->Radius, peak, gloss.exponent, around}, FromPov(light->Center) - location,
            camera.TiltLens.lens->diameter);
        if (highlight)
            emitters.push_back(*highlight);
    }
}

} // namespace pov
