// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file special_items.cpp
/// Items of `tilt_lens { ... }` whose values are not numbers with commas.

#include "backend/parser/item_reader.h"

#include <cmath>
#include <cstring>
#include <memory>

#include <boost/scoped_ptr.hpp>

#include "backend/scene/objects.h"
#include "backend/support/fileutil.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/prescription.h"
#include "tilt_lens/lens_camera/sharp_points.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusAids;
using tilt_lens::kFewestSharpPoints;
using tilt_lens::kMostSharpPoints;
using tilt_lens::Prescription;
using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

/// Parse_Begin and Parse_End would name the word by its token, which it lacks.
void ReadBrace(Parser& parser, int brace, const char* sign)
{
    parser.Get_Token();
    if (parser.Token.Token_Id == brace)
        return;
    const bool atEnd = parser.Token.Token_Id == END_OF_FILE_TOKEN;
    const std::string found = atEnd ? "the end of the file" : "'" + std::string(parser.Token.Token_String) + "'";
    Refuse("Missing %s of focal_plane in tilt_lens: found %s in its place. Write it as focal_plane { <normal>, distance }.", sign,
           found.c_str());
}

/// Also `focus_on` or `focus_at`, unless declared by the scene.
Vec3 ReadPoint(ItemReader& reader, std::vector<FocusTarget>& targets)
{
    TiltLensCamera other;
    reader.parser.Get_Token();
    const std::string word = reader.parser.Token.Token_Id == IDENTIFIER_TOKEN ? reader.parser.Token.Token_String : "";
    const bool isTarget = word == "focus_on" || word == "focus_at";
    if (isTarget)
        ItemReader(reader.parser, *FindTiltLensItem(word)).Read(other);
    else
        reader.parser.Unget_Token();
    targets.push_back(other.focusTarget);
    return isTarget ? Vec3() : reader.Vector();
}

/// Bytes; the largest collections of lenses have a tenth.
const std::size_t kMostBytes = 4u << 20;

/// `FILE#NAME` chooses a lens of a JSON collection.
struct FileChoice
{
    std::string file, name;

    explicit FileChoice(const std::string& written) : file(written)
    {
        const std::size_t at = written.rfind(".json#");
        if (at == std::string::npos)
            return;
        file = written.substr(0, at + 5);
        name = written.substr(at + 6);
    }
};

std::string ReadWhole(Parser& parser, const std::string& name)
{
    UCS2String found;
    boost::scoped_ptr<pov_base::IStream> stream(
        Locate_File(&parser, parser.sceneData, ASCIItoUCS2String(name.c_str()), POV_File_Text_User, found, false));
    if (!stream)
        Refuse("prescription \"%s\" in tilt_lens: the file cannot be found or opened. It is searched for beside the scene and in the "
               "folders of +L; mend the name or add its folder.",
               name.c_str());
    std::string text;
    for (int c = stream->Read_Byte(); !stream->eof() && c != EOF; c = stream->Read_Byte())
    {
        text.push_back(char(c));
        if (text.size() > kMostBytes)
            Refuse("prescription \"%s\" in tilt_lens: the file has more than %u bytes. A lens takes a few hundred; is it the right file?",
                   name.c_str(), unsigned(kMostBytes));
    }
    return text;
}

std::string ReadName(Parser& parser)
{
    parser.Get_Token();
    const int token = parser.Token.Token_Id;
    const std::string found = parser.Token.Token_String;
    parser.Unget_Token();
    for (const int other : {RIGHT_CURLY_TOKEN, LEFT_CURLY_TOKEN, COMMA_TOKEN, END_OF_FILE_TOKEN, IDENTIFIER_TOKEN, FLOAT_FUNCT_TOKEN,
                            LEFT_ANGLE_TOKEN, SEMI_COLON_TOKEN})
        if (token == other)
            Refuse("prescription in tilt_lens has no file: found '%s' in its place. Write it as prescription \"FILE\", or with the focal "
                   "length in mm that the lens is made larger or smaller to, prescription \"FILE\", 50.",
                   found.c_str());
    char* text = parser.Parse_C_String(true);
    const std::string name(text);
    POV_FREE(text);
    return name;
}

} // namespace

void ReadShift(ItemReader& reader, TiltLensCamera& lens)
{
    EXPRESS v;
    const int terms = reader.Numbers("shift", v);
    // one number would mean both directions
    if (!(terms == 2 || (terms == 3 && v[Z] == 0.0)))
        Refuse("shift in tilt_lens: found a value of %d numbers. It takes two, in millimetres; write it as <right, up>.", terms);
    if (!std::isfinite(v[X]) || !std::isfinite(v[Y]))
        Refuse("shift <%g, %g> in tilt_lens. Both numbers must be finite; check the expression.", v[X], v[Y]);
    lens.statement.shiftRight = v[X];
    lens.statement.shiftUp = v[Y];
}

void ReadPrescription(ItemReader& reader, TiltLensCamera& lens)
{
    const std::string written = ReadName(reader.parser);
    const FileChoice choice(written);
    try
    {
        Prescription prescription = tilt_lens::ReadPrescription(ReadWhole(reader.parser, choice.file), choice.name);
        const double focalLength = tilt_lens::GlassLens(prescription).Cardinal().focalLength;
        if (reader.NextIsComma())
            prescription = tilt_lens::Scaled(prescription, reader.Number("prescription's focal length", kPositive) / focalLength);
        lens.statement.prescription = std::make_shared<const Prescription>(prescription);
    }
    catch (const tilt_lens::PrescriptionError& error)
    {
        const std::string line = error.line > 0 ? ", line " + std::to_string(error.line) : "";
        Refuse("prescription \"%s\" in tilt_lens%s: found %s", written.c_str(), line.c_str(), error.what());
    }
}

