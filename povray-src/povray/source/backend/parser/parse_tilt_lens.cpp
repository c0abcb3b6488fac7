// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.cpp
/// The words inside `tilt_lens { ... }` are known by their spelling and only there, so that scenes
/// may go on using them as identifiers.

#include "backend/parser/parse_tilt_lens.h"

#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstring>

#include "backend/frame.h"
#include "backend/math/matrices.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_words.h"

#include "base/povdebug.h"

namespace pov
{

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
        FindTiltLensItem(word)->parse(*this, word, lens);
    parser.Parse_End();
    lens.words = seen;
    lens.facade = DeclaredVector("Tilt_Lens_Facade_Across").value_or(tilt_lens::Vec3());
    lens.written = camera.TiltLens.written;
    lens.items = camera.TiltLens.items;
    lens.statement.focalPoint = camera.TiltLens.statement.focalPoint;
    lens.statement.scale = camera.TiltLens.statement.scale;
    camera.TiltLens = lens;
}

void TiltLensParser::ParseBlockBehindIdentifier(Camera& camera)
{
    ParseBlock(camera);
    CheckBlock(camera);
}

void TiltLensParser::DeclareFeature()
{
    const int kGlobal = 1;  // the table of #declare
    SYM_ENTRY* entry = parser.Add_Symbol(kGlobal, "Tilt_Lens_Available", FLOAT_ID_TOKEN);
    entry->Data = Create_Float();
    *static_cast<DBL*>(entry->Data) = 1.0;
}

/// A macro runs as soon as its name is read, even where only the next item's word is looked for.
std::vector<SYM_ENTRY*> TiltLensParser::MacrosNamedAsItems()
{
    std::vector<SYM_ENTRY*> macros;
    for (const TiltLensItem& known : TiltLensItems::kAll)
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

/// Refuses an item that stands twice, an item of a second family of focus, and a second one that says how far away it lies.
void TiltLensParser::ClaimOnce(const std::string& word, std::set<std::string>& seen)
{
    if (!seen.insert(word).second)
        ErrorAt(item, "'%s' stands twice in tilt_lens. Each item is allowed once; remove one.", word.c_str());
    const auto differ = [](const char* a, const char* b) { return a != NULL && b != NULL && std::strcmp(a, b) != 0; };
    const TiltLensItem& now = *FindTiltLensItem(word);
    for (const std::string& other : seen)
    {
        const TiltLensItem& before = *FindTiltLensItem(other);
        if (differ(before.family, now.family))
            ErrorAt(item, "'%s' and '%s' in one tilt_lens: both say where the focus lies. One of tilt and "
                          "swing, focus_tilt and focus_swing, focal_plane, focal_points, sharp_points "
                          "is allowed; remove the others.", other.c_str(), word.c_str());
        if (differ(before.distance, now.distance))
            ErrorAt(item, "'%s' and '%s' in one tilt_lens: both say how far away the focus lies. One of focus_on, focus_at, "
                          "film_distance, focus_scale, focal_plane, focal_points, sharp_points is allowed; remove the others.",
                    other.c_str(), word.c_str());
    }
}

void TiltLensParser::ErrorAt(const TiltLensPlace& place, const char* format, ...)
{
    char text[16384]; // two names of 4095 bytes, and what is said of them
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    parser.messageFactory.ErrorAt(POV_EXCEPTION(kParseErr, text), place.file.c_str(), place.line, place.column,
                                  place.offset, "%s", text);
}

void TiltLensParser::WarningAt(const TiltLensPlace& place, const std::string& text)
{
    parser.messageFactory.WarningAt(0, place.file.c_str(), place.line, place.column, place.offset, "%s", text.c_str());
}

} // namespace pov
