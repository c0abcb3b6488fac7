// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.cpp
/// The words inside `tilt_lens { ... }` are known by their spelling and only there, so that scenes
/// may go on using them as identifiers.

#include "backend/parser/parse_tilt_lens.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_words.h"
#include "tilt_lens/sampling/sampling_limits.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

const int kReservedWords = 0;  // the parser's symbol table that holds them

/// Makes macros look undeclared while it lives, also where an error ends the block.
class HiddenMacros
{
  public:
    explicit HiddenMacros(const std::vector<SYM_ENTRY*>& macros) : macros(macros) { Mark(IDENTIFIER_TOKEN); }
    ~HiddenMacros() { Mark(MACRO_ID_TOKEN); }

  private:
    const std::vector<SYM_ENTRY*> macros;

    void Mark(TOKEN token)
    {
        for (SYM_ENTRY* macro : macros)
            macro->Token_Number = token;
    }
};

} // namespace

TiltLensPlace TiltLensParser::Here() const
{
    TiltLensPlace place;
    place.file = UCS2String(parser.Token.FileHandle->name());
    place.line = parser.Token.Token_File_Pos.lineno;
    place.column = parser.Token.Token_Col_No;
    place.offset = parser.Token.FileHandle->tellg().offset;
    return place;
}

void TiltLensParser::ParseBlock(Camera& camera)
{
    if (parser.sceneData->languageVersion < 350)
        parser.Error("tilt_lens in a camera of language version %g. It needs the camera syntax of version "
                     "3.5 or later; put '#version 3.7;' at the top of the scene.",
                     parser.sceneData->languageVersion / 100.0);
    if (camera.Type != PERSPECTIVE_CAMERA)
        parser.Error("tilt_lens in a camera that is not perspective. Only the perspective camera has a "
                     "lens; remove the word for the camera's type, or the tilt_lens block.");
    if (camera.TiltLens.open)
        parser.Error("A second tilt_lens block in one camera (the first is in line %d). One is allowed; "
                     "merge the two.", int(camera.TiltLens.place.line));

    TiltLensCamera lens;
    lens.given = lens.open = true;
    lens.place = Here();

    const HiddenMacros hidden(MacrosNamedAsItems());
    parser.Parse_Begin();
    std::set<std::string> seen;
    std::string word;
    while (NextItem(word, seen))
        ParseItem(word, lens);
    parser.Parse_End();
    lens.written = camera.TiltLens.written;
    camera.TiltLens = lens;
}

/// A macro runs as soon as its name is read, even where only the next item's word is looked for.
std::vector<SYM_ENTRY*> TiltLensParser::MacrosNamedAsItems()
{
    std::vector<SYM_ENTRY*> macros;
    for (const TiltLensItem& known : kTiltLensItems)
        for (int table = parser.Table_Index; table > 0; table--)
        {
            SYM_ENTRY* entry = parser.Find_Symbol(table, known.word);
            if (entry != NULL && entry->Token_Number == MACRO_ID_TOKEN)
                macros.push_back(entry);
        }
    return macros;
}

bool TiltLensParser::NextItem(std::string& word, std::set<std::string>& seen)
{
    parser.Get_Token();
    if (parser.Token.Token_Id == RIGHT_CURLY_TOKEN || parser.Token.Token_Id == END_OF_FILE_TOKEN)
    {
        parser.Unget_Token();
        return false;
    }
    // the spelling decides, whatever a scene may have declared under that name
    word = parser.Token.Token_String;
    item = Here();
    if (parser.Token.Token_Id == STRING_LITERAL_TOKEN || !FindTiltLensItem(word))
        NotAnItem(word);
    ClaimOnce(word, seen);
    return true;
}

void TiltLensParser::NotAnItem(const std::string& word)
{
    const bool isWord = !word.empty() && (std::isalpha((unsigned char)word[0]) || word[0] == '_') &&
                        parser.Token.Token_Id != STRING_LITERAL_TOKEN;
    if (!isWord)
        ErrorAt(item, "Found '%s' in tilt_lens where an item should begin. Items follow each other without "
                      "commas or other signs; known are %s.", word.c_str(), TiltLensItemNames().c_str());
    if (IsCameraWord(word))
        ErrorAt(item, "'%s' inside tilt_lens. It is an item of the camera itself; write it outside the "
                      "tilt_lens block.", word.c_str());
    if (parser.Find_Symbol(kReservedWords, word.c_str()) != NULL)
        ErrorAt(item, "'%s' inside tilt_lens. It is no item of the block; is the } of tilt_lens missing before "
                      "it? Known are %s.", word.c_str(), TiltLensItemNames().c_str());
    ErrorAt(item, "Unknown word '%s' in tilt_lens; did you mean '%s'? Known are %s.", word.c_str(),
            NearestTiltLensItem(word).word, TiltLensItemNames().c_str());
}

