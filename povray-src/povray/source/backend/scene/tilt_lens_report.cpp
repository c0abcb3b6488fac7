// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "backend/frame.h"
#include "backend/scene/tilt_lens_view.h"
#include "tilt_lens/budget/budget.h"
#include "tilt_lens/glass/dispersion.h"
#include "tilt_lens/glass/field_aberrations.h"
#include "tilt_lens/glass/inner_focus.h"
#include "tilt_lens/lens_camera/sharp_points.h"
#include "tilt_lens/samples/lamp_search.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

std::string Line(const char* format, double a, double b = 0.0, double c = 0.0)
{
    char text[160];
    std::snprintf(text, sizeof text, format, a, b, c);
    return text;
}

/// Rounding errors, relative to `scale`, become 0.
std::string Text(const Vec3& v, double scale)
{
    const double least = 1e-12 * scale;
    const auto number = [=](double x) { return Line("%.6g", std::fabs(x) <= least ? 0.0 : x); };
    return "<" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + ">";
}

/// Scene units; "infinity" up to rounding relative to `scale`.
std::string Distance(double units, double scale)
{
    return std::isfinite(units) && units < 1e12 * scale ? Line("%.6g units", units) : "infinity";
}

double Degrees(double radians)
{
    return radians * (180.0 / M_PI);
}

double Tidy(double degrees)
{
    return std::fabs(degrees) < 1e-9 ? 0.0 : degrees;
}

std::string Count(double number, const char* what)
{
    return Line("%.0f ", number) + what + (number == 1.0 ? "" : "s");
}

std::string FilmOf(const Camera& camera, const tilt_lens::Lens& lens)
{
    const tilt_lens::Statement& given = camera.TiltLens.statement;
    const double height = given.filmWidth * Length(lens.up) / Length(lens.right);
    // includes the shift of the camera's own `direction`
    const double perUnit = given.filmWidth / Length(lens.right), scale = 1e-9 * given.filmWidth;
    const double right = Dot(lens.direction, lens.axisRight) * perUnit, up = Dot(lens.direction, lens.axisUp) * perUnit;
    const auto number = [=](double mm) { return std::fabs(mm) < scale ? 0.0 : mm; };
    const double across = 2.0 * Degrees(std::atan(0.5 * Length(lens.right) / Dot(lens.direction, lens.axis)));
    const double upright = 2.0 * Degrees(std::atan(0.5 * Length(lens.up) / Dot(lens.direction, lens.axis)));
    return Line("  Film.................%.5g by %.5g mm", given.filmWidth, height) +
           Line(", shift <%.5g, %.5g> mm\n", number(right), number(up)) +
           Line("    angle of view......%.4g by %.4g degrees", across, upright) + "\n";
}

/// By natural vignetting alone, relative to the centre.
double DarkestCorner(const TiltLensCamera& block)
{
    tilt_lens::Character natural;
    natural.naturalVignetting = block.statement.character.naturalVignetting;
    const tilt_lens::Vignetting vignetting(block.lens, tilt_lens::Aperture::Disc(), natural);
    double darkest = HUGE_VAL;
    tilt_lens::ForCorners([&](const tilt_lens::FilmPoint& corner) { darkest = std::min(darkest, vignetting.Brightness(corner)); });
    return darkest;
}

