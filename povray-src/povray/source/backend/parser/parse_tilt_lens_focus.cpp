// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens_focus.cpp
/// The items of `tilt_lens { ... }` that say where the focus lies.

#include "backend/parser/parse_tilt_lens.h"

#include <cstring>
#include <string>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_words.h"
#include "backend/scene/objects.h"
#include "tilt_lens/lens_camera/sharp_points.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::kFewestSharpPoints;
using tilt_lens::kMostSharpPoints;
using tilt_lens::Statement;
using tilt_lens::Vec3;

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

void TiltLensParser::ParseFocalPoints(TiltLensCamera& lens)
{
    lens.statement.family = FocusFamily::FocalPoints;
    lens.pointTargets.resize(3);
    for (int i = 0; i < 3; i++)
    {
        if (i > 0)
            parser.Parse_Comma();
        if (!ParseTarget(lens.pointTargets[i]))
            lens.statement.points[i] = Vector("focal_points");
    }
}

void TiltLensParser::ParseSharpPoints(TiltLensCamera& lens)
{
    lens.statement.family = FocusFamily::SharpPoints;
    std::vector<Vec3>& points = lens.statement.sharpPoints;
    do
    {
        if (points.size() == kMostSharpPoints)
            ErrorAt(item, "sharp_points in tilt_lens has more than %d points. %d to %d are allowed; leave out those that lie between "
                          "others.", kMostSharpPoints, kFewestSharpPoints, kMostSharpPoints);
        lens.pointTargets.emplace_back();
        points.push_back(ParseTarget(lens.pointTargets.back()) ? Vec3() : Vector("sharp_points"));
    } while (NextIsComma());
    parser.Get_Token();
    if (parser.Token.Token_Id == LEFT_ANGLE_TOKEN)
        ErrorAt(item, "sharp_points in tilt_lens: found a point without a comma before it, behind %d. Write a comma between points, as in "
                      "sharp_points A, B, C.", int(points.size()));
    parser.Unget_Token();
    if (points.size() < kFewestSharpPoints)
        ErrorAt(item, "sharp_points in tilt_lens has %d point%s. %d to %d are allowed, with commas between them; give more, or focal_point "
                      "in the camera for one.", int(points.size()), points.size() == 1 ? "" : "s", kFewestSharpPoints, kMostSharpPoints);
}

/// Takes `focus_on` or `focus_at` with its value, unless the scene has an identifier of that name; tells whether it did.
bool TiltLensParser::ParseTarget(FocusTarget& target)
{
    parser.Get_Token();
    const std::string word = parser.Token.Token_Id == IDENTIFIER_TOKEN ? parser.Token.Token_String : "";
    if (word == "focus_on")
        ParseFocusOn(target);
    else if (word == "focus_at")
        ParseFocusAt(target);
    else
    {
        parser.Unget_Token();
        return false;
    }
    return true;
}

void TiltLensParser::ParseFocusAt(FocusTarget& target)
{
    RequireValue("focus_at");
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    if (terms != 2 || !(v[X] >= 0.0 && v[X] <= 1.0 && v[Y] >= 0.0 && v[Y] <= 1.0))
        ErrorAt(item, "focus_at in tilt_lens: found %s%g, %g%s. It takes a place in the picture, from <0, 0> in the lower left "
                      "to <1, 1> in the upper right corner; write it as <right, up>.", terms == 2 ? "<" : "a value of other than "
                      "two numbers, <", v[X], v[Y], terms > 2 ? ", ...>" : ">");
    target.kind = FocusTarget::Picture;
    target.x = v[X];
    target.y = v[Y];
}

void TiltLensParser::ParseFocusOn(FocusTarget& target)
{
    parser.Get_Token();
    if (parser.Token.Token_Id != OBJECT_ID_TOKEN)
        ErrorAt(item, "focus_on in tilt_lens: found '%s' in place of an object. It takes the identifier of an object that was "
                      "declared before the camera, as in #declare Ball = sphere { 0, 1 }, and then focus_on Ball.",
                parser.Token.Token_Id == END_OF_FILE_TOKEN ? "the end of the file" : parser.Token.Token_String);
    target.kind = FocusTarget::Object;
    // of an element of an array the index is what was read last
    target.name = std::strcmp(parser.Token.Token_String, "]") == 0 ? "an array's element" : parser.Token.Token_String;
    target.object = shared_ptr<ObjectBase>(Copy_Object(static_cast<ObjectPtr>(parser.Token.Data)),
                                           [](ObjectPtr object) { Destroy_Object(object); });
}

} // namespace pov
