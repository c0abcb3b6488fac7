// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_view.h"

#include <algorithm>
#include <cstdio>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/control/messagefactory.h"
#include "backend/scene/camera_record.h"
#include "backend/scene/focus_target.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/scene/threaddata.h"
#include "backend/scene/tilt_lens_emitters.h"
#include "backend/scene/tilt_lens_report.h"
#include "backend/scene/unlisted_lamps.h"
#include "backend/scene/view.h"
#include "backend/texture/pigment.h"
#include "tilt_lens/budget/budget.h"
#include "tilt_lens/samples/lamp_search.h"

#include "base/povdebug.h"

namespace pov
{

namespace
{

/// Aperture before edge light and squeeze.
tilt_lens::Aperture DiaphragmOf(const Camera& camera, shared_ptr<SceneData> scene)
{
    const tilt_lens::Statement& s = camera.TiltLens.statement;
    if (camera.Bokeh != NULL)
    {
        SceneThreadData thread(scene);
        Post_Pigment(camera.Bokeh);  // omitted by stock, which crashes if a pattern needs it
        return tilt_lens::Aperture::Picture([&](double u, double v)
        {
            Colour colour;
            VECTOR point = {u, v, 0.0};
            Compute_Pigment(colour, camera.Bokeh, point, NULL, NULL, &thread);
            return std::min(1.0, double(colour.greyscale()));  // as stock, which draws lens points by rejection
        });
    }
    if (s.blades > 0)
        return tilt_lens::Aperture::Polygon(s.blades, s.bladesAngle * M_PI_180, s.bladeCurvature);
    return tilt_lens::Aperture::Disc();
}

tilt_lens::Aperture ApertureOf(const Camera& camera, shared_ptr<SceneData> scene)
{
    const tilt_lens::Statement& s = camera.TiltLens.statement;
    tilt_lens::Aperture aperture = DiaphragmOf(camera, scene);
    if (s.character.edgeLight != 0.0)
        aperture = tilt_lens::Aperture::Graded(aperture, s.character.edgeLight);
    return s.squeeze == 1.0 ? aperture : tilt_lens::Aperture::Squeezed(aperture, s.squeeze);
}

shared_ptr<const tilt_lens::LensCamera> LensCameraOf(const Camera& camera, shared_ptr<SceneData> scene)
{
    return std::make_shared<const tilt_lens::LensCamera>(camera.TiltLens.lens, ApertureOf(camera, scene),
                                                         camera.TiltLens.statement.character, camera.Tnormal != NULL);
}

tilt_lens::SamplingLimits LimitsOf(const Camera& camera)
{
    tilt_lens::SamplingLimits limits;
    limits.min = camera.Blur_Samples_Min;
    limits.max = camera.Blur_Samples;
    limits.variance = camera.TiltLens.statement.budget > 0.0 ? tilt_lens::UsualVariance(camera.TiltLens.statement.budget) : camera.Variance;
    limits.confidence = camera.Confidence;
    limits.denoise = camera.TiltLens.statement.denoise;
    return limits;
}

std::size_t ObjectsWithInterior(const SceneData& scene)
{
    return std::count_if(scene.objects.begin(), scene.objects.end(), [](ObjectPtr object) { return object->interior != NULL; });
}

} // namespace

TiltLensView::TiltLensView(const Camera& given, ViewData& view, const std::vector<tilt_lens::Emitter>& emitters) :
    camera(LensCameraOf(given, view.GetSceneData()), LimitsOf(given), {view.GetWidth(), view.GetHeight(), emitters},
           given.TiltLens.statement.sampleSeed),
    aroundLens(ObjectsAroundLens(given, *given.TiltLens.lens, *view.GetSceneData())),
    objectsWithInterior(ObjectsWithInterior(*view.GetSceneData())),
    width(view.GetWidth()),
    height(view.GetHeight()),
    rendered(AreaOf(view.GetRenderArea())),
    budget(given.TiltLens.aids.Any() ? 0.0 : given.TiltLens.statement.budget)
{
    const double left = budget > 0.0 ? budget - camera.limits.FirstRound() : camera.limits.max;
    const double searchRays = tilt_lens::Settings::searchPart * left;
    if (!given.TiltLens.aids.Any() && camera.aims && searchRays >= 1.0 && MayShowUnlistedLamps(*view.GetSceneData(), emitters))
        search.reset(new tilt_lens::LampSearch(camera, width, height, searchRays));
}

tilt_lens::BudgetPilot* TiltLensView::Pilot()
{
    boost::mutex::scoped_lock lock(pilotMutex);
    if (!pilot && budget > 0.0)
        pilot.reset(new tilt_lens::BudgetPilot(camera.limits, width, height, budget - (search ? search->RaysOfPixel() : 0.0)));
    return pilot.get();
}

const tilt_lens::SamplingLimits& TiltLensView::Limits() const
{
    return pilot ? pilot->Limits() : camera.limits;
}

tilt_lens::BlockCache& TiltLensView::Blocks()
{
    boost::mutex::scoped_lock lock(blocksMutex);
    if (!blocks)
        blocks.reset(new tilt_lens::BlockCache(Limits(), width, height, rendered));
    return *blocks;
}

void TiltLensView::RequireBudget(const Camera& camera, shared_ptr<SceneData> scene)
{
    const double budget = camera.TiltLens.statement.budget;
    if (budget == 0.0)
        return;
    tilt_lens::SamplingLimits limits = LimitsOf(camera);
    if (limits.min == 0)
        limits.SetUsualMinimum(LensCameraOf(camera, scene)->NeedsFewFirstSamples());
    const unsigned int least = limits.FirstRound();
    char text[240];
    std::snprintf(text, sizeof text,
                  "budget %g in a camera whose pixels take at least %u rays each, their first round. At least %u is allowed; "
                  "give a larger budget, or a lower minimum to blur_samples.",
                  budget, least, least);
    if (budget < least)
        throw tilt_lens::OpticsError(text);
}

void TiltLensView::RequireLight(const Camera& camera, shared_ptr<SceneData> scene)
{
    const tilt_lens::Character& character = camera.TiltLens.statement.character;
    if (character.opticalVignetting != 0.0)
        tilt_lens::Vignetting(camera.TiltLens.lens, ApertureOf(camera, scene), character);
}

shared_ptr<TiltLensView> TiltLensView::Create(Camera& camera, ViewData& view)
{
    const tilt_lens::SolvedLens& lens = *camera.TiltLens.lens;
    camera.Direction[X] = lens.direction.x;
    camera.Direction[Y] = lens.direction.y;
    camera.Direction[Z] = lens.direction.z;
    camera.Aperture = 0.0;
    if (IsPlainPinhole(lens, camera.TiltLens.statement.character))
        return shared_ptr<TiltLensView>();
    shared_ptr<TiltLensView> prepared(new TiltLensView(camera, view, EmittersOf(*view.GetSceneData(), camera)));
    if (camera.TiltLens.aids.Any())
        prepared->aids.reset(new TiltLensAids(camera.TiltLens.aids, prepared->camera.lens, view.GetWidth(), view.GetHeight(),
                                              view.GetSceneData()->workingGammaToSRGB));
    return prepared;
}

void TiltLensView::Add(const tilt_lens::SamplingStatistics& tile)
{
    boost::mutex::scoped_lock lock(statisticsMutex);
    statistics.Add(tile);
}

tilt_lens::SamplingStatistics TiltLensView::Statistics() const
{
    boost::mutex::scoped_lock lock(statisticsMutex);
    return statistics;
}

void TiltLensView::AddProgress(POVMS_Object& message) const
{
    // the addition makes a rounded sum of 1 read 100
    const std::optional<double> share = progress.Share();
    if (share && *share > 0.0)
    {
        message.SetInt(kPOVAttrib_TiltLensWork, int(100.0 * *share + 1e-6));
        message.SetInt(kPOVAttrib_PixelsCompleted, message.GetInt(kPOVAttrib_PixelsCompleted) + POVMSInt(pixelsBefore));
    }
}

void TiltLensView::ShowProgress(ViewData& view, const std::function<std::string()>& text)
{
    boost::mutex::scoped_lock lock(shownMutex);
    const std::string now = text();
    if (now == shown)
        return;
    shown = now;
    POVMS_Object message(kPOVObjectClass_RenderProgress);
    message.SetString(kPOVAttrib_TiltLensProgress, now.c_str());
    RenderBackend::SendViewOutput(view.GetViewId(), view.GetSceneData()->frontendAddress, kPOVMsgIdent_Progress, message);
}

void View::StartTiltLens(unsigned int& tracingmethod)
{
    Camera& camera = viewData.camera;
    const TiltLensPlace place = camera.TiltLens.place;
    MessageFactory messages(10, 370, "Render", viewData.sceneData->backendAddress, viewData.sceneData->frontendAddress,
                            viewData.sceneData->sceneId, viewData.viewId);
    const auto warn = [&](const std::string& text)
    { messages.WarningAt(0, place.file.c_str(), place.line, place.column, place.offset, "%s", text.c_str()); };
    try
    {
        for (const std::string& warning : FindFocus(camera, viewData.sceneData, viewData.width))
            warn(warning);
        FinishCameraRecord(camera, viewData.sceneData, viewData.width);
        if (!camera.TiltLens.given)
            return;
        TiltLensView::RequireBudget(camera, viewData.sceneData);
        viewData.tiltLens = TiltLensView::Create(camera, viewData);

        const TiltLensAids* aids = viewData.tiltLens ? viewData.tiltLens->aids.get() : NULL;
        POVMS_Object report(kPOVObjectClass_RenderOptions);
        report.SetString(kPOVAttrib_TiltLensReport, DescribeTiltLens(camera, viewData.width, aids).c_str());
        RenderBackend::SendViewOutput(viewData.viewId, viewData.sceneData->frontendAddress, kPOVMsgIdent_RenderOptions, report);
    }
    catch (const tilt_lens::OpticsError& error)
    {
        messages.ErrorAt(POV_EXCEPTION(kParamErr, error.what()), place.file.c_str(), place.line, place.column, place.offset, "%s",
                         error.what());
    }
    catch (const std::invalid_argument& error)  // bokeh without light
    {
        messages.ErrorAt(POV_EXCEPTION(kParamErr, error.what()), place.file.c_str(), place.line, place.column, place.offset, "%s",
                         error.what());
    }
    if (!viewData.tiltLens && camera.TiltLens.statement.budget > 0.0)
        warn("budget has no effect in a camera without an aperture: POV-Ray's own camera renders it, with the rays of anti-aliasing (+A).");
    if (!viewData.tiltLens)
        return;
    if (tracingmethod != 0)
        warn(viewData.tiltLens->aids ? "Anti-aliasing (+A) is not used with focus_peaking, focus_map or show_planes: they "
                                       "take one ray a pixel."
                                     : "Anti-aliasing (+A) adds nothing to a picture with tilt_lens and an aperture: its "
                                       "samples cover the pixel already. blur_samples and variance or budget set the quality.");
    tracingmethod = TiltLensView::kTracingMethod;
    PlanTiltLensWork();
}

void View::PlanTiltLensWork()
{
    const POVRect& area = viewData.renderArea;
    tilt_lens::ProgressEstimator& progress = viewData.tiltLens->progress;
    // test pixels would change a radiosity cache
    const bool probing = !viewData.tiltLens->aids && !viewData.sceneData->radiositySettings.radiosityEnabled;
    progress.Plan({area.left, area.top, area.GetWidth(), area.GetHeight()}, probing);

    const std::set<unsigned int>& skipped = viewData.blockSkipList;
    for (unsigned int block = 0; block < viewData.blockWidth * viewData.blockHeight; block++)
        if (block < viewData.nextBlock || skipped.count(block) > 0)
        {
            unsigned int x, y;
            viewData.getBlockXY(block, x, y);
            const unsigned int size = viewData.blockSize, left = area.left + x * size, top = area.top + y * size;
            progress.Finish({left, top, size, size});
            viewData.tiltLens->pixelsBefore += std::min<std::uint64_t>(size, area.right + 1 - left) *
                                               std::min<std::uint64_t>(size, area.bottom + 1 - top);
        }
}

} // namespace pov
