// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens.cpp
/// Words of `tilt_lens { ... }` are known by their spelling and only there, so scenes may use them as identifiers.

#include "backend/parser/parse_tilt_lens.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <set>

#include <boost/scope_exit.hpp>

#include "backend/math/matrices.h"
#include "backend/parser/camera_checks.h"
#include "backend/parser/item_reader.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_items.h"
#include "backend/scene/camera_record.h"
#include "backend/scene/tilt_lens_view.h"
#include "tilt_lens/samples/sampling_limits.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::OpticsError;
using tilt_lens::Vec3;

namespace
{

const int kReservedWords = 0;

bool IsMacroOfInclude(const char* name)
{
    return std::strncmp(name, "Tilt_Lens_", 10) == 0;
}

void RequireNew(const TiltLensItem& item, const std::set<std::string>& words)
{
    if (words.count(item.word) > 0)
        Refuse("'%s' stands twice in tilt_lens. Each item is allowed once; remove one.", item.word);
    for (const std::string& word : words)
    {
        const TiltLensItem& other = *FindTiltLensItem(word);
        if (item.family && other.family && *item.family != *other.family)
            Refuse("'%s' and '%s' in one tilt_lens: both say where the focus lies. One of tilt and swing, focus_tilt and focus_swing, "
                   "focal_plane, focal_points, sharp_points is allowed; remove the others.",
                   other.word, item.word);
        if (item.statesDistance && other.statesDistance)
            Refuse("'%s' and '%s' in one tilt_lens: both say how far away the focus lies. One of focus_on, focus_at, film_distance, "
                   "focus_scale, focal_plane, focal_points, sharp_points is allowed; remove the others.",
                   other.word, item.word);
    }
}

void RequireAidsTogether(const tilt_lens::FocusAids& aids)
{
    if (aids.map && (aids.peaking || aids.planes))
        Refuse("focus_map and %s in one tilt_lens: a tint would falsify the map's colours. focus_peaking and show_planes may go together, "
               "focus_map stands alone; remove one.",
               aids.peaking ? "focus_peaking" : "show_planes");
}

} // namespace

void TiltLensParser::DeclareFeature()
{
    const int kGlobal = 1;
    SYM_ENTRY* entry = parser.Add_Symbol(kGlobal, "Tilt_Lens_Available", FLOAT_ID_TOKEN);
    entry->Data = Create_Float();
    *static_cast<DBL*>(entry->Data) = 1.0;
}

CameraDraft& TiltLensParser::Draft(const Camera& camera)
{
    return parser.Camera_Drafts[&camera];
}

std::optional<TiltLensPlace> TiltLensParser::Call() const
{
    std::optional<TiltLensPlace> place;
    // CS_Index is one too large in the error about too many entries
    for (int i = std::min(parser.CS_Index, COND_STACK_SIZE - 1); i > 0; i--)
    {
        const Parser::CS_ENTRY& entry = parser.Cond_Stack[i];
        if (entry.Macro_Return_Name == NULL)
            continue; // no macro, or not known yet
        if (!IsMacroOfInclude(entry.PMac->Macro_Name))
            break;
        place = TiltLensPlace{UCS2String(entry.Macro_Return_Name), entry.File_Pos.lineno, 0, entry.File_Pos.offset};
    }
    return place;
}

TiltLensPlace TiltLensParser::Here() const
{
    if (const std::optional<TiltLensPlace> call = Call())
        return *call;
    TiltLensPlace place;
    place.file = UCS2String(parser.Token.FileHandle->name());
    place.line = parser.Token.Token_File_Pos.lineno;
    place.column = parser.Token.Token_Col_No;
    place.offset = parser.Token.FileHandle->tellg().offset;
    return place;
}

void TiltLensParser::ErrorAt(const TiltLensPlace& place, const std::string& text)
{
    parser.messageFactory.ErrorAt(POV_EXCEPTION(kParseErr, text), place.file.c_str(), place.line, place.column, place.offset, "%s",
                                  text.c_str());
}

void TiltLensParser::WarningAt(const TiltLensPlace& place, const std::string& text, unsigned int level)
{
    if (!text.empty())
        parser.messageFactory.WarningAt(level, place.file.c_str(), place.line, place.column, place.offset, "%s", text.c_str());
}

void TiltLensParser::ErrorAtCall(const char* text)
{
    if (const std::optional<TiltLensPlace> call = Call())
        ErrorAt(*call, text);
}

bool TiltLensParser::WarningAtCall(unsigned int level, const char* text)
{
    const std::optional<TiltLensPlace> call = Call();
    if (call)
        WarningAt(*call, text, level);
    return call.has_value();
}

template<class Task>
void TiltLensParser::At(const TiltLensPlace& place, const Task& task)
{
    try
    {
        task();
    }
    catch (const OpticsError& error)
    {
        ErrorAt(place, error.what());
    }
}

