// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file parse_tilt_lens_camera.cpp
/// What `tilt_lens` takes from the camera around it, and whether the two agree.

#include "backend/parser/parse_tilt_lens.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

#include "backend/frame.h"
#include "backend/parser/parse.h"
#include "backend/parser/tilt_lens_words.h"
#include "backend/scene/camera_record.h"
#include "backend/scene/tilt_lens_view.h"
#include "tilt_lens/sampling/sampling_limits.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

/// Cosine of the angle up to which a camera's sky counts as what is up in the scene, leaned a little.
const double kSameSky = 0.7;

} // namespace

void TiltLensParser::WarnLater(Camera& camera, const char* text)
{
    camera.TiltLens.written.warnings.push_back({Here(), text});
}

void TiltLensParser::TakeCameraItems(Camera& camera)
{
    // once asked for, they are forgotten: a default camera's items are not those of the cameras after it
    const WrittenItems written = std::exchange(camera.TiltLens.written, WrittenItems());
    CameraItems& items = camera.TiltLens.items;
    items.angle = camera.Angle != HUGE_VAL;
    items.aperture = written.aperture || camera.Aperture != 0.0;
    TakeFocalPoint(camera);
    if (!camera.TiltLens.given)
    {
        for (const WrittenItems::Warning& warning : written.warnings)
            WarningAt(warning.place, warning.text);
        return;
    }
    if (camera.Type != PERSPECTIVE_CAMERA)
        ErrorAt(camera.TiltLens.place, "The default camera's tilt_lens meets a camera that is not perspective. "
                                       "Only the perspective camera has a lens; remove the block from the "
                                       "default camera.");
    WarnOfFocalPoint(camera);
    TakeQuality(camera, written);
    CheckBlock(camera);
}

/// Checks the block together with the camera around it, once both are known.
void TiltLensParser::CheckBlock(Camera& camera)
{
    camera.TiltLens.statement.aperture = camera.Aperture;
    RequireConsistent(camera);
    RequireNoOtherLens(camera);
    RequireFilm(camera);
    RequireSharpPoints(camera);
    RequireAperture(camera);
    RequireFocus(camera);
    TakeBlurSamples(camera);
}

/// A point that is written in the camera and has no say.
void TiltLensParser::WarnOfFocalPoint(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    const FocusTarget::Kind target = camera.TiltLens.focusTarget.kind;
    const char* word = s.family == FocusFamily::FocalPlane    ? "focal_plane"
                       : s.family == FocusFamily::FocalPoints ? "focal_points"
                       : s.family == FocusFamily::SharpPoints ? "sharp_points"
                       : s.filmDistance                       ? "film_distance"
                       : s.focusScale                         ? "focus_scale"
                       : target == FocusTarget::Object        ? "focus_on"
                       : target == FocusTarget::Picture       ? "focus_at"
                                                              : NULL;
    if (word == NULL || camera.Focal_Point[X] == HUGE_VAL)
        return;
    const Vec3 p = FromPov(camera.Focal_Point);
    char text[256];
    std::snprintf(text, sizeof text, "focal_point <%g, %g, %g> has no effect beside %s, which says where the focus lies. "
                                     "Remove one of the two.", p.x, p.y, p.z, word);
    WarningAt(camera.TiltLens.place, text);
}

/// A vector that the scene has declared, or nothing.
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

/// Tilt_Lens_Facade cannot see whether the camera is left-handed or right-handed.
void TiltLensParser::RequireFacade(const Camera& camera)
{
    if (Dot(camera.TiltLens.facade, FromPov(camera.Right)) < 0.0)
        ErrorAt(camera.TiltLens.place, "Tilt_Lens_Facade: Lower_Left is to the right of Lower_Right, as this camera sees them. It must be "
                                       "at the left; exchange the two, and give the corner above the new Lower_Left as Upper_Left.");
}

/// The set-ups of the include file cannot see the camera's sky.
void TiltLensParser::WarnOfSky(const Camera& camera)
{
    const std::optional<Vec3> declared = DeclaredVector("Tilt_Lens_Sky");
    if (!declared)
        return;
    const Vec3 sky = Normalized(FromPov(camera.Sky)), up = Normalized(*declared);
    if (!(Dot(sky, up) < kSameSky))
        return;
    char text[320];
    std::snprintf(text, sizeof text, "The camera's sky is <%g, %g, %g>, but Tilt_Lens_Sky, which tells the macros of tilt_lens.inc "
                                     "what is up, is <%g, %g, %g>. If you use them, #declare Tilt_Lens_Sky = <%g, %g, %g> "
                                     "before the camera.", sky.x, sky.y, sky.z, up.x, up.y, up.z, sky.x, sky.y, sky.z);
    WarningAt(camera.TiltLens.place, text);
}

