// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "oracle_case.h"

#include <set>
#include <stdexcept>

namespace witness
{

namespace
{

using nlohmann::json;

Vector ReadVector(const json& value)
{
    if (!value.is_array() || value.size() != 3)
        throw std::runtime_error("not a vector of three numbers: " + value.dump());
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

void AllowOnly(const json& object, const std::set<std::string>& names, const std::string& where)
{
    for (const auto& item : object.items())
        if (names.count(item.key()) == 0)
            throw std::runtime_error("unknown item \"" + item.key() + "\" in " + where);
}

std::optional<double> ReadOptional(const json& object, const char* name)
{
    if (!object.contains(name))
        return std::nullopt;
    return object.at(name).get<double>();
}

std::vector<Transformation> ReadTransformations(const json& list)
{
    std::vector<Transformation> all;
    for (const json& step : list)
    {
        AllowOnly(step, {"translate", "rotate", "scale"}, "transform");
        for (const auto& item : step.items())
        {
            const auto kind = item.key() == "translate" ? Transformation::Kind::Translate
                              : item.key() == "rotate"  ? Transformation::Kind::Rotate
                                                        : Transformation::Kind::Scale;
            all.push_back({kind, ReadVector(item.value())});
        }
    }
    return all;
}

void ReadFocus(const json& focus, CameraGiven& camera)
{
    AllowOnly(focus, {"tilt", "swing", "focus_tilt", "focus_swing", "through", "normal", "distance", "points"}, "focus");
    if (focus.contains("points"))
    {
        camera.focus = Focus::ThreePoints;
        for (int i = 0; i < 3; ++i)
            camera.points[i] = ReadVector(focus.at("points").at(i));
        return;
    }
    if (focus.contains("normal"))
    {
        camera.focus = Focus::Plane;
        camera.normal = ReadVector(focus.at("normal"));
        camera.distance = focus.at("distance").get<double>();
        return;
    }
    const bool plane = focus.contains("focus_tilt") || focus.contains("focus_swing");
    camera.focus = plane ? Focus::PlaneTurn : Focus::Lens;
    camera.turnUp = focus.value(plane ? "focus_tilt" : "tilt", 0.0);
    camera.turnRight = focus.value(plane ? "focus_swing" : "swing", 0.0);
    camera.points[0] = ReadVector(focus.at("through"));
}

CameraGiven ReadCamera(const json& text)
{
    AllowOnly(text,
              {"location", "look_at", "angle", "focal_length", "aperture", "f_stop", "film_width", "scene_unit", "focus", "shift", "blades",
               "blades_angle", "transform"},
              "camera");
    CameraGiven camera;
    camera.location = ReadVector(text.at("location"));
    camera.lookAt = ReadVector(text.at("look_at"));
    camera.angle = ReadOptional(text, "angle");
    camera.focalLength = ReadOptional(text, "focal_length");
    camera.aperture = ReadOptional(text, "aperture");
    camera.fStop = ReadOptional(text, "f_stop");
    if (camera.angle.has_value() == camera.focalLength.has_value())
        throw std::runtime_error("give one of angle and focal_length");
    if (camera.aperture.has_value() == camera.fStop.has_value())
        throw std::runtime_error("give one of aperture and f_stop");
    camera.filmWidth = text.value("film_width", 36.0);
    camera.sceneUnit = text.value("scene_unit", 1000.0);
    ReadFocus(text.at("focus"), camera);
    if (text.contains("shift"))
    {
        camera.shiftRight = text.at("shift").at(0).get<double>();
        camera.shiftUp = text.at("shift").at(1).get<double>();
    }
    camera.blades = text.value("blades", 0);
    camera.bladesAngle = text.value("blades_angle", 0.0);
    if (text.contains("transform"))
        camera.transformations = ReadTransformations(text.at("transform"));
    return camera;
}

} // namespace

OracleCase ReadCase(const json& text)
{
    AllowOnly(text, {"name", "scene", "picture", "camera", "purpose", "signs"}, "the case");
    OracleCase result;
    result.name = text.at("name").get<std::string>();
    result.scene = text.at("scene").get<std::string>();
    result.width = text.at("picture").at(0).get<int>();
    result.height = text.at("picture").at(1).get<int>();
    if (result.width < 1 || result.height < 1)
        throw std::runtime_error("picture must be at least one pixel wide and high");
    result.camera = ReadCamera(text.at("camera"));
    return result;
}

} // namespace witness
