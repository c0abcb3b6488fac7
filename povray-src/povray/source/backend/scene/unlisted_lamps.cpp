// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/unlisted_lamps.h"

#include <algorithm>

#include "backend/frame.h"
#include "backend/interior/interior.h"
#include "backend/scene/atmosph.h"
#include "backend/scene/objects.h"
#include "backend/scene/plain_textures.h"
#include "backend/scene/scene.h"
#include "backend/shape/csg.h"
#include "tilt_lens/settings.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

bool Outshines(double glow, const PIGMENT& pigment)
{
    return pigment.Type != PLAIN_PATTERN && glow > 0.0 && glow * BrightestColourOf(pigment) > tilt_lens::Settings::searchRadiance;
}

bool SkyOutshines(const SKYSPHERE* sky)
{
    for (int i = 0; sky != NULL && i < sky->Count; i++)
        if (Outshines(BrightestOf(sky->Emission), *sky->Pigments[i]))
            return true;
    return false;
}

class Clues
{
  public:
    Clues(const SceneData& scene, bool emitters) : scene(scene), emitters(emitters) {}

    bool Any(const std::vector<ObjectPtr>& objects) const
    {
        return std::any_of(objects.begin(), objects.end(), [this](ObjectPtr object) { return In(object); });
    }

  private:
    const SceneData& scene;
    const bool emitters;

    bool In(ObjectPtr object) const
    {
        const CompoundObject* const compound = dynamic_cast<const CompoundObject*>(object);
        if (compound != NULL && Any(compound->children))
            return true;
        if (emitters && object->interior != NULL && object->interior->IOR != 1.0)
            return true;
        bool outshines = false;
        ForEachPlainTexture(object, [&](const TEXTURE& plain)
        { outshines = outshines || Outshines(BrightestOf(GlowOf(*plain.Finish, scene.ambientLight)), *plain.Pigment); });
        return outshines;
    }
};

} // namespace

bool MayShowUnlistedLamps(const SceneData& scene, const std::vector<tilt_lens::Emitter>& emitters)
{
    const bool bright = std::any_of(emitters.begin(), emitters.end(), [](const tilt_lens::Emitter& emitter)
    { return emitter.radiance > tilt_lens::Settings::searchRadiance; });
    return SkyOutshines(scene.skysphere) || Clues(scene, bright).Any(scene.objects);
}

} // namespace pov