/// Refuses an item that stands twice, and an item of a second family of focus.
void TiltLensParser::ClaimOnce(const std::string& word, std::set<std::string>& seen)
{
    if (!seen.insert(word).second)
        ErrorAt(item, "'%s' stands twice in tilt_lens. Each item is allowed once; remove one.", word.c_str());
    const char* family = FindTiltLensItem(word)->family;
    if (family == NULL)
        return;
    for (const std::string& other : seen)
    {
        const char* otherFamily = FindTiltLensItem(other)->family;
        if (otherFamily != NULL && std::string(otherFamily) != family)
            ErrorAt(item, "'%s' and '%s' in one tilt_lens: both say where the focus lies. One of tilt and "
                          "swing, focus_tilt and focus_swing, focal_plane, focal_points is allowed; remove "
                          "the others.", other.c_str(), word.c_str());
    }
}

void TiltLensParser::ParseItem(const std::string& word, TiltLensCamera& lens)
{
    Statement& s = lens.statement;
    if (ParseFocusAid(word, lens.aids))
        return;
    if (word == "film_width")
        s.filmWidth = PositiveNumber(word);
    else if (word == "focal_length")
        s.focalLength = PositiveNumber(word);
    else if (word == "scene_unit")
        s.sceneUnit = PositiveNumber(word);
    else if (word == "f_stop")
        s.fStop = PositiveNumber(word);
    else if (word == "tilt")
        s.tilt = Number(word);
    else if (word == "swing")
        s.swing = Number(word);
    else if (word == "focus_tilt")
        s.family = FocusFamily::FocusTurn, s.focusTilt = Number(word);
    else if (word == "focus_swing")
        s.family = FocusFamily::FocusTurn, s.focusSwing = Number(word);
    else if (word == "shift")
        ParseShift(s);
    else if (word == "blades")
        ParseBlades(s);
    else if (word == "denoise")
        s.denoise = Number(word) != 0.0;  // `on` and `off` are numbers
    else if (word == "focal_plane")
        ParseFocalPlane(s);
    else
        ParseFocalPoints(s);
}

double TiltLensParser::Number(const std::string& word)
{
    const double value = parser.Parse_Float();
    if (!std::isfinite(value))
        ErrorAt(item, "%s %g in tilt_lens. It must be a finite number; check the expression.", word.c_str(),
                     value);
    return value;
}

double TiltLensParser::PositiveNumber(const std::string& word)
{
    const double value = Number(word);
    if (!(value > 0.0))
        ErrorAt(item, "%s %g in tilt_lens. It must be larger than 0; give a positive number.", word.c_str(),
                     value);
    return value;
}

Vec3 TiltLensParser::Vector(const std::string& word)
{
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    if (terms != 3)
        ErrorAt(item, "%s in tilt_lens: found a value of %d numbers. A point or normal has three; write it as "
                     "<x, y, z>.", word.c_str(), terms);
    const Vec3 value{v[X], v[Y], v[Z]};
    if (!IsFinite(value))
        ErrorAt(item, "%s in tilt_lens: found <%g, %g, %g>. All three numbers must be finite; check the "
                     "expression.", word.c_str(), v[X], v[Y], v[Z]);
    return value;
}

void TiltLensParser::ParseShift(Statement& s)
{
    EXPRESS v;
    const int terms = parser.Parse_Unknown_Vector(v);
    // a plain number would be promoted to both directions: surely not what was meant
    if (!(terms == 2 || (terms == 3 && v[Z] == 0.0)))
        ErrorAt(item, "shift in tilt_lens: found a value of %d numbers. It takes two, in millimetres; write it "
                     "as <right, up>.", terms);
    if (!std::isfinite(v[X]) || !std::isfinite(v[Y]))
        ErrorAt(item, "shift <%g, %g> in tilt_lens. Both numbers must be finite; check the expression.", v[X],
                     v[Y]);
    s.shiftRight = v[X];
    s.shiftUp = v[Y];
}

void TiltLensParser::ParseBlades(Statement& s)
{
    const int kMost = 1000;  // edges far below any pixel
    const double count = Number("blades");
    if (!(count >= 3.0 && count <= kMost && count == std::floor(count)))
        ErrorAt(item, "blades %g in tilt_lens. A diaphragm has a whole number of blades from 3 to %d; leave "
                     "blades out for a round one.", count, kMost);
    s.blades = int(count);
    parser.Get_Token();
    if (parser.Token.Token_Id == COMMA_TOKEN)
        s.bladesAngle = Number("blades' angle");
    else
        parser.Unget_Token();
}

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