void ReadFocalPlane(ItemReader& reader, TiltLensCamera& lens)
{
    Statement& s = lens.statement;
    ReadBrace(reader.parser, LEFT_CURLY_TOKEN, "{");
    s.planeNormal = reader.Vector();
    if (!(Length(s.planeNormal) > 0.0))
        Refuse("focal_plane in tilt_lens has the normal <0, 0, 0>. A plane needs a direction; give another normal.");
    s.planeNormal = Normalized(s.planeNormal);
    reader.parser.Parse_Comma();
    s.planeDistance = reader.Number("focal_plane's distance", kFinite);
    ReadBrace(reader.parser, RIGHT_CURLY_TOKEN, "}");
}

void ReadFocalPoints(ItemReader& reader, TiltLensCamera& lens)
{
    for (Vec3& point : lens.statement.points)
    {
        if (&point != lens.statement.points)
            reader.parser.Parse_Comma();
        point = ReadPoint(reader, lens.pointTargets);
    }
}

void ReadSharpPoints(ItemReader& reader, TiltLensCamera& lens)
{
    std::vector<Vec3>& points = lens.statement.sharpPoints;
    do
    {
        if (points.size() == kMostSharpPoints)
            Refuse("sharp_points in tilt_lens has more than %d points. %d to %d are allowed; leave out those that lie between others.",
                   kMostSharpPoints, kFewestSharpPoints, kMostSharpPoints);
        points.push_back(ReadPoint(reader, lens.pointTargets));
    }
    while (reader.NextIsComma());
    Parser& parser = reader.parser;
    parser.Get_Token();
    if (parser.Token.Token_Id == LEFT_ANGLE_TOKEN)
        Refuse("sharp_points in tilt_lens: found a point without a comma before it, behind %d. Write a comma between points, as in "
               "sharp_points A, B, C.",
               int(points.size()));
    parser.Unget_Token();
    if (points.size() < kFewestSharpPoints)
        Refuse("sharp_points in tilt_lens has %d point%s. %d to %d are allowed, with commas between them; give more, or focal_point in the "
               "camera for one.",
               int(points.size()), points.size() == 1 ? "" : "s", kFewestSharpPoints, kMostSharpPoints);
}

void ReadFocusAt(ItemReader& reader, TiltLensCamera& lens)
{
    EXPRESS v;
    const int terms = reader.Numbers("focus_at", v);
    if (terms != 2 || !(v[X] >= 0.0 && v[X] <= 1.0 && v[Y] >= 0.0 && v[Y] <= 1.0))
        Refuse("focus_at in tilt_lens: found %s<%g, %g%s>. It takes a place in the picture, from <0, 0> in the lower left to <1, 1> in the "
               "upper right corner; write it as <right, up>.",
               terms == 2 ? "" : "a value of other than two numbers, ", v[X], v[Y], terms > 2 ? ", ..." : "");
    lens.focusTarget.kind = FocusTarget::Picture;
    lens.focusTarget.x = v[X];
    lens.focusTarget.y = v[Y];
}

void ReadFocusOn(ItemReader& reader, TiltLensCamera& lens)
{
    Parser& parser = reader.parser;
    FocusTarget& target = lens.focusTarget;
    parser.Get_Token();
    if (parser.Token.Token_Id != OBJECT_ID_TOKEN)
        Refuse("focus_on in tilt_lens: found '%s' in place of an object. It takes the identifier of an object that was declared before the "
               "camera, as in #declare Ball = sphere { 0, 1 }, and then focus_on Ball.",
               parser.Token.Token_Id == END_OF_FILE_TOKEN ? "the end of the file" : parser.Token.Token_String);
    target.kind = FocusTarget::Object;
    // the last token of an array's element is its index
    target.name = std::strcmp(parser.Token.Token_String, "]") == 0 ? "an array's element" : parser.Token.Token_String;
    target.object = shared_ptr<ObjectBase>(Copy_Object(static_cast<ObjectPtr>(parser.Token.Data)),
                                           [](ObjectPtr object) { Destroy_Object(object); });
}

void ReadFocusPeaking(ItemReader& reader, TiltLensCamera& lens)
{
    Parser& parser = reader.parser;
    FocusAids& aids = lens.aids;
    aids.peaking = true;
    parser.Get_Token();
    const Parser::Token_Struct before = parser.Token;
    parser.Unget_Token();
    RGBColour colour;
    parser.Parse_Colour(colour);
    // upstream takes a missing colour for black
    parser.Get_Token();
    const Parser::Token_Struct& after = parser.Token;
    if (after.Token_File_Pos.lineno == before.Token_File_Pos.lineno && after.Token_Col_No == before.Token_Col_No &&
        after.FileHandle == before.FileHandle)
        Refuse("focus_peaking in tilt_lens has no colour: found '%s' in its place. It takes a colour, and perhaps a comma and a number of "
               "pixels; write it as focus_peaking rgb <1, 0, 0>.",
               after.Token_String);
    parser.Unget_Token();
    aids.peakingColour = {colour.red(), colour.green(), colour.blue()};
    // OpenEXR's half floats must hold the tint
    const double kMost = 65504.0;
    for (double number : {colour.red(), colour.green(), colour.blue()})
        if (!(std::fabs(number) <= kMost))
            Refuse("focus_peaking's colour in tilt_lens is <%g, %g, %g>. All three numbers must be finite and at most %g, which is what "
                   "pictures hold; check the expression.",
                   colour.red(), colour.green(), colour.blue(), kMost);
    if (reader.NextIsComma())
        aids.peakingPixels = reader.Number("focus_peaking's pixels", kPositive);
}

} // namespace pov
