// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_view.h"

#include <algorithm>
#include <cstdio>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/control/messagefactory.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/scene/threaddata.h"
#include "backend/scene/view.h"
#include "backend/texture/pigment.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

tilt_lens::Aperture ApertureOf(const Camera& camera, shared_ptr<SceneData> scene)
{
    const tilt_lens::Statement& s = camera.TiltLens.statement;
    if (camera.Bokeh != NULL)
    {
        SceneThreadData thread(scene);
        Post_Pigment(camera.Bokeh);  // stock leaves that out, and crashes where a pattern needs it
        return tilt_lens::Aperture::Picture(
            [&](double u, double v)
            {
                Colour colour;
                VECTOR point = {u, v, 0.0};
                Compute_Pigment(colour, camera.Bokeh, point, NULL, NULL, &thread);
                return std::min(1.0, double(colour.greyscale()));  // as stock, which draws lens points by chance
            });
    }
    if (s.blades > 0)
        return tilt_lens::Aperture::Polygon(s.blades, s.bladesAngle * M_PI_180);
    return tilt_lens::Aperture::Disc();
}

tilt_lens::Area AreaOf(const POVRect& rect)
{
    return {(unsigned int)rect.left, (unsigned int)rect.top, (unsigned int)rect.GetWidth(),
            (unsigned int)rect.GetHeight()};
}

tilt_lens::SamplingLimits LimitsOf(const Camera& camera)
{
    tilt_lens::SamplingLimits limits;
    limits.max = camera.Blur_Samples;
    limits.min = camera.Blur_Samples_Min;
    limits.variance = camera.Variance;
    limits.confidence = camera.Confidence;
    limits.denoise = camera.TiltLens.statement.denoise;
    return limits;
}

/// Half the extent of the lens along one world axis; a picture in the lens fills the square around the disc.
double HalfExtent(double x, double y, bool square)
{
    return square ? std::fabs(x) + std::fabs(y) : std::hypot(x, y);
}

/// Every object with an interior whose bounding box meets the box around the lens.
std::vector<ObjectPtr> ObjectsAroundLens(const Camera& camera, const tilt_lens::Lens& lens, const SceneData& scene)
{
    const bool square = camera.Bokeh != NULL;
    const double half[3] = {HalfExtent(lens.lensX.x, lens.lensY.x, square),
                            HalfExtent(lens.lensX.y, lens.lensY.y, square),
                            HalfExtent(lens.lensX.z, lens.lensY.z, square)};
    std::vector<ObjectPtr> objects;
    for (ObjectPtr object : scene.objects)
    {
        bool apart = object->interior == NULL;
        for (int i = X; i <= Z; i++)
        {
            const double low = object->BBox.Lower_Left[i], high = low + object->BBox.Lengths[i];
            // boxes are single precision; leave them that much room
            const double room = half[i] + 1e-6 * (std::fabs(low) + std::fabs(high));
            apart = apart || camera.Location[i] + room < low || camera.Location[i] - room > high;
        }
        if (!apart)
            objects.push_back(object);
    }
    return objects;
}

std::string Line(const char* format, double a, double b = 0.0, double c = 0.0)
{
    char text[160];
    std::snprintf(text, sizeof text, format, a, b, c);
    return text;
}

/// A vector for reading: what is only rounding error beside numbers of size `scale` is a zero.
std::string Text(const Vec3& v, double scale)
{
    const double least = 1e-12 * scale;
    const auto number = [=](double x) { return Line("%.6g", std::fabs(x) <= least ? 0.0 : x); };
    return "<" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ">";
}

/// A distance in scene units, `scale` being a usual one; what is infinite but for rounding, in words.
std::string Distance(double units, double scale)
{
    return units < 1e12 * scale ? Line("%.6g units", units) : "infinity";
}

/// An angle in degrees, without the rounding error of a lens that is not turned.
double Tidy(double degrees)
{
    return std::fabs(degrees) < 1e-9 ? 0.0 : degrees;
}

} // namespace

TiltLensView::TiltLensView(const Camera& camera, const tilt_lens::Lens& solved, ViewData& view) :
    lens(solved),
    aperture(ApertureOf(camera, view.GetSceneData())),
    limits(LimitsOf(camera)),
    cells(new tilt_lens::CellStore(limits, view.GetWidth(), view.GetHeight(), AreaOf(view.GetRenderArea()))),
    aroundLens(ObjectsAroundLens(camera, solved, *view.GetSceneData())),
    blurPerVergence(0.5 * solved.diameter / Length(solved.right))
{
}

shared_ptr<TiltLensView> TiltLensView::Create(Camera& camera, const tilt_lens::Lens& lens,
                                              ViewData& view)
{
    camera.Direction[X] = lens.direction.x;
    camera.Direction[Y] = lens.direction.y;
    camera.Direction[Z] = lens.direction.z;
    camera.Aperture = 0.0;  // POV-Ray's own focal blur keeps out
    if (lens.diameter == 0.0)
        return shared_ptr<TiltLensView>();
    return shared_ptr<TiltLensView>(new TiltLensView(camera, lens, view));
}