std::string CharacterOf(const TiltLensCamera& block)
{
    const tilt_lens::SolvedLens& lens = *block.lens;
    const tilt_lens::Character& character = block.statement.character;
    std::string text;
    if (character.edgeLight != 0.0)
        text += Line("  Edge light...........%.4g: aperture brighter ", character.edgeLight) +
                (character.edgeLight > 0.0 ? "at the rim\n" : "in the middle\n");
    if (character.naturalVignetting > 0.0 && lens.glass)
        text += Line("  Natural vignetting...%.4g\n", character.naturalVignetting);
    else if (character.naturalVignetting > 0.0)
        text += Line("  Natural vignetting...%.4g: the darkest corner has %.3g of the middle's light\n", character.naturalVignetting,
                     DarkestCorner(block));
    if (character.opticalVignetting > 0.0 && lens.diameter > 0.0)
        text += Line("  Optical vignetting...%.4g, rim of f/%.4g\n", character.opticalVignetting,
                     character.rimStop.value_or(lens.focalLength / lens.diameter));
    if (lens.distorts)
        text += Line("  Distortion...........%.4g, %.4g of the distance from the lens's axis in half widths of film\n",
                     character.distortion1, character.distortion2) +
                (character.distortionNear == 0.0
                     ? ""
                     : Line("    near...............%.4g more times focal length over distance\n", character.distortionNear));
    if (lens.fieldCurvature != 0.0)
        text += Line("  Field curvature......image %.4g mm before the film at half a film's width, radius %.5g mm\n",
                     character.fieldCurvature, 0.5 / (lens.fieldCurvature * lens.millimetre));
    if (lens.lateralColour != 0.0 || lens.axialColour != 0.0)
        text += Line("  Colour fringes.......red %.4g mm farther out than blue, focused %.4g mm farther back\n", character.lateralColour,
                     character.axialColour);
    return text;
}

/// Positions along the axis, from the front principal point.
std::string GlassOf(const tilt_lens::SolvedLens& lens, double filmWidth)
{
    const tilt_lens::CardinalPoints& points = lens.glass->Cardinal();
    std::string text = Line("  Glass................open to f/%.4g, rear principal point at %.5g mm\n", points.fNumber, -points.separation);
    text += Line("    surfaces...........first at %.5g, last at %.5g mm\n", points.frontVertex, points.rearVertex);
    // along the axis, from H' to the tilted film's centre
    const double film = lens.filmDistance / lens.millimetre * Dot(lens.axis, lens.normal), height = 0.5 * filmWidth;
    text += Line("    film...............%.5g mm behind the last\n", film + points.separation + points.rearVertex);
    text += Line("    entrance pupil.....at %.5g mm, diameter %.5g mm\n", points.entrancePupil,
                 2.0 * std::fabs(points.entranceRadius) * lens.glass->StopRadius());
    if (std::isfinite(points.exitPupil))
        text += Line("    exit pupil.........at %.5g mm, diameter %.5g mm\n", points.exitPupil,
                     2.0 * std::fabs(points.exitMagnification) * lens.glass->StopRadius());
    else
        text += "    exit pupil.........at infinity\n";
    const auto field = FieldAberrationsOf(*lens.glass, film, height);
    if (!field)
        return text + Line("    off the axis.......at %.4g mm no ray passes the centre of the stop\n", height);
    text += Line("    off the axis.......at %.4g mm distortion %.3g%%\n", height, 100.0 * field->distortion);
    text += Line("    image before film..%.3g mm (sagittal), %.3g mm (tangential)\n", field->sagittal, field->tangential);
    return text;
}

/// Relative to the d line, for a distant object.
std::string DispersionOf(const tilt_lens::SolvedLens& lens)
{
    if (!lens.dispersion)
        return "";
    const auto behind = [&](double wavelength)
    { return tilt_lens::GlassLens(AtWavelength(*lens.dispersion, wavelength)).Cardinal().backFocus - lens.glass->Cardinal().backFocus; };
    return Line("    focus of colours...%+.3g, %+.3g, %+.3g mm behind (450, 550, 650 nm)\n", behind(450.0), behind(550.0), behind(650.0));
}

std::string SqueezeOf(double squeeze)
{
    if (squeeze == 1.0)
        return "";
    return squeeze > 1.0 ? Line(", squeezed to %.4g of its width", 1.0 / squeeze) : Line(", squeezed to %.4g of its height", squeeze);
}

std::string FocusOf(const TiltLensCamera& block)
{
    std::string text;
    const auto add = [&](const FocusTarget& target)
    {
        if (target.kind != FocusTarget::NotUsed)
            text += "  Focus................" + target.Written() + ": " + Text(target.found, Length(target.found)) + "\n";
    };
    add(block.focusTarget);
    if (block.statement.family != tilt_lens::FocusFamily::SharpPoints)
        for (const FocusTarget& target : block.pointTargets)
            add(target);
    if (block.statement.focusScale)
        text += Line("  Focus................at %.6g units from the film before the lens is turned\n",
                     *block.statement.focusScale * block.statement.scale);
    return text;
}