void TiltLensParser::TakeCameraItems(Camera& camera)
{
    // once asked for, they are forgotten: a default camera's items are not those of the cameras after it
    const WrittenItems written = std::exchange(camera.TiltLens.written, WrittenItems());
    if (!camera.TiltLens.given)
        return;
    if (camera.Type != PERSPECTIVE_CAMERA)
        ErrorAt(camera.TiltLens.place, "The default camera's tilt_lens meets a camera that is not perspective. "
                                       "Only the perspective camera has a lens; remove the block from the "
                                       "default camera.");
    camera.TiltLens.statement.aperture = camera.Aperture;
    RequireConsistent(camera, written);
    RequireQuality(camera, written);
    RequireAperture(camera);
    TakeFocalPoint(camera);
    TakeBlurSamples(camera);
}

void TiltLensParser::RequireConsistent(const Camera& camera, const WrittenItems& written)
{
    const Statement& s = camera.TiltLens.statement;
    const TiltLensPlace& place = camera.TiltLens.place;
    if (s.focalLength && camera.Angle != HUGE_VAL)
        ErrorAt(place, "angle %g and focal_length %g in one camera: both set the angle of view. One is allowed; "
                       "remove angle or focal_length.", camera.Angle, *s.focalLength);
    if (s.fStop && (camera.Aperture != 0.0 || written.aperture))
        ErrorAt(place, "aperture %g and f_stop %g in one camera: both set the lens diameter. One is allowed; "
                       "remove aperture or f_stop.", camera.Aperture, *s.fStop);
    if (!(camera.Aperture >= 0.0) || !std::isfinite(camera.Aperture))
        ErrorAt(place, "aperture %g in a camera with tilt_lens. It is twice the lens diameter and must be "
                       "finite and not negative; give another value.", camera.Aperture);
    if (s.blades > 0 && camera.Bokeh != NULL)
        ErrorAt(place, "blades %d and bokeh in one camera: both shape the aperture. One is allowed; remove "
                       "blades or bokeh.", s.blades);
}

/// Where the unpatched program warns and takes the default.
void TiltLensParser::RequireQuality(const Camera& camera, const WrittenItems& written)
{
    if (!(written.variance >= 0.0 && written.variance <= 1.0))
        ErrorAt(camera.TiltLens.place, "variance %g in a camera with tilt_lens. 0 to 1 is allowed, 1/10000 is the "
                                       "default; give another value or remove variance.", written.variance);
    if (!(written.confidence > 0.0 && written.confidence < 1.0))
        ErrorAt(camera.TiltLens.place, "confidence %g in a camera with tilt_lens. More than 0 and less than 1 is allowed, "
                                       "0.9 is the default; give another value or remove confidence.", written.confidence);
}

/// `focal_point`, else `look_at`: both are marked as infinite while they are not written.
void TiltLensParser::TakeFocalPoint(Camera& camera)
{
    Statement& s = camera.TiltLens.statement;
    if (camera.Focal_Point[X] != HUGE_VAL)
        s.focalPoint = FromPov(camera.Focal_Point);
    else if (camera.Look_At[X] != HUGE_VAL)
        s.focalPoint = FromPov(camera.Look_At);
    else if (camera.TiltLens.open)
    {
        const bool needsPoint = s.family == FocusFamily::LensTurn || s.family == FocusFamily::FocusTurn;
        if (needsPoint && (s.aperture > 0.0 || s.fStop))
            ErrorAt(camera.TiltLens.place, "Nothing says where the focus lies: the camera has neither "
                                           "focal_point nor look_at. Give focal_point, or focal_plane or "
                                           "focal_points in tilt_lens.");
        // everything is sharp: any point in front will do
        s.focalPoint = FromPov(camera.Location) + FromPov(camera.Direction);
    }
}

/// Stock shows no blur where blur_samples is missing; tilt_lens has a default. One number is the most.
void TiltLensParser::TakeBlurSamples(Camera& camera)
{
    const tilt_lens::SamplingLimits usual;
    if (camera.Blur_Samples == 0)
        camera.Blur_Samples = usual.max;
    if (camera.Blur_Samples_Min == 0)
        camera.Blur_Samples_Min = std::min(int(usual.min), camera.Blur_Samples);
}

void TiltLensParser::Check(Camera& camera)
{
    TiltLensCamera& lens = camera.TiltLens;
    if (!lens.given)
        return;
    const bool fresh = lens.open;
    lens.open = false;
    try
    {
        TiltLensCamera::Solve(camera);
        if (fresh)
            for (const std::string& doubt : Doubts(*lens.lens, lens.statement))
                parser.messageFactory.WarningAt(0, lens.place.file.c_str(), lens.place.line,
                                                lens.place.column, lens.place.offset, "%s", doubt.c_str());
    }
    catch (const tilt_lens::OpticsError& error)
    {
        ErrorAt(lens.place, "%s", error.what());
    }
}

void TiltLensParser::ErrorAt(const TiltLensPlace& place, const char* format, ...)
{
    char text[1024];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    parser.messageFactory.ErrorAt(POV_EXCEPTION(kParseErr, text), place.file.c_str(), place.line, place.column,
                                  place.offset, "%s", text);
}

} // namespace pov