void TiltLensView::Add(const tilt_lens::SamplingAccount& tile)
{
    boost::mutex::scoped_lock lock(accountMutex);
    account.Add(tile);
}

std::string TiltLensView::Summary() const
{
    boost::mutex::scoped_lock lock(accountMutex);
    const double pixels = std::max<double>(1.0, account.Pixels());
    return "Tilt Lens Sampling\n" +
           Line("  Samples per pixel....mean %.1f, 99%% %.0f, most %.0f\n", account.Samples() / pixels,
                account.Quantile(0.99), account.Most()) +
           Line("  Standard error.......%.2g of white (estimated)\n", account.StandardError()) +
           (account.notFinite == 0 ? std::string()
                                   : Line("  Not finite...........%.0f samples, counted as black\n",
                                          account.notFinite));
}

std::string DescribeTiltLens(const Camera& camera, const tilt_lens::Lens& lens, double width)
{
    const double mm = 1.0 / lens.millimetre;
    const Vec3 location{camera.Location[X], camera.Location[Y], camera.Location[Z]};
    const double distance = Length(lens.focus), axisFocus = AxisFocusOf(lens);
    // a point to check the plane by: on the axis where it crosses in front, else the nearest one
    const bool crosses = axisFocus > 0.0 && std::isfinite(axisFocus);
    const Vec3 point = crosses ? axisFocus * lens.axis : lens.focus / (distance * distance);

    std::string text = "Tilt Lens\n";
    text += Line("  Lens.................tilt %.4g, swing %.4g degrees\n", Tidy(TiltOf(lens)),
                 Tidy(SwingOf(lens)));
    text += Line("  Focal length.........%.5g mm, film at %.5g mm\n", lens.focalLength * mm,
                 lens.filmDistance * mm);
    if (lens.diameter > 0.0)
        text += Line("  Aperture.............f/%.4g, diameter %.5g mm", lens.focalLength / lens.diameter,
                     lens.diameter * mm) + Line(" (%.5g units)\n", lens.diameter);
    else
        text += "  Aperture.............none (pinhole): everything is sharp\n";
    text += "  Sharp plane through.." + Text(location + point, Length(location) + Length(point)) + "\n";
    text += "    normal............." + Text(lens.focus / distance, 1.0) + "\n";
    text += Line("    turned by..........%.4g degrees against the film\n", Tidy(FocusAngleOf(lens)));
    text += "  Hinge line...........at " + Distance(HingeDistanceOf(lens), 1.0 / distance) + " from the lens\n";
    if (lens.diameter > 0.0)
    {
        const tilt_lens::SharpRange sharp = SharpRangeOf(lens, width, 1.0);
        text += "  Sharp on the axis....from " + Distance(sharp.near, 1.0 / distance) +
                " to " + Distance(sharp.far, 1.0 / distance) +
                " (blur of 1 pixel)\n";
    }
    return text;
}

/// A camera with `tilt_lens` gets its threads' common data, tells its numbers and takes over from all
/// anti-aliasing; any other camera is left alone.
void View::StartTiltLens(unsigned int& tracingmethod)
{
    Camera& camera = viewData.camera;
    if (!camera.TiltLens.given)
        return;
    const TiltLensPlace place = camera.TiltLens.place;
    MessageFactory messages(10, 370, "Render", viewData.sceneData->backendAddress,
                            viewData.sceneData->frontendAddress, viewData.sceneData->sceneId, viewData.viewId);
    try
    {
        const tilt_lens::Lens lens = TiltLensCamera::Solve(camera);
        viewData.tiltLens = TiltLensView::Create(camera, lens, viewData);

        POVMS_Object report(kPOVObjectClass_RenderOptions);
        report.SetString(kPOVAttrib_TiltLensReport, DescribeTiltLens(camera, lens, viewData.width).c_str());
        RenderBackend::SendViewOutput(viewData.viewId, viewData.sceneData->frontendAddress,
                                      kPOVMsgIdent_RenderOptions, report);
    }
    catch (const std::invalid_argument& error)  // a bokeh picture without light
    {
        messages.ErrorAt(POV_EXCEPTION(kParamErr, error.what()), place.file.c_str(), place.line, place.column,
                         place.offset, "%s", error.what());
    }
    catch (const tilt_lens::OpticsError& error)  // a camera that changed since it was parsed
    {
        messages.ErrorAt(POV_EXCEPTION(kParamErr, error.what()), place.file.c_str(), place.line, place.column,
                         place.offset, "%s", error.what());
    }
    if (!viewData.tiltLens)
        return;
    if (tracingmethod != 0)
        messages.WarningAt(0, place.file.c_str(), place.line, place.column, place.offset,
                           "Anti-aliasing (+A) adds nothing to a picture with tilt_lens and an aperture: its "
                           "samples cover the pixel already. blur_samples and variance set the quality.");
    tracingmethod = TiltLensView::kTracingMethod;
}

} // namespace pov
