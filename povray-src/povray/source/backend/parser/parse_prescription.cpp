// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_prescription.cpp
/// The item `prescription` of `tilt_lens { ... }` and its conflicts with other items.

#include "backend/parser/parse_tilt_lens.h"

#include <cstdlib>
#include <memory>

#include <boost/scoped_ptr.hpp>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/support/fileutil.h"
#include "tilt_lens/math/numbers.h"
#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/prescription.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Character;
using tilt_lens::Prescription;
using tilt_lens::Statement;

namespace
{

/// Limit of a file's size; the largest collections of lenses have a tenth of it.
const std::size_t kMostBytes = 4u << 20;

/// `FILE#NAME` chooses a lens of a collection; only JSON files are collections.
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

/// The first item that gives an ideal lens an aberration, or NULL.
const char* CharacterAsked(const Character& c)
{
    return c.edgeLight != 0.0            ? "edge_light"
           : c.opticalVignetting != 0.0  ? "optical_vignetting"
           : c.Distorts()                ? "distortion"
           : c.fieldCurvature != 0.0     ? "field_curvature"
           : c.lateralColour != 0.0      ? "lateral_colour"
           : c.axialColour != 0.0        ? "axial_colour"
                                         : NULL;
}

} // namespace

/// The whole file, searched for like the scene's other files.
std::string TiltLensParser::ReadWhole(const std::string& name)
{
    UCS2String found;
    boost::scoped_ptr<pov_base::IStream> stream(
        Locate_File(&parser, parser.sceneData, ASCIItoUCS2String(name.c_str()), POV_File_Text_User, found, false));
    if (!stream)
        ErrorAt(item, "prescription \"%s\" in tilt_lens: the file cannot be found or opened. It is searched for beside the scene and in "
                      "the folders of +L; mend the name or add its folder.", name.c_str());
    std::string text;
    for (int c = stream->Read_Byte(); !stream->eof() && c != EOF; c = stream->Read_Byte())
    {
        text.push_back(char(c));
        if (text.size() > kMostBytes)
            ErrorAt(item, "prescription \"%s\" in tilt_lens: the file has more than %u bytes. A lens takes a few hundred; is it the "
                          "right file?", name.c_str(), unsigned(kMostBytes));
    }
    return text;
}

void TiltLensParser::ParsePrescription(Statement& statement)
{
    parser.Get_Token();
    const int token = parser.Token.Token_Id;
    const std::string found = parser.Token.Token_String;
    parser.Unget_Token();
    for (const int other : {RIGHT_CURLY_TOKEN, LEFT_CURLY_TOKEN, COMMA_TOKEN, END_OF_FILE_TOKEN, IDENTIFIER_TOKEN, FLOAT_FUNCT_TOKEN,
                            LEFT_ANGLE_TOKEN, SEMI_COLON_TOKEN})
        if (token == other)
            ErrorAt(item, "prescription in tilt_lens has no file: found '%s' in its place. Write it as prescription \"FILE\", or with the "
                          "focal length in mm that the lens is made larger or smaller to, prescription \"FILE\", 50.", found.c_str());
    char* text = parser.Parse_C_String(true);
    const std::string written(text);
    POV_FREE(text);
    const FileChoice choice(written);
    try
    {
        Prescription prescription = tilt_lens::ReadPrescription(ReadWhole(choice.file), choice.name);
        const double focalLength = tilt_lens::GlassLens(prescription).Cardinal().focalLength;
        if (NextIsComma())
            prescription = tilt_lens::Scaled(prescription, PositiveNumber("prescription's focal length") / focalLength);
        statement.prescription = std::make_shared<const Prescription>(prescription);
    }
    catch (const tilt_lens::PrescriptionError& error)
    {
        const std::string line = error.line > 0 ? ", line " + std::to_string(error.line) : "";
        ErrorAt(item, "prescription \"%s\" in tilt_lens%s: found %s", written.c_str(), line.c_str(), error.what());
    }
}

/// Requires Abbe numbers for dispersion.
void TiltLensParser::RequireColours(const Statement& statement, const TiltLensPlace& place)
{
    if (!statement.dispersion)
        return;
    try
    {
        tilt_lens::RequireAbbeNumbers(*statement.prescription);
    }
    catch (const tilt_lens::PrescriptionError& error)
    {
        ErrorAt(place, "dispersion in tilt_lens: the prescription has in line %d %s", error.line, error.what());
    }
}

/// Refuses items that a lens of glass determines itself.
void TiltLensParser::RequireNoOtherLens(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    const TiltLensPlace& place = camera.TiltLens.place;
    if (!s.prescription && s.dispersion)
        ErrorAt(place, "dispersion in tilt_lens without prescription: the ideal lens has no glass. Give it a prescription, or remove "
                       "dispersion; lateral_colour and axial_colour give an ideal lens colour fringes.");
    if (!s.prescription)
        return;
    RequireColours(s, place);
    const double own = tilt_lens::GlassLens(*s.prescription).Cardinal().focalLength;
    if (s.focalLength)
        ErrorAt(place, "focal_length %g and prescription in one camera: the lens of glass has its own, %g mm. Remove focal_length, or give "
                       "it to the prescription, as in prescription \"FILE\", %g.", *s.focalLength, own, *s.focalLength);
    if (camera.TiltLens.items.angle)
        ErrorAt(place, "angle %g and prescription in one camera: the lens of glass has its own focal length, %g mm, which sets the angle "
                       "of view. Remove angle; film_width changes the view, too.", camera.Angle, own);
    if (camera.Bokeh != NULL)
        ErrorAt(place, "bokeh and prescription in one camera: a picture cannot stand for the stop of a lens of glass. Remove one of the two; "
                       "blades and squeeze give a stop its shape.");
    if (const char* const word = CharacterAsked(s.character))
        ErrorAt(place, "%s and prescription in one camera: the lens of glass has aberrations of its own. Remove %s.", word, word);
}

} // namespace pov
