// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/camera_record.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <vector>

#include "backend/scene/focus_target.h"
#include "backend/scene/scene.h"
#include "base/image/colourspace.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

const char* RecordName()
{
    static const char* const name = std::getenv("TILT_LENS_PREVIEW");
    return name != NULL && *name != '\0' ? name : NULL;
}

struct RecordedCamera
{
    Camera camera;
    TiltLensPlace end;
};

/// Never destroyed, since objects that the cameras refer to may be destroyed before.
std::vector<RecordedCamera>& Recorded()
{
    static std::vector<RecordedCamera>& cameras = *new std::vector<RecordedCamera>;
    return cameras;
}

std::string Number(double value)
{
    std::ostringstream text;
    text << std::setprecision(17) << value;
    return std::isfinite(value) ? text.str() : "null";
}

std::string Number(const std::optional<double>& value)
{
    return value ? Number(*value) : "null";
}

std::string Vector(const Vec3& v)
{
    return "[" + Number(v.x) + ", " + Number(v.y) + ", " + Number(v.z) + "]";
}

std::string Matrix(const MATRIX& m)
{
    std::string text;
    for (const auto& row : m)
    {
        text += text.empty() ? "[" : ", ";
        for (int i = 0; i < 4; i++)
            text += (i == 0 ? "[" : ", ") + Number(row[i]);
        text += "]";
    }
    return text + "]";
}

const char* Truth(bool value)
{
    return value ? "true" : "false";
}

std::string Text(const UCS2String& name)
{
    std::ostringstream text;
    text << '"' << std::hex << std::setfill('0');
    for (const UCS2 unit : name)
        if (unit < 0x20 || unit > 0x7e || unit == '"' || unit == '\\')
            text << "\\u" << std::setw(4) << unsigned(unit);
        else
            text << char(unit);
    return text.str() + '"';
}

const char* FamilyName(tilt_lens::FocusFamily family)
{
    switch (family)
    {
        case tilt_lens::FocusFamily::FocusTurn: return "focusTurn";
        case tilt_lens::FocusFamily::FocalPlane: return "plane";
        case tilt_lens::FocusFamily::FocalPoints: return "points";
        case tilt_lens::FocusFamily::SharpPoints: return "sharp";
        default: return "lensTurn";
    }
}

std::string Vectors(const std::vector<Vec3>& list)
{
    std::string text;
    for (const Vec3& v : list)
        text += (text.empty() ? "" : ", ") + Vector(v);
    return "[" + text + "]";
}

std::string Block(const Statement& s)
{
    return "{\"family\": \"" + std::string(FamilyName(s.family)) + "\", \"filmWidth\": " + Number(s.filmWidth) +
           ", \"focalLength\": " + Number(s.focalLength) + ", \"sceneUnit\": " + Number(s.sceneUnit) + ", \"tilt\": " + Number(s.tilt) +
           ", \"swing\": " + Number(s.swing) + ", \"focusTilt\": " + Number(s.focusTilt) + ", \"focusSwing\": " + Number(s.focusSwing) +
           ", \"planeNormal\": " + Vector(s.planeNormal) + ", \"planeDistance\": " + Number(s.planeDistance) + ", \"points\": [" +
           Vector(s.points[0]) + ", " + Vector(s.points[1]) + ", " + Vector(s.points[2]) + "], \"sharpPoints\": " + Vectors(s.sharpPoints) +
           ", \"sharpWithin\": " + Number(s.sharpWithin) + ", \"shift\": [" + Number(s.shiftRight) + ", " + Number(s.shiftUp) +
           "], \"fStop\": " + Number(s.fStop) + ", \"blades\": " + Number(s.blades) + ", \"bladesAngle\": " + Number(s.bladesAngle) +
           ", \"focalPoint\": " + Vector(s.focalPoint) + ", \"aperture\": " + Number(s.aperture) + ", \"scale\": " + Number(s.scale) + "}";
}

std::string Words(const std::set<std::string>& words)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "\"" : ", \"") + word + "\"";
    return "[" + text + "]";
}

