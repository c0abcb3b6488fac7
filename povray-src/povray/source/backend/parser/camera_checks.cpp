// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/parser/camera_checks.h"

#include <cmath>

#include "backend/parser/item_reader.h"
#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/prescription.h"
#include "tilt_lens/samples/sampling_limits.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Character;
using tilt_lens::FocusFamily;
using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

/// Cosine of the largest angle between skies that count as one.
const double kSameSky = 0.7;

void RequireOneMeaning(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    if (s.focalLength && camera.TiltLens.items.angle)
        Refuse("angle %g and focal_length %g in one camera: both set the angle of view. One is allowed; remove angle or focal_length.",
               camera.Angle, *s.focalLength);
    if (s.fStop && camera.TiltLens.items.aperture)
        Refuse("aperture %g and f_stop %g in one camera: both set the lens diameter. One is allowed; remove aperture or f_stop.",
               camera.Aperture, *s.fStop);
    if (!(camera.Aperture >= 0.0) || !std::isfinite(camera.Aperture))
        Refuse("aperture %g in a camera with tilt_lens. It is twice the lens diameter and must be finite and not negative; give another "
               "value.",
               camera.Aperture);
    if (s.blades > 0 && camera.Bokeh != NULL)
        Refuse("blades %d and bokeh in one camera: both shape the aperture. One is allowed; remove blades or bokeh.", s.blades);
    if (s.character.edgeLight != 0.0 && camera.Bokeh != NULL)
        Refuse("edge_light %g and bokeh in one camera: both say where the aperture is bright. One is allowed; remove edge_light or bokeh.",
               s.character.edgeLight);
    if (s.bladeCurvature > 0.0 && s.blades == 0)
        Refuse("blade_curvature %g without blades: nothing says how many edges are curved. Give blades too, or remove blade_curvature.",
               s.bladeCurvature);
}

const char* CharacterAsked(const Character& c)
{
    return c.edgeLight != 0.0           ? "edge_light"
           : c.opticalVignetting != 0.0 ? "optical_vignetting"
           : c.Distorts()               ? "distortion"
           : c.fieldCurvature != 0.0    ? "field_curvature"
           : c.lateralColour != 0.0     ? "lateral_colour"
           : c.axialColour != 0.0       ? "axial_colour"
                                        : NULL;
}

void RequireOneLens(const Camera& camera)
{
    const Statement& s = camera.TiltLens.statement;
    if (!s.prescription && s.dispersion)
        Refuse("dispersion in tilt_lens without prescription: the ideal lens has no glass. Give it a prescription, or remove dispersion; "
               "lateral_colour and axial_colour give an ideal lens colour fringes.");
    if (!s.prescription)
        return;
    try
    {
        if (s.dispersion)
            tilt_lens::RequireAbbeNumbers(*s.prescription);
    }
    catch (const tilt_lens::PrescriptionError& error)
    {
        Refuse("dispersion in tilt_lens: the prescription has in line %d %s", error.line, error.what());
    }
    const double own = tilt_lens::GlassLens(*s.prescription).Cardinal().focalLength;
    if (s.focalLength)
        Refuse("focal_length %g and prescription in one camera: the lens of glass has its own, %g mm. Remove focal_length, or give it to "
               "the prescription, as in prescription \"FILE\", %g.",
               *s.focalLength, own, *s.focalLength);
    if (camera.TiltLens.items.angle)
        Refuse("angle %g and prescription in one camera: the lens of glass has its own focal length, %g mm, which sets the angle of view. "
               "Remove angle; film_width changes the view, too.",
               camera.Angle, own);
    if (camera.Bokeh != NULL)
        Refuse("bokeh and prescription in one camera: a picture cannot stand for the stop of a lens of glass. Remove one of the two; "
               "blades and squeeze give a stop its shape.");
    if (const char* const word = CharacterAsked(s.character))
        Refuse("%s and prescription in one camera: the lens of glass has aberrations of its own. Remove %s.", word, word);
}

void RequireFilm(const Statement& s)
{
    if (!s.filmDistance && !s.focusScale)
        return;
    if (s.family == FocusFamily::FocusTurn)
        Refuse("%s beside focus_tilt or focus_swing in tilt_lens. It is for a lens that is turned by tilt and swing after it was focused; "
               "use these, or focal_point in its place.",
               s.filmDistance ? "film_distance" : "focus_scale");
    if (s.filmDistance && !s.focalLength && !s.prescription)
        Refuse("film_distance %g without focal_length in tilt_lens: without it the angle of view says where the film is. Give "
               "focal_length, or focus_scale in place of film_distance.",
               *s.filmDistance);
}

void RequireSharpPoints(const Camera& camera)
{
    const TiltLensCamera& lens = camera.TiltLens;
    const Statement& s = lens.statement;
    const char* const word = lens.BlurLimitWord();
    if (word == NULL)
        return;
    const double limit = lens.sharpWithinPixels ? *lens.sharpWithinPixels : *s.sharpWithin;
    if (lens.sharpWithinPixels && s.sharpWithin)
        Refuse("sharp_within %g and circle_of_confusion %g in one tilt_lens: both say how much blur is allowed, in pixels and in "
               "millimetres of film. One is allowed; remove the other.",
               limit, *s.sharpWithin);
    if (s.family != FocusFamily::SharpPoints)
        Refuse("%s %g without sharp_points in tilt_lens: nothing says what must be within it. Give sharp_points, or f_stop in place of %s.",
               word, limit, word);
    if (s.fStop || lens.items.aperture)
        Refuse("%s %g and %s %g in one camera: both set the lens diameter. One is allowed; remove %s or %s. At an aperture of your own, "
               "the program's report has the blur of each point.",
               word, limit, s.fStop ? "f_stop" : "aperture", s.fStop ? *s.fStop : camera.Aperture, word, s.fStop ? "f_stop" : "aperture");
}