/// Rounding, pixels.
const double kSharp = 1e-6;

std::string WithoutTilt(const Camera& camera, const tilt_lens::Lens& lens, double greatest, const std::function<std::string(double)>& blur)
{
    const double stop = lens.focalLength / lens.diameter;
    const auto without = BlurWithoutTilt(FromPov(camera.Location), camera.TiltLens.statement, lens);
    std::string text = "    without tilt.......";
    if (!without)
        return text + "this lens cannot be focused on them\n";
    if (blur(greatest) == blur(0.0))
        return text + blur(*without) + Line(" of blur or less at f/%.4g\n", stop);
    return text + Line("f/%.4g in place of f/%.4g for the same\n", stop * *without / greatest, stop);
}

std::string SharpPointsOf(const Camera& camera, const tilt_lens::Lens& lens, double width)
{
    const TiltLensCamera& block = camera.TiltLens;
    const tilt_lens::Statement& given = block.statement;
    if (given.family != tilt_lens::FocusFamily::SharpPoints)
        return "";
    const double pixels = width / given.filmWidth;
    const auto blurText = [=](double mm) { return mm * pixels < kSharp ? "no blur" : Line("%.4g pixels (%.3g mm)", mm * pixels, mm); };
    const std::vector<double> blurs = SharpPointBlurs(FromPov(camera.Location), given, lens);
    const double greatest = tilt_lens::GreatestBlur(blurs);
    std::string text = "  Sharp points........." + Line("%.0f, ", double(blurs.size())) + blurText(greatest) +
                       (greatest * pixels < kSharp ? "\n" : " of blur or less\n");
    for (std::size_t i = 0; i < blurs.size(); i++)
    {
        const FocusTarget& target = block.pointTargets[i];
        const double blur = std::fabs(blurs[i]);
        std::string name = "    " + Line("%.0f", double(i + 1));
        name.resize(23, '.');
        text += name + (target.kind == FocusTarget::NotUsed ? "" : target.Written() + ": ") +
                Text(given.sharpPoints[i], Length(given.sharpPoints[i])) + ": " + blurText(blur);
        if (blur * pixels >= kSharp)
            text += std::string(blurs[i] > 0.0 ? " before" : " behind") + (blur >= greatest * (1.0 - kSharp) ? ", binds" : "");
        text += "\n";
    }
    if (given.sharpWithin)
        text += "    limit.............." + blurText(*given.sharpWithin) +
                (greatest >= *given.sharpWithin * (1.0 - kSharp) ? "\n" : ", not reached by the widest aperture that is taken\n");
    return lens.diameter > 0.0 ? text + WithoutTilt(camera, lens, greatest, blurText) : text;
}

std::string GroupsOf(const TiltLensCamera& block)
{
    const tilt_lens::SolvedLens& lens = *block.lens;
    if (!lens.glass || block.statement.prescription->objectDistances.empty())
        return "";
    if (block.statement.filmDistance)
        return "  Inner focus..........groups as for infinity, since film_distance places the film\n";
    const tilt_lens::Prescription& prescription = *block.statement.prescription;
    const std::size_t states = prescription.objectDistances.size(), before = std::min(std::size_t(lens.groups), states - 1);
    const auto place = [&](std::size_t state)
    { return state == 0 ? std::string("infinity") : Line("%.5g mm", prescription.objectDistances[state - 1]); };
    std::string text = "  Inner focus..........groups " + Line("%.4g%% of the way from ", 100.0 * (lens.groups - double(before))) +
                       place(before) + " to " + place(before + 1) + "\n";
    const double moved = lens.filmDistance / lens.millimetre - FilmPlaceOf(prescription, lens.groups);
    if (std::fabs(moved) > 1e-6)
        text += Line("    film...............moved back by %.4g mm, because the groups do not reach the focus\n", moved);
    return text;
}