void TiltLensParser::ParseBlock(Camera& camera)
{
    if (parser.sceneData->languageVersion < 350)
        parser.Error(
            "tilt_lens in a camera of language version %g. It needs the camera syntax of version 3.5 or later; put '#version 3.7;' "
            "at the top of the scene.",
            parser.sceneData->languageVersion / 100.0);
    if (camera.Type != PERSPECTIVE_CAMERA)
        parser.Error("tilt_lens in a camera that is not perspective. Only the perspective camera has a lens; remove the word for the "
                     "camera's type, or the tilt_lens block.");
    CameraDraft& draft = Draft(camera);
    if (draft.hasBlock)
        parser.Error("A second tilt_lens block in one camera (the first is in line %d). One is allowed; merge the two.",
                     int(camera.TiltLens.place.line));

    TiltLensCamera lens;
    lens.given = true;
    lens.place = Here();
    const auto mark = [macros = MacrosNamedAsItems()](TOKEN token)
    {
        for (SYM_ENTRY* macro : macros)
            macro->Token_Number = token;
    };
    mark(IDENTIFIER_TOKEN); // so that they look undeclared
    BOOST_SCOPE_EXIT_ALL(&)
    {
        mark(MACRO_ID_TOKEN);
    };
    parser.Parse_Begin();
    while (ParseItem(lens))
    {
    }
    parser.Parse_End();
    lens.items = camera.TiltLens.items;
    lens.statement.focalPoint = camera.TiltLens.statement.focalPoint;
    lens.statement.scale = camera.TiltLens.statement.scale;
    camera.TiltLens = lens;
    draft.hasBlock = true;
    draft.facade = DeclaredVector("Tilt_Lens_Facade_Across").value_or(Vec3());
}

void TiltLensParser::ParseBlockBehindIdentifier(Camera& camera)
{
    ParseBlock(camera);
    CheckBlock(camera);
}

bool TiltLensParser::ParseItem(TiltLensCamera& lens)
{
    parser.Get_Token();
    if (parser.Token.Token_Id == RIGHT_CURLY_TOKEN || parser.Token.Token_Id == END_OF_FILE_TOKEN)
    {
        parser.Unget_Token();
        return false;
    }
    const std::string word = parser.Token.Token_String;
    const TiltLensItem* const item = parser.Token.Token_Id == STRING_LITERAL_TOKEN ? NULL : FindTiltLensItem(word);
    At(Here(), [&] // a value may end lines later
    {
        if (item == NULL)
            RefuseWord(word);
        RequireNew(*item, lens.words);
        lens.words.insert(word);
        ItemReader(parser, *item).Read(lens);
        RequireAidsTogether(lens.aids);
    });
    return true;
}

void TiltLensParser::RefuseWord(const std::string& word)
{
    const bool isWord = !word.empty() && (std::isalpha((unsigned char)word[0]) || word[0] == '_') &&
                        parser.Token.Token_Id != STRING_LITERAL_TOKEN;
    const std::string names = TiltLensItemNames();
    if (!isWord)
        Refuse("Found '%s' in tilt_lens where an item should begin. Items follow each other without commas or other signs; known are %s.",
               word.c_str(), names.c_str());
    if (IsCameraWord(word))
        Refuse("'%s' inside tilt_lens. It is an item of the camera itself; write it outside the tilt_lens block.", word.c_str());
    if (parser.Find_Symbol(kReservedWords, word.c_str()) != NULL)
        Refuse("'%s' inside tilt_lens. It is no item of the block; is the } of tilt_lens missing before it? Known are %s.", word.c_str(),
               names.c_str());
    Refuse("Unknown word '%s' in tilt_lens; did you mean '%s'? Known are %s.", word.c_str(), NearestTiltLensItem(word).word, names.c_str());
}

/// A macro runs as soon as its name is read.
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

std::optional<Vec3> TiltLensParser::DeclaredVector(const char* name)
{
    for (int table = parser.Table_Index; table > 0; table--)
        if (const SYM_ENTRY* entry = parser.Find_Symbol(table, name))
        {
            if (entry->Token_Number != VECTOR_ID_TOKEN || entry->Data == NULL)
                break;
            return FromPov(reinterpret_cast<const DBL*>(entry->Data));
        }
    return std::nullopt;
}

void TiltLensParser::WarnLater(Camera& camera, const char* text)
{
    Draft(camera).warnings.push_back({Here(), text});
}

void TiltLensParser::RefuseOtherType(const Camera& camera)
{
    if (camera.TiltLens.given)
        parser.Error("%s in a camera with tilt_lens. Only the perspective camera has a lens; remove the word for the camera's type, or the "
                     "tilt_lens block.",
                     parser.Token.Token_String);
}

