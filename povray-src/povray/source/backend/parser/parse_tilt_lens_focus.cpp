// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens_focus.cpp
/// The items of `tilt_lens { ... }` that say where the focus lies.

#include "backend/parser/parse_tilt_lens.h"

#include <string>

#include "backend/frame.h"
#include "backend/parser/parse.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::Statement;

void TiltLensParser::ParseFocalPlane(Statement& s)
{
    s.family = FocusFamily::FocalPlane;
    PlaneBrace(LEFT_CURLY_TOKEN, "{");
    s.planeNormal = Vector("focal_plane");
    if (!(Length(s.planeNormal) > 0.0))
        ErrorAt(item, "focal_plane in tilt_lens has the normal <0, 0, 0>. A plane needs a direction; give "
                     "another normal.");
    s.planeNormal = Normalized(s.planeNormal);
    parser.Parse_Comma();
    s.planeDistance = Number("focal_plane's distance");
    PlaneBrace(RIGHT_CURLY_TOKEN, "}");
}

/// Parse_Begin and Parse_End would name the word by its token, and the block's words have none.
void TiltLensParser::PlaneBrace(int brace, const char* sign)
{
    parser.Get_Token();
    if (parser.Token.Token_Id == brace)
        return;
    const bool atEnd = parser.Token.Token_Id == END_OF_FILE_TOKEN;
    const std::string found = atEnd ? "the end of the file" : "'" + std::string(parser.Token.Token_String) + "'";
    ErrorAt(item, "Missing %s of focal_plane in tilt_lens: found %s in its place. Write it as focal_plane { "
                  "<normal>, distance }.", sign, found.c_str());
}

void TiltLensParser::ParseFocalPoints(Statement& s)
{
    s.family = FocusFamily::FocalPoints;
    for (int i = 0; i < 3; i++)
    {
        if (i > 0)
            parser.Parse_Comma();
        s.points[i] = Vector("focal_points");
    }
}

} // namespace pov