/// The plane's intersection with the axis, if in front, else its nearest point.
std::string PlaneOf(const Camera& camera, const tilt_lens::Lens& lens)
{
    const Vec3 location = FromPov(camera.Location);
    const double distance = Length(lens.focus), axisFocus = AxisFocusOf(lens);
    if (distance == 0.0)
        return "  Sharp plane..........at infinity\n";
    const bool crosses = axisFocus > 0.0 && std::isfinite(axisFocus);
    const Vec3 point = crosses ? axisFocus * lens.axis : lens.focus / (distance * distance);
    return "  Sharp plane through.." + Text(location + point, Length(location) + Length(point)) + "\n" + "    normal............." +
           Text(lens.focus / distance, 1.0) + "\n" +
           Line("    turned by..........%.4g degrees against the film\n", Tidy(FocusAngleOf(lens)));
}

std::string BudgetOf(const TiltLensView& view, const tilt_lens::SamplingStatistics& statistics, double seconds)
{
    if (!view.pilot)
        return "";
    const tilt_lens::BudgetPilot& pilot = *view.pilot;
    const tilt_lens::BudgetRound& chosen = pilot.Chosen();
    const double pixels = std::max<double>(1.0, statistics.Pixels());
    const double searched = view.search ? view.search->RaysOfPixel() : 0.0;
    std::string text = Line("  Budget...............%.4g samples a pixel, %.4g taken (%.2g in vain)\n", pilot.Budget() + searched,
                            statistics.Samples() / pixels + pilot.Lost() + searched, pilot.Lost());
    text += Line("    variance...........%.3g, chosen for this budget\n", chosen.variance);
    if (seconds > 0.0)
        text += Line("    speed..............%.0f samples a second\n", (statistics.Samples() + pilot.Lost() * pixels) / seconds);
    return text;
}

std::string SkippedOf(const TiltLensView& view, const tilt_lens::SamplingStatistics& statistics)
{
    const tilt_lens::SamplingLimits& limits = view.Limits();
    const double pixels = statistics.Pixels();
    std::string text;
    const auto stopped = statistics.pixelsBySamples.find(limits.max);
    if (limits.variance > 0.0 && stopped != statistics.pixelsBySamples.end())
    {
        const double share = 100.0 * stopped->second / pixels;
        text += "  Stopped by MAX......." + Count(stopped->second, "pixel") + " (" + Line(share < 99.5 ? "%.2g" : "%.0f", share) +
                "%), at " + Count(limits.max, "sample") + "\n";
    }
    if (view.pixelsBefore > 0)
        text += "  Skipped.............." + Count(view.pixelsBefore, "pixel") + ", done before the render was continued\n";
    if (limits.variance > 0.0)
        text += Line("  Ended at the minimum.%.0f of ", statistics.PixelsUpTo(limits.FirstRound())) + Count(pixels, "pixel") + ", after " +
                Count(limits.FirstRound(), "sample") + "\n";
    if (limits.Denoises())
        text += "  Reconstruction......." + Count(statistics.reconstructed, "pixel") +
                Line(", %.0f left as they were\n", pixels - statistics.reconstructed);
    if (statistics.lightPoints > 0)
        text += "  Area lights.........." + Count(statistics.lightPoints, "point") +
                Line(" sampled, %.0f skipped\n", statistics.lightPointsSkipped);
    if (!view.camera.emitters.Empty())
        text += "  Emitter samples......" + Count(statistics.emitterSampled, "sample") +
                Line(", emitters in view: %.0f\n", view.camera.emitters.Count());
    if (view.search)
        text += "  Lamps searched......." + Count(view.search->Rays(), "ray") + Line(", %.0f found\n", view.search->Lamps());
    if (view.objectsWithInterior > 0)
    {
        const std::size_t hold = std::count_if(view.aroundLens.begin(), view.aroundLens.end(),
                                               [](const ObjectAroundLens& around) { return around.holdsLens; });
        text += Line("  Around the lens......%.0f of ", view.aroundLens.size() - hold) + Count(view.objectsWithInterior, "object") +
                Line(" with interior tested by each ray, %.0f contain the whole lens\n", hold);
    }
    if (view.camera.lens->Glass() != nullptr)
    {
        const double passed = statistics.Samples() * (view.camera.lens->HasColours() ? 3.0 : 1.0), tried = passed + statistics.refusedRays;
        text += Line("  Blocked by the glass.%.0f of ", statistics.refusedRays) + Count(tried, "ray") +
                Line(" (%.2g%%)\n", tried > 0.0 ? 100.0 * statistics.refusedRays / tried : 0.0);
    }
    if (statistics.notFinite > 0)
        text += "  Not finite..........." + Count(statistics.notFinite, "sample") + ", counted as black\n";
    return text;
}

} // namespace