void RequireFreeSamples(const Camera& camera)
{
    const double budget = camera.TiltLens.statement.budget;
    if (budget == 0.0)
        return;
    if (camera.TiltLens.items.variance)
        Refuse("budget %g and variance %g in one camera: both say how many rays are taken. One is allowed; remove budget or variance.",
               budget, camera.Variance);
    const unsigned int least = camera.Blur_Samples_Min;
    const unsigned int most = camera.Blur_Samples > 0 ? camera.Blur_Samples : tilt_lens::SamplingLimits().max;
    if (least >= most)
        Refuse("budget %g and blur_samples %u, %u in one camera: each pixel takes %u rays, so that none can be spent elsewhere. Remove "
               "blur_samples or its first number, or budget.",
               budget, least, most, most);
    if (budget >= most)
        Refuse("budget %g and blur_samples with the maximum %u in one camera: no pixel may take more than %u rays, so the mean must be "
               "less. Give blur_samples a larger maximum, or a smaller budget.",
               budget, most, most);
}

void RequireAperture(const Camera& camera)
{
    const TiltLensCamera& lens = camera.TiltLens;
    if (lens.aids.Any() && camera.Aperture == 0.0 && !lens.statement.fStop && !lens.statement.prescription && lens.BlurLimitWord() == NULL)
        Refuse("%s in a camera without an aperture: everything is sharp, so there is nothing to show. Give aperture or f_stop, or remove "
               "it.",
               lens.aids.peaking ? "focus_peaking"
               : lens.aids.map   ? "focus_map"
                                 : "show_planes");
}

} // namespace

void RequireConsistent(const Camera& camera)
{
    RequireOneMeaning(camera);
    RequireOneLens(camera);
    RequireFilm(camera.TiltLens.statement);
    RequireSharpPoints(camera);
    RequireFreeSamples(camera);
    RequireAperture(camera);
}

void RequireQuality(const CameraDraft& draft, double budget)
{
    if (draft.variance && !(*draft.variance >= 0.0 && *draft.variance <= 1.0))
        Refuse("variance %g in a camera with tilt_lens. 0 to 1 is allowed, 1/10000 is the default; give another value or remove variance.",
               *draft.variance);
    if (!(draft.confidence > 0.0 && draft.confidence <= 1.0))
        Refuse("confidence %g in a camera with tilt_lens. More than 0 and less than 1 is allowed, 0.9 is the default; give another value "
               "or remove confidence.",
               draft.confidence);
    if (budget > 0.0 && draft.confidence == 1.0)
        Refuse("budget %g and confidence 1 in one camera: with this confidence each pixel takes all of blur_samples. Remove confidence; "
               "0.9 is the default.",
               budget);
}

void RequireFocalPoint(const TiltLensCamera& lens)
{
    const Statement& s = lens.statement;
    const bool turned = s.family == FocusFamily::LensTurn || s.family == FocusFamily::FocusTurn;
    if (turned && !s.filmDistance && !s.focusScale && lens.IsComplete() && (s.aperture > 0.0 || s.fStop || s.prescription))
        Refuse("Nothing says where the focus lies: the camera has neither focal_point nor look_at. Give focal_point, or focal_plane or "
               "focal_points in tilt_lens.");
}

void RequireFacade(const Vec3& across, const Vec3& right)
{
    if (Dot(across, right) < 0.0)
        Refuse("Tilt_Lens_Facade: Lower_Left is to the right of Lower_Right, as this camera sees them. It must be at the left; exchange "
               "the two, and give the corner above the new Lower_Left as Upper_Left.");
}

std::string FocalPointWarning(const Camera& camera)
{
    if (camera.Focal_Point[X] == HUGE_VAL)
        return "";
    const Vec3 p = FromPov(camera.Focal_Point);
    for (const TiltLensItem& item : kTiltLensItems)
        if (item.statesDistance && camera.TiltLens.words.count(item.word) > 0)
            return Printed("focal_point <%g, %g, %g> has no effect beside %s, which says where the focus lies. Remove one of the two.", p.x,
                           p.y, p.z, item.word);
    return "";
}

std::string SkyWarning(const Vec3& itsSky, const Vec3& assumed)
{
    const Vec3 sky = Normalized(itsSky), up = Normalized(assumed);
    if (!(Dot(sky, up) < kSameSky))
        return "";
    return Printed("The camera's sky is <%g, %g, %g>, but Tilt_Lens_Sky, which tells the macros of tilt_lens.inc "
                   "what is up, is <%g, %g, %g>. If you use them, #declare Tilt_Lens_Sky = <%g, %g, %g> "
                   "before the camera.",
                   sky.x, sky.y, sky.z, up.x, up.y, up.z, sky.x, sky.y, sky.z);
}

} // namespace pov
