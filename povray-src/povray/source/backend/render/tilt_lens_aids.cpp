// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_aids.cpp
/// TiltLensTracer's part in focus aids: pictures of one ray per pixel, through the lens centre.

#include <limits>
#include <optional>
#include <vector>

#include "backend/frame.h"
#include "backend/colour/colour.h"
#include "backend/math/vector.h"
#include "backend/render/tilt_lens_tracer.h"
#include "backend/render/tracepixel.h"
#include "backend/texture/normal.h"

#include "base/povdebug.h"

namespace pov
{

/// Distance along the unit direction to the first visible surface, or HUGE_VAL.
DBL TiltLensTracer::FirstHit(TracePixel& trace, const Ray& ray)
{
    Intersection first;
    const NoSomethingFlagRayObjectCondition visible;
    const TrueRayObjectCondition any;
    if (trace.camera.Max_Ray_Distance >= EPSILON)
        first.Depth = trace.camera.Max_Ray_Distance;
    return trace.FindIntersection(first, ray, visible, any) ? first.Depth : HUGE_VAL;
}

/// Chief ray of a pixel's centre: POV-Ray's own, except for a lens with distortion or of glass.
/// @return  false if the camera has none there
bool TiltLensTracer::ChiefCameraRay(TracePixel& trace, Ray& ray, DBL x, DBL y, DBL width, DBL height)
{
    if (!trace.CreateCameraRay(ray, x, y, width, height, 0))
        return false;
    const TiltLensTracer* const tracer = Of(trace);
    if (tracer == NULL || !tracer->view->camera->BendsChiefRays())
        return true;
    const tilt_lens::FilmPoint film = tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height);
    const std::optional<tilt_lens::LensRay> middle = tracer->view->camera->MiddleRay(film);
    if (!middle)
        return false;
    const VECTOR& location = trace.camera.Location;
    const tilt_lens::Vec3 direction = Normalized(middle->direction);
    Make_Vector(ray.Origin, location[X] + middle->origin.x, location[Y] + middle->origin.y, location[Z] + middle->origin.z);
    Make_Vector(ray.Direction, direction.x, direction.y, direction.z);
    if (trace.camera.Tnormal != NULL)
    {
        VECTOR point = {film.x, film.y, 0.0};
        Perturb_Normal(ray.Direction, trace.camera.Tnormal, point, NULL, NULL, trace.threadData);
        VNormalizeEq(ray.Direction);
    }
    return true;
}

void TiltLensTracer::TraceAid(DBL x, DBL y, DBL width, DBL height, Colour& colour)
{
    Ray ray;
    colour = Colour();
    if (!ChiefCameraRay(trace, ray, x, y, width, height))
        return;  // outside the image circle of a lens of glass
    DBL distance;
    if (view->aids->NeedsLight())
    {
        const tilt_lens::PixelSampler sequence((unsigned int)(int)x, (unsigned int)(int)y, view->seed);
        pixel = &sequence;
        index = 0;
        LeadGenerators();
        BeginNumbers();
        Trace::TraceTicket ticket(trace.maxTraceLevel, trace.adcBailout, trace.sceneData->outputAlpha);
        distance = trace.TraceRay(ray, colour, 1.0, ticket, false, trace.camera.Max_Ray_Distance);
        EndSample();
    }
    else
        distance = FirstHit(trace, ray);

    // a camera normal may have deflected the ray: blur depends on the depth along the axis
    const tilt_lens::Vec3& axis = view->camera->Solved().axis;
    const double before = Dot(FromPov(ray.Origin) - FromPov(trace.camera.Location), axis);  // 0 but for a lens of glass
    const double depth = before + distance * Dot(FromPov(ray.Direction), axis);
    colour = view->aids->Drawn(int(x), int(y), tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height),
                               distance < HUGE_VAL && depth > 0.0 ? depth : std::numeric_limits<double>::infinity(), colour);
}

void TiltLensTracer::TraceAidTile(const POVRect& rect, unsigned int width, unsigned int height,
                                  std::vector<Colour>& pixels)
{
    effort.clear();
    pixels.clear();
    for (unsigned int y = rect.top; y <= rect.bottom; y++)
        for (unsigned int x = rect.left; x <= rect.right; x++)
        {
            pixels.push_back(Colour());
            TraceAid(x, y, width, height, pixels.back());
        }
    trace.threadData->Stats()[Number_Of_Pixels] += rect.GetArea();
}

} // namespace pov