void TiltLensParser::RequireConsistent(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    const TiltLensPlace& place = camera.TiltLens.place;
    if (s.focalLength && camera.TiltLens.items.angle)
        ErrorAt(place, "angle %g and focal_length %g in one camera: both set the angle of view. One is allowed; "
                       "remove angle or focal_length.", camera.Angle, *s.focalLength);
    if (s.fStop && camera.TiltLens.items.aperture)
        ErrorAt(place, "aperture %g and f_stop %g in one camera: both set the lens diameter. One is allowed; "
                       "remove aperture or f_stop.", camera.Aperture, *s.fStop);
    if (!(camera.Aperture >= 0.0) || !std::isfinite(camera.Aperture))
        ErrorAt(place, "aperture %g in a camera with tilt_lens. It is twice the lens diameter and must be "
                       "finite and not negative; give another value.", camera.Aperture);
    if (s.blades > 0 && camera.Bokeh != NULL)
        ErrorAt(place, "blades %d and bokeh in one camera: both shape the aperture. One is allowed; remove "
                       "blades or bokeh.", s.blades);
    if (s.character.edgeLight != 0.0 && camera.Bokeh != NULL)
        ErrorAt(place, "edge_light %g and bokeh in one camera: both say where the aperture is bright. One is allowed; remove "
                       "edge_light or bokeh.", s.character.edgeLight);
    if (s.bladeCurvature > 0.0 && s.blades == 0)
        ErrorAt(place, "blade_curvature %g without blades: nothing says how many edges are curved. Give blades too, or "
                       "remove blade_curvature.", s.bladeCurvature);
}

/// Where the film stands, the lens is focused before it is turned.
void TiltLensParser::RequireFilm(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    if (!s.filmDistance && !s.focusScale)
        return;
    const char* word = s.filmDistance ? "film_distance" : "focus_scale";
    if (s.family == FocusFamily::FocusTurn)
        ErrorAt(camera.TiltLens.place, "%s beside focus_tilt or focus_swing in tilt_lens. It is for a lens that is turned by tilt "
                                       "and swing after it was focused; use these, or focal_point in its place.", word);
    if (s.filmDistance && !s.focalLength && !s.prescription)
        ErrorAt(camera.TiltLens.place, "film_distance %g without focal_length in tilt_lens: without it the angle of view says where "
                                       "the film is. Give focal_length, or focus_scale in place of film_distance.", *s.filmDistance);
}

/// A blur limit needs sharp points, and nothing else may set the aperture.
void TiltLensParser::RequireSharpPoints(const Camera& camera)
{
    const TiltLensCamera& lens = camera.TiltLens;
    const Statement& s = lens.statement;
    const char* const word = lens.BlurLimitWord();
    if (word == NULL)
        return;
    const double limit = lens.sharpWithinPixels ? *lens.sharpWithinPixels : *s.sharpWithin;
    if (lens.sharpWithinPixels && s.sharpWithin)
        ErrorAt(lens.place, "sharp_within %g and circle_of_confusion %g in one tilt_lens: both say how much blur is allowed, in pixels and "
                            "in millimetres of film. One is allowed; remove the other.", limit, *s.sharpWithin);
    if (s.family != FocusFamily::SharpPoints)
        ErrorAt(lens.place, "%s %g without sharp_points in tilt_lens: nothing says what must be within it. Give sharp_points, or f_stop "
                            "in place of %s.", word, limit, word);
    if (s.fStop || lens.items.aperture)
        ErrorAt(lens.place, "%s %g and %s %g in one camera: both set the lens diameter. One is allowed; remove %s or %s. At an aperture of "
                            "your own, the program's report has the blur of each point.", word, limit, s.fStop ? "f_stop" : "aperture",
                s.fStop ? *s.fStop : camera.Aperture, word, s.fStop ? "f_stop" : "aperture");
}