Statement WithFocus(const Camera& camera)
{
    Statement s = camera.TiltLens.statement;
    if (!(s.filmDistance || s.focusScale || s.sharpWithin) || !camera.TiltLens.lens)
        return s;
    const tilt_lens::Lens& lens = *camera.TiltLens.lens;
    if (s.sharpWithin)
        s.fStop = lens.focalLength / lens.diameter;
    if (!(s.filmDistance || s.focusScale))
        return s;
    const Vec3 location = FromPov(camera.Location);
    const double distance = Length(lens.focus), axisFocus = AxisFocusOf(lens), farthest = 1e9 * lens.filmDistance;
    s.filmDistance.reset();
    s.focusScale.reset();
    if (distance == 0.0 || axisFocus > 0.0)
        s.focalPoint = location + std::min(axisFocus, farthest) * lens.axis;
    else
    {
        s.family = tilt_lens::FocusFamily::FocalPlane;
        s.planeNormal = lens.focus / distance;
        s.planeDistance = 1.0 / distance + Dot(s.planeNormal, location);
    }
    return s;
}

Statement Ideal(const Camera& camera, const Statement& s)
{
    return IdealStatement(WithGroups(s, camera.TiltLens.lens ? camera.TiltLens.lens->groups : 0.0));
}

std::string Described(const Camera& camera)
{
    return "\"perspective\": " + std::string(Truth(camera.Type == PERSPECTIVE_CAMERA)) +
           ", \"location\": " + Vector(FromPov(camera.Location)) + ", \"direction\": " + Vector(FromPov(camera.Direction)) +
           ", \"right\": " + Vector(FromPov(camera.Right)) + ", \"up\": " + Vector(FromPov(camera.Up)) +
           ", \"sky\": " + Vector(FromPov(camera.Sky)) + ", \"focusDistance\": " + Number(camera.Focal_Distance) +
           ", \"aperture\": " + Number(camera.Aperture) + ", \"bokeh\": " + Truth(camera.Bokeh != NULL) +
           ", \"normal\": " + Truth(camera.Tnormal != NULL) + ", \"matrix\": " + Matrix(camera.Trans->matrix) +
           ", \"inverse\": " + Matrix(camera.Trans->inverse) + ", \"scale\": " + Number(camera.TiltLens.statement.scale) +
           ", \"words\": " + Words(camera.TiltLens.words) +
           ", \"block\": " + (camera.TiltLens.given ? Block(Ideal(camera, WithFocus(camera))) : "null") + "}";
}

std::string Gamma(const SceneData& scene)
{
    if (!scene.workingGammaToSRGB)
        return "null";
    const SimpleGammaCurvePtr& curve = scene.workingGamma;
    if (GammaCurve::IsNeutral(curve))
        return "1";
    const double half = curve->Decode(0.5f);
    if (std::fabs(half - SRGBGammaCurve::Get()->Decode(0.5f)) < 1e-6)
        return "\"sRGB\"";
    return Number(std::log(half) / std::log(0.5));
}

} // namespace

bool CamerasAreRecorded()
{
    return RecordName() != NULL;
}

void RecordCamera(const Camera& camera, const TiltLensPlace& end)
{
    if (CamerasAreRecorded())
        Recorded().push_back({camera, end});
}

void FinishCameraRecord(Camera& view, shared_ptr<SceneData> scene, double width)
{
    if (!CamerasAreRecorded())
        return;
    std::string text = "{\"cameras\": [";
    for (RecordedCamera& recorded : Recorded())
    {
        try
        {
            FindFocus(recorded.camera, scene, width);
        }
        catch (const tilt_lens::OpticsError&)  // reported for the picture's camera
        {
        }
        text += (text.back() == '[' ? "\n" : ",\n") + ("{\"file\": " + Text(recorded.end.file)) +
                ", \"line\": " + Number(double(recorded.end.line)) + ", \"offset\": " + Number(double(recorded.end.offset)) + ", " +
                Described(recorded.camera);
    }
    text += "],\n\"view\": {" + Described(view) + ",\n\"gamma\": " + Gamma(*scene) + "}\n";
    Recorded().clear();
    std::ofstream stream(RecordName(), std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw POV_EXCEPTION(kCannotOpenFileErr, std::string("Cannot write the file that TILT_LENS_PREVIEW names: ") + RecordName());
    view.Aperture = 0.0;
    view.TiltLens.aids = tilt_lens::FocusAids();
    view.TiltLens.statement = Ideal(view, view.TiltLens.statement);
    view.TiltLens.statement.aperture = 0.0;
    view.TiltLens.statement.fStop.reset();
    view.TiltLens.statement.sharpWithin.reset();
    if (view.TiltLens.given)
        TiltLensCamera::Solve(view);
}

} // namespace pov
