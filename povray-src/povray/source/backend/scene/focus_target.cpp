// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/focus_target.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "backend/frame.h"
#include "backend/render/trace.h"
#include "backend/scene/objects.h"
#include "backend/scene/scene.h"
#include "backend/scene/threaddata.h"
#include "backend/scene/view.h"
#include "tilt_lens/camera/ray.h"

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::FocusFamily;
using tilt_lens::Lens;
using tilt_lens::OpticsError;
using tilt_lens::Statement;
using tilt_lens::Vec3;

namespace
{

const int kRaysAround = 1024;

/// Each step multiplies the disagreement of frame and focus by about focal length / distance.
const int kSteps = 50;

const double kEndless = 0.25 * BOUND_HUGE;

/// Relative distance of equal points.
const double kSamePoint = 1e-9;

std::string Text(const Vec3& v)
{
    char text[96];
    std::snprintf(text, sizeof text, "<%g, %g, %g>", v.x, v.y, v.z);
    return text;
}

class Finder
{
  public:
    Finder(const Camera& itsCamera, shared_ptr<SceneData> itsScene) :
        camera(itsCamera), location(FromPov(itsCamera.Location)), scene(itsScene), thread(itsScene)
    {
    }

    Vec3 OnObject(const FocusTarget& target);
    Vec3 InPicture(const FocusTarget& target, const Lens& lens);

  private:
    const Camera& camera;
    const Vec3 location;
    const shared_ptr<SceneData> scene;
    SceneThreadData thread;

    Ray Towards(const Vec3& way) const
    {
        const Vec3 unit = Normalized(way);
        const VECTOR direction = {unit.x, unit.y, unit.z};
        return Ray(camera.Location, direction);
    }

    std::optional<Vec3> Hit(ObjectPtr object, const Vec3& way);
};

std::optional<Vec3> Finder::Hit(ObjectPtr object, const Vec3& way)
{
    Intersection first;
    if (!Find_Intersection(&first, object, Towards(way), &thread))
        return {};
    return FromPov(first.IPoint);
}

Vec3 Finder::OnObject(const FocusTarget& target)
{
    const BBOX& box = target.object->BBox;
    const Vec3 half = 0.5 * Vec3{box.Lengths[X], box.Lengths[Y], box.Lengths[Z]};
    if (!(Length(half) < kEndless))
        throw OpticsError(target.Written() + ": the object is infinite or empty and has no centre to focus on. Give "
                                             "focus_at, focal_point or, for a plane, focal_plane.");
    const Vec3 middle = Vec3{box.Lower_Left[X], box.Lower_Left[Y], box.Lower_Left[Z]} + half - location;
    const Vec3 way = Length(middle) > 1e-6 * Length(half) ? middle : Length(half) * Normalized(FromPov(camera.Direction));
    const Vec3 aside = Normalized(Cross(way, std::fabs(way.x) < std::fabs(way.y) ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 across = Cross(Normalized(way), aside);
    for (int i = 0; i <= kRaysAround; i++)
    {
        // a spiral with one ray per equal part of the disc (H. Vogel, 1979)
        const double radius = Length(half) * std::sqrt(double(i) / kRaysAround), turn = i * M_PI * (3.0 - std::sqrt(5.0));
        const auto hit = Hit(target.object.get(), way + radius * std::cos(turn) * aside + radius * std::sin(turn) * across);
        if (hit)
            return *hit;
    }
    throw OpticsError(target.Written() + ": no ray from the lens to the object's bounding box hits the object. Is it "
                                         "empty, or smaller than a thirtieth of that box? Give focal_point.");
}

Vec3 Finder::InPicture(const FocusTarget& target, const Lens& lens)
{
    const Ray ray = Towards(ChiefRay(lens, {target.x - 0.5, target.y - 0.5}));
    const NoSomethingFlagRayObjectCondition visible;
    double nearest = camera.Max_Ray_Distance >= EPSILON ? camera.Max_Ray_Distance : HUGE_VAL;
    std::optional<Vec3> point;
    for (ObjectPtr object : scene->objects)
    {
        Intersection hit;
        if (visible(ray, object, 0.0) && Find_Intersection(&hit, object, ray, &thread) && hit.Depth < nearest)
        {
            nearest = hit.Depth;
            point = FromPov(hit.IPoint);
        }
    }
    if (!point)
        throw OpticsError(target.Written() + ": the ray through this place of the picture hits no object. "
                                             "Give a place where an object is, or focal_point.");
    return *point;
}

Lens Unfocused(const Camera& camera)
{
    Camera unfocused(camera);
    Statement& s = unfocused.TiltLens.statement;
    s = tilt_lens::IdealStatement(s);
    s.family = FocusFamily::LensTurn;
    s.sharpWithin.reset();
    s.tilt = s.swing = 0.0;
    if (s.focalLength)
        s.filmDistance = *s.focalLength;
    else
        s.focalPoint = FromPov(camera.Location) + FromPov(camera.Direction);
    TiltLensCamera::Solve(unfocused);
    return *unfocused.TiltLens.lens;
}

template<class Todo>
void ForEachTarget(TiltLensCamera& camera, FocusTarget::Kind kind, const Todo& todo)
{
    if (camera.focusTarget.kind == kind)
        todo(camera.focusTarget, camera.statement.focalPoint);
    for (std::size_t i = 0; i < camera.pointTargets.size(); i++)
        if (camera.pointTargets[i].kind == kind)
            todo(camera.pointTargets[i], camera.TargetPoint(i));
}

std::string Found(TiltLensCamera& block)
{
    std::string text;
    for (const FocusTarget::Kind kind : {FocusTarget::Object, FocusTarget::Picture})
        ForEachTarget(block, kind, [&](const FocusTarget& target, const Vec3&)
        { text += " " + target.Written() + " has found " + Text(target.found) + "."; });
    return text;
}

/// True if focus and angle of view agree.
bool FindInPicture(Finder& finder, Camera& camera)
{
    TiltLensCamera& block = camera.TiltLens;
    Lens lens = Unfocused(camera);
    for (int step = 0; step < kSteps; step++)
    {
        double moved = 0.0;
        ForEachTarget(block, FocusTarget::Picture, [&](FocusTarget& target, Vec3& point)
        {
            const Vec3 found = finder.InPicture(target, lens);
            const double change = Length(found - target.found) / Length(found - FromPov(camera.Location));
            moved = step == 0 ? 1.0 : std::max(moved, change);
            point = target.found = found;
        });
        try
        {
            TiltLensCamera::Solve(camera);
        }
        catch (const OpticsError& error)
        {
            throw OpticsError(error.what() + Found(block));
        }
        if (moved <= kSamePoint)
            return true;
        lens = *block.lens;
    }
    return false;
}

} // namespace

std::vector<std::string> FindFocus(Camera& camera, shared_ptr<SceneData> scene, double width)
{
    TiltLensCamera& block = camera.TiltLens;
    if (!block.given || block.IsComplete())
        return {};
    if (block.sharpWithinPixels)
        block.statement.sharpWithin = *block.sharpWithinPixels * block.statement.filmWidth / width;
    Finder finder(camera, scene);
    ForEachTarget(block, FocusTarget::Object, [&](FocusTarget& target, Vec3& point) { point = target.found = finder.OnObject(target); });
    const bool agree = FindInPicture(finder, camera);
    std::vector<std::string> warnings = Warnings(*block.lens, block.statement);
    if (!agree)
        warnings.push_back("focus_at lies on an edge: when the lens focuses on the nearer of two surfaces, the angle of view "
                           "changes and the ray hits the other one. Give a place a little off the edge.");
    return warnings;
}

} // namespace pov