/// Where other cameras get a warning and the default. Many scenes have a confidence of 1.
void TiltLensParser::TakeQuality(Camera& camera, const WrittenItems& written)
{
    if (!(written.variance >= 0.0 && written.variance <= 1.0))
        ErrorAt(camera.TiltLens.place, "variance %g in a camera with tilt_lens. 0 to 1 is allowed, 1/10000 is the "
                                       "default; give another value or remove variance.", written.variance);
    if (written.confidence == 1.0)
    {
        camera.Confidence = std::nextafter(1.0, 0.0);
        WarningAt(camera.TiltLens.place, "confidence 1 in a camera with tilt_lens: no number of samples makes it certain that the variance is "
                                         "reached. The greatest number below 1 is taken, with which each pixel takes all of blur_samples. "
                                         "0.9 is the default; a value less than 1 takes less time.");
    }
    else if (!(written.confidence > 0.0 && written.confidence < 1.0))
        ErrorAt(camera.TiltLens.place, "confidence %g in a camera with tilt_lens. More than 0 and less than 1 is allowed, "
                                       "0.9 is the default; give another value or remove confidence.", written.confidence);
}

/// `focal_point`, else `look_at`: both are marked as infinite while they are not written.
void TiltLensParser::TakeFocalPoint(Camera& camera)
{
    const VECTOR& point = camera.Focal_Point[X] != HUGE_VAL ? camera.Focal_Point : camera.Look_At;
    if (point[X] == HUGE_VAL)
        return;
    camera.TiltLens.statement.focalPoint = FromPov(point);
    camera.TiltLens.items.focalPoint = true;
}

void TiltLensParser::RequireFocus(Camera& camera)
{
    TiltLensCamera& lens = camera.TiltLens;
    Statement& s = lens.statement;
    if (!lens.open || lens.items.focalPoint)
        return;
    const bool turned = s.family == FocusFamily::LensTurn || s.family == FocusFamily::FocusTurn;
    const bool needsPoint = turned && !s.filmDistance && !s.focusScale && lens.IsComplete();
    if (needsPoint && (s.aperture > 0.0 || s.fStop || s.prescription))
        ErrorAt(lens.place, "Nothing says where the focus lies: the camera has neither focal_point nor look_at. Give focal_point, "
                            "or focal_plane or focal_points in tilt_lens.");
    // everything is sharp: any point in front will do
    s.focalPoint = FromPov(camera.Location) + FromPov(camera.Direction);
}

/// Stock shows no blur where blur_samples is missing; tilt_lens has a default. One number is the most.
void TiltLensParser::TakeBlurSamples(Camera& camera)
{
    if (camera.Blur_Samples == 0)
        camera.Blur_Samples = tilt_lens::SamplingLimits().max;
}

/// Behind the block, where a word for another type of camera is met.
void TiltLensParser::RefuseOtherType(const Camera& camera)
{
    if (camera.TiltLens.given)
        parser.Error("%s in a camera with tilt_lens. Only the perspective camera has a lens; remove the word for the camera's type, or the "
                     "tilt_lens block.", parser.Token.Token_String);
}

/// Where a camera should end.
void TiltLensParser::RefuseStrangeItem()
{
    parser.Get_Token();
    const bool unknown = parser.Token.Token_Id == IDENTIFIER_TOKEN;
    const std::string word = unknown ? parser.Token.Token_String : "";
    if (const TiltLensItem* const item = FindTiltLensItem(word))
        parser.Error("%s in a camera: it belongs into a block, as in tilt_lens { %s }.", word.c_str(), item->example);
    if (unknown && LooksLikeTiltLens(word))
        parser.Error("%s in a camera: there is no such item. Is tilt_lens { ... } meant?", word.c_str());
    parser.Unget_Token();
}

void TiltLensParser::Check(Camera& camera)
{
    if (camera.TiltLens.given)
        SolveLens(camera);
    RecordCamera(camera, Here());
}

void TiltLensParser::SolveLens(Camera& camera)
{
    TiltLensCamera& lens = camera.TiltLens;
    const bool fresh = lens.open;
    lens.open = false;
    if (fresh)
    {
        WarnOfSky(camera);
        RequireFacade(camera);
    }
    if (!lens.IsComplete())
        return;  // FindFocus() will do it
    try
    {
        TiltLensCamera::Solve(camera);
        if (fresh)
        {
            TiltLensView::RequireLight(camera, parser.sceneData);
            for (const std::string& warning : Warnings(*lens.lens, lens.statement))
                WarningAt(lens.place, warning);
        }
    }
    catch (const tilt_lens::OpticsError& error)
    {
        ErrorAt(lens.place, "%s", error.what());
    }
}

} // namespace pov
