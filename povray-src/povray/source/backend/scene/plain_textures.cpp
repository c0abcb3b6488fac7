// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/plain_textures.h"

#include <cmath>

#include "backend/colour/colour.h"
#include "backend/pattern/pattern.h"
#include "backend/support/imageutil.h"
#include "base/image/image.h"

#include "base/povdebug.h"

namespace pov
{

double BrightestColourOf(const PIGMENT& pigment)
{
    if (pigment.Type == PLAIN_PATTERN)
        return BrightestOf(RGBColour(pigment.colour));
    if (pigment.Type == BITMAP_PATTERN)
        return pigment.Vals.image->data->GetImageDataType() == Image::RGBFT_Float ? HUGE_VAL : 1.0;
    const BLEND_MAP* const map = pigment.Blend_Map;
    if (map == NULL)
        return 1.0;
    double brightest = 0.0;
    for (int i = 0; i < map->Number_Of_Entries; i++)
        brightest = std::max(brightest, map->Type == COLOUR_TYPE ? BrightestOf(RGBColour(Colour(map->Blend_Map_Entries[i].Vals.colour)))
                                                                 : BrightestColourOf(*map->Blend_Map_Entries[i].Vals.Pigment));
    return brightest;
}

} // namespace pov