void TiltLensParser::RefuseStrangeItem(const Camera& camera)
{
    parser.Get_Token();
    for (const int type : {ORTHOGRAPHIC_TOKEN, FISHEYE_TOKEN, ULTRA_WIDE_ANGLE_TOKEN, OMNIMAX_TOKEN, PANORAMIC_TOKEN, SPHERICAL_TOKEN,
                           CYLINDER_TOKEN, MESH_CAMERA_TOKEN})
        if (parser.Token.Token_Id == type)
            RefuseOtherType(camera);
    const bool unknown = parser.Token.Token_Id == IDENTIFIER_TOKEN;
    const std::string word = unknown ? parser.Token.Token_String : "";
    if (const TiltLensItem* const item = FindTiltLensItem(word))
        parser.Error("%s in a camera: it belongs into a block, as in tilt_lens { %s }.", word.c_str(), item->Example().c_str());
    if (unknown && LooksLikeTiltLens(word))
        parser.Error("%s in a camera: there is no such item. Is tilt_lens { ... } meant?", word.c_str());
    parser.Unget_Token();
}

void TiltLensParser::TakeCameraItems(Camera& camera)
{
    const CameraDraft& draft = Draft(camera);
    TiltLensCamera& lens = camera.TiltLens;
    lens.items.angle = camera.Angle != HUGE_VAL;
    lens.items.aperture = draft.aperture || camera.Aperture != 0.0;
    lens.items.variance = lens.items.variance || draft.variance;
    // unwritten ones are infinite
    const VECTOR& point = camera.Focal_Point[X] != HUGE_VAL ? camera.Focal_Point : camera.Look_At;
    if (point[X] != HUGE_VAL)
    {
        lens.statement.focalPoint = FromPov(point);
        lens.items.focalPoint = true;
    }
    if (!lens.given)
    {
        for (const CameraDraft::Warning& warning : draft.warnings)
            WarningAt(warning.place, warning.text);
        return;
    }
    if (camera.Type != PERSPECTIVE_CAMERA)
        ErrorAt(lens.place, "The default camera's tilt_lens meets a camera that is not perspective. Only the perspective camera has a "
                            "lens; remove the block from the default camera.");
    WarningAt(lens.place, FocalPointWarning(camera));
    At(lens.place, [&] { RequireQuality(draft, lens.statement.budget); });
    if (draft.confidence == 1.0)
    {
        camera.Confidence = std::nextafter(1.0, 0.0);
        WarningAt(lens.place, "confidence 1 in a camera with tilt_lens: no number of samples makes it certain that the variance is "
                              "reached. The greatest number below 1 is taken, with which each pixel takes all of blur_samples. "
                              "0.9 is the default; a value less than 1 takes less time.");
    }
    CheckBlock(camera);
}

void TiltLensParser::CheckBlock(Camera& camera)
{
    TiltLensCamera& lens = camera.TiltLens;
    lens.statement.aperture = camera.Aperture;
    const bool hasFocus = lens.items.focalPoint || !Draft(camera).hasBlock;
    At(lens.place, [&]
    {
        RequireConsistent(camera);
        if (!hasFocus)
            RequireFocalPoint(lens);
    });
    if (!hasFocus) // any point in front will do
        lens.statement.focalPoint = FromPov(camera.Location) + FromPov(camera.Direction);
    // stock shows no blur without blur_samples
    if (camera.Blur_Samples == 0)
        camera.Blur_Samples = tilt_lens::SamplingLimits().max;
}

void TiltLensParser::Check(Camera& camera)
{
    if (camera.TiltLens.given)
        SolveLens(camera);
    RecordCamera(camera, Here());
    parser.Camera_Drafts.erase(&camera);
}

void TiltLensParser::SolveLens(Camera& camera)
{
    TiltLensCamera& lens = camera.TiltLens;
    const CameraDraft& draft = Draft(camera);
    if (draft.hasBlock)
    {
        if (const std::optional<Vec3> sky = DeclaredVector("Tilt_Lens_Sky"))
            WarningAt(lens.place, SkyWarning(FromPov(camera.Sky), *sky));
        VECTOR across = {draft.facade.x, draft.facade.y, draft.facade.z};
        MTransDirection(across, across, camera.Trans);
        At(lens.place, [&] { RequireFacade(FromPov(across), FromPov(camera.Right)); });
    }
    if (!lens.IsComplete())
        return;  // FindFocus() solves it
    At(lens.place, [&]
    {
        TiltLensCamera::Solve(camera);
        TiltLensView::RequireBudget(camera, parser.sceneData);
        if (!draft.hasBlock)
            return;
        TiltLensView::RequireLight(camera, parser.sceneData);
        for (const std::string& warning : Warnings(*lens.lens, lens.statement))
            WarningAt(lens.place, warning);
    });
}

} // namespace pov
