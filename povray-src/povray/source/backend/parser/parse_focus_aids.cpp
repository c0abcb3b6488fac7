// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_focus_aids.cpp
/// The items of `tilt_lens { ... }` that draw focus aids.

#include "backend/parser/parse_tilt_lens.h"

#include <cmath>

#include "backend/frame.h"
#include "backend/parser/parse.h"

#include "base/povdebug.h"

namespace pov
{

void TiltLensParser::RequireAidsTogether(const tilt_lens::FocusAids& aids)
{
    if (aids.map && (aids.peaking || aids.planes))
        ErrorAt(item, "focus_map and %s in one tilt_lens: a tint would falsify the map's colours. "
                      "focus_peaking and show_planes may go together, focus_map stands alone; remove one.",
                aids.peaking ? "focus_peaking" : "show_planes");
}

void TiltLensParser::ParsePeaking(tilt_lens::FocusAids& aids)
{
    aids.peaking = true;
    parser.Get_Token();
    const TiltLensPlace before = Here();
    parser.Unget_Token();
    RGBColour colour;
    parser.Parse_Colour(colour);
    // upstream takes a missing colour for black
    parser.Get_Token();
    const TiltLensPlace after = Here();
    if (after.line == before.line && after.column == before.column && after.file == before.file)
        ErrorAt(item, "focus_peaking in tilt_lens has no colour: found '%s' in its place. It takes a colour, and "
                      "perhaps a comma and a number of pixels; write it as focus_peaking rgb <1, 0, 0>.",
                parser.Token.Token_String);
    parser.Unget_Token();
    aids.peakingColour = {colour.red(), colour.green(), colour.blue()};
    // the tint is light, which OpenEXR's half floats must hold
    const double kMost = 65504.0;
    for (double number : {colour.red(), colour.green(), colour.blue()})
        if (!(std::fabs(number) <= kMost))
            ErrorAt(item, "focus_peaking's colour in tilt_lens is <%g, %g, %g>. All three numbers must be finite and at "
                          "most %g, which is what pictures hold; check the expression.",
                    colour.red(), colour.green(), colour.blue(), kMost);
    parser.Get_Token();
    if (parser.Token.Token_Id == COMMA_TOKEN)
        aids.peakingPixels = PositiveNumber("focus_peaking's pixels");
    else
        parser.Unget_Token();
    RequireAidsTogether(aids);
}

/// A focus aid shows blur, of which a pinhole has none.
void TiltLensParser::RequireAperture(const Camera& camera)
{
    const TiltLensCamera& lens = camera.TiltLens;
    if (lens.aids.Any() && camera.Aperture == 0.0 && !lens.statement.fStop && !lens.statement.prescription &&
        lens.BlurLimitWord() == NULL)
        ErrorAt(lens.place, "%s in a camera without an aperture: everything is sharp, so there is nothing to "
                            "show. Give aperture or f_stop, or remove it.",
                lens.aids.peaking ? "focus_peaking" : lens.aids.map ? "focus_map" : "show_planes");
}

} // namespace pov