std::string SummarizeTiltLens(const TiltLensView& view, const TiltLensCost& cost)
{
    const tilt_lens::SamplingLimits& limits = view.Limits();
    const tilt_lens::SamplingStatistics statistics = view.Statistics();
    std::string text = "Tilt Lens Sampling\n";
    text += Line("  Time.................%.3f seconds, %.3f of CPU on ", cost.seconds, cost.cpuSeconds) + Count(cost.threads, "thread") +
            "\n";
    text += "  Rays................." + Line("%.0f", cost.rays) + ", and " + Count(cost.shadowTests, "test") + " for shadow\n";
    if (view.aids)
        return text + "  Samples per pixel....1, through the lens centre (focus aids)\n" + SkippedOf(view, statistics);
    const double pixels = std::max<double>(1.0, statistics.Pixels());
    text += Line("  Samples per pixel....mean %.1f, 99%% %.0f, most %.0f\n", statistics.Samples() / pixels, statistics.Quantile(0.99),
                 statistics.Most());
    text += BudgetOf(view, statistics, cost.seconds);
    if (limits.max < 2)
        return text + "  Standard error.......unknown: one sample per pixel gives no estimate\n" + SkippedOf(view, statistics);
    text += Line("  Standard error.......%.2g of white (estimated), ", statistics.StandardError());
    text += limits.variance > 0.0 ? Line(view.pilot ? "%.2g by the variance\n" : "%.2g asked for\n", std::sqrt(limits.variance))
                                  : std::string("all samples asked for\n");
    return text + SkippedOf(view, statistics);
}

std::string DescribeTiltLens(const Camera& camera, double width, const TiltLensAids* aids)
{
    const tilt_lens::SolvedLens& lens = *camera.TiltLens.lens;
    const double mm = 1.0 / lens.millimetre;
    const double usual = 1.0 / Length(lens.focus);

    std::string text = "Tilt Lens\n";
    text += Line("  Lens.................tilt %.4g, swing %.4g degrees\n", Tidy(TiltOf(lens)), Tidy(SwingOf(lens)));
    text += Line("  Focal length.........%.5g mm, film at %.5g mm\n", lens.focalLength * mm, lens.filmDistance * mm);
    text += FilmOf(camera, lens);
    if (lens.diameter > 0.0)
        text += Line("  Aperture.............f/%.4g, diameter %.5g mm", lens.focalLength / lens.diameter, lens.diameter * mm) +
                Line(" (%.5g units)", lens.diameter) + SqueezeOf(camera.TiltLens.statement.squeeze) + "\n";
    else
        text += "  Aperture.............none (pinhole): everything is sharp\n";
    if (lens.glass)
        text += GlassOf(lens, camera.TiltLens.statement.filmWidth) + DispersionOf(lens);
    text += CharacterOf(camera.TiltLens);
    text += FocusOf(camera.TiltLens) + SharpPointsOf(camera, lens, width) + GroupsOf(camera.TiltLens) + PlaneOf(camera, lens);
    text += "  Hinge line...........at " + Distance(HingeDistanceOf(lens), usual) + " from the lens\n";
    if (lens.diameter > 0.0)
    {
        const tilt_lens::SharpRange sharp = SharpRangeOf(lens, width, 1.0);
        text += "  Sharp on the axis....from " + Distance(sharp.near, usual) + " to " + Distance(sharp.far, usual) + " (blur of 1 pixel)\n";
    }
    if (aids != NULL)
        text += aids->Describe();
    return text;
}

} // namespace pov
