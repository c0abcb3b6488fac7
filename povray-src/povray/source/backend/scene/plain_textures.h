// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_PLAIN_TEXTURES_H
#define POVRAY_BACKEND_PLAIN_TEXTURES_H

#include <algorithm>

#include "backend/frame.h"
#include "backend/shape/mesh.h"
#include "backend/texture/texture.h"

namespace pov
{

inline double BrightestOf(const RGBColour& colour)
{
    return std::max({0.0, double(colour[pRED]), double(colour[pGREEN]), double(colour[pBLUE])});
}

/// Radiance of a white surface without light sources.
inline RGBColour GlowOf(const FINISH& finish, const RGBColour& ambientLight)
{
    return finish.Emission + finish.Ambient * ambientLight;
}

/// Brightest channel of a pigment, 1 is white. It is 1 for patterns with their own colours, and infinite for images with high dynamic
/// range.
double BrightestColourOf(const PIGMENT& pigment);

/// Visits layers, and entries of maps and of lists.
template<typename Visit>
void ForEachPlainTexture(const TEXTURE* texture, const Visit& visit)
{
    for (; texture != NULL; texture = reinterpret_cast<const TEXTURE*>(texture->Next))
    {
        if (texture->Type == PLAIN_PATTERN && texture->Finish != NULL && texture->Pigment != NULL)
            visit(*texture);
        const BLEND_MAP* map = texture->Type == PLAIN_PATTERN ? NULL : texture->Blend_Map;
        for (int i = 0; map != NULL && map->Type == TEXTURE_TYPE && i < map->Number_Of_Entries; i++)
            ForEachPlainTexture(map->Blend_Map_Entries[i].Vals.Texture, visit);
        for (const TEXTURE* material = texture->Materials; material != NULL; material = material->Next_Material)
            ForEachPlainTexture(material, visit);
    }
}

/// Visits the textures of an object, and of the triangles of a mesh.
template<typename Visit>
void ForEachPlainTexture(ObjectPtr object, const Visit& visit)
{
    ForEachPlainTexture(object->Texture, visit);
    const Mesh* mesh = dynamic_cast<const Mesh*>(object);
    for (long i = 0; mesh != NULL && i < mesh->Number_Of_Textures; i++)
        ForEachPlainTexture(mesh->Textures[i], visit);
}

} // namespace pov

#endif
