// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file layer_attributes.cpp
/// Names are those of OpenEXR's list (openexr.com, "Standard Attributes"); others begin with "tiltLens:".

#include "backend/scene/layer_attributes.h"

#include <cmath>

#include "backend/frame.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Vec3;

namespace
{

std::vector<double> Numbers(const Vec3& v)
{
    return {v.x, v.y, v.z};
}

/// Camera's axes, and window at distance 1.
struct Window
{
    Vec3 x, y, z;
    double width, height, middleX, middleY;

    explicit Window(const Camera& camera)
    {
        const Vec3 right = FromPov(camera.Right), up = FromPov(camera.Up), direction = FromPov(camera.Direction);
        z = DepthAxis(camera);
        x = Normalized(right);
        y = Normalized(up - Dot(up, x) * x);
        const double distance = Dot(direction, z);
        width = Length(right) / distance;
        height = Dot(up, y) / distance;
        middleX = Dot(direction, x) / distance;
        middleY = Dot(direction, y) / distance;
    }
};

/// For row vectors.
std::vector<double> Matrix(const Vec3& location, const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& w, double wOffset)
{
    const double offsets[4] = {-Dot(location, x), -Dot(location, y), -Dot(location, z), wOffset - Dot(location, w)};
    return {x.x, y.x, z.x, w.x, x.y, y.y, z.y, w.y, x.z, y.z, z.z, w.z, offsets[0], offsets[1], offsets[2], offsets[3]};
}

void AddProjection(std::vector<LayerAttribute>& list, const Camera& camera)
{
    const Window window(camera);
    const Vec3 location = FromPov(camera.Location), none{0.0, 0.0, 0.0};
    list.push_back({"screenWindowWidth", {window.width}});
    list.push_back({"screenWindowCenter", {window.middleX, window.middleY}});
    list.push_back({"worldToCamera", Matrix(location, window.x, window.y, window.z, none, 1.0)});
    // maps upper left and lower right corners to (0, 0) and (1, 1) after division by w = depth
    const Vec3 u = (window.x + (0.5 * window.width - window.middleX) * window.z) / window.width;
    const Vec3 v = ((0.5 * window.height + window.middleY) * window.z - window.y) / window.height;
    list.push_back({"worldToNDC", Matrix(location, u, v, window.z, window.z, 0.0)});
    const double degrees = 180.0 / M_PI;
    list.push_back(
        {"tiltLens:fieldOfView", {2.0 * degrees * std::atan(0.5 * window.width), 2.0 * degrees * std::atan(0.5 * window.height)}});
}

void AddLens(std::vector<LayerAttribute>& list, const Camera& camera, unsigned int width)
{
    const tilt_lens::Lens& lens = *camera.TiltLens.lens;
    const tilt_lens::Statement& given = camera.TiltLens.statement;
    const double mm = 1.0 / lens.millimetre, axisFocus = AxisFocusOf(lens);
    const double filmHeight = given.filmWidth * Length(lens.up) / Length(lens.right);
    list.push_back({"nominalFocalLength", {lens.focalLength * mm}});
    list.push_back({"pinholeFocalLength", {lens.filmDistance * mm}});
    list.push_back({"sensorOverallDimensions", {given.filmWidth, filmHeight}});
    if (axisFocus > 0.0 && std::isfinite(axisFocus))
        list.push_back({"focus", {axisFocus * mm / 1000.0}});
    if (lens.diameter > 0.0)
    {
        list.push_back({"aperture", {lens.focalLength / lens.diameter}});
        list.push_back({"tiltLens:diameter", {lens.diameter * mm}});
        list.push_back({"tiltLens:blurPerVergence", {BlurPerVergence(lens, width)}});
    }
    list.push_back({"tiltLens:tilt", {TiltOf(lens)}});
    list.push_back({"tiltLens:swing", {SwingOf(lens)}});
    list.push_back({"tiltLens:shift", {given.shiftRight, given.shiftUp}});
    list.push_back({"tiltLens:hingeDistance", {HingeDistanceOf(lens)}});
    list.push_back({"tiltLens:millimetresPerUnit", {mm}});
    const double distance = Length(lens.focus);
    if (distance == 0.0)
        return;
    const Vec3 normal = lens.focus / distance;
    list.push_back({"tiltLens:focusNormal", Numbers(normal)});
    list.push_back({"tiltLens:focusDistance", {1.0 / distance + Dot(normal, FromPov(camera.Location))}});
}

} // namespace

bool HasDepthAxis(const Camera& camera)
{
    return camera.Type == PERSPECTIVE_CAMERA || camera.Type == ORTHOGRAPHIC_CAMERA;
}

Vec3 DepthAxis(const Camera& camera)
{
    const Vec3 axis = Normalized(Cross(FromPov(camera.Right), FromPov(camera.Up)));
    return Dot(axis, FromPov(camera.Direction)) < 0.0 ? -axis : axis;
}

std::vector<LayerAttribute> LayerAttributesOf(const Camera& camera, unsigned int width)
{
    std::vector<LayerAttribute> list;
    if (camera.Type != PERSPECTIVE_CAMERA)
        return list;
    AddProjection(list, camera);
    if (camera.TiltLens.given)
        AddLens(list, camera, width);
    return list;
}

} // namespace pov
