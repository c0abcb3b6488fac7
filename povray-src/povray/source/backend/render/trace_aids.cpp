// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/render/trace_aids.h"

#include <limits>

#include "backend/render/chief_camera_ray.h"
#include "backend/render/tilt_lens_tracer.h"
#include "backend/render/tracepixel.h"
#include "backend/scene/view.h"

#include "base/povdebug.h"

namespace pov
{

Colour AidPixel(TracePixel& trace, DBL x, DBL y, DBL width, DBL height)
{
    TiltLensTracer& tracer = *TiltLensTracer::Of(trace);
    const Camera& camera = tracer.GetCamera();
    const TiltLensAids& aids = *tracer.view->aids;
    Ray ray;
    Colour colour;
    if (!MakeChiefRay(trace, ray, x, y, width, height))
        return colour;  // outside a glass lens's image circle
    const DBL distance = aids.NeedsLight() ? tracer.TraceAlone(ray, (unsigned int)(int)x, (unsigned int)(int)y, colour)
                                           : FirstHit(trace, camera, ray);

    // blur depends on depth along the axis, even if the camera's normal deflects the ray
    const tilt_lens::Vec3& axis = tracer.view->camera.lens->Solved().axis;
    const double before = Dot(FromPov(ray.Origin) - FromPov(camera.Location), axis);  // 0 but for glass
    const double depth = before + distance * Dot(FromPov(ray.Direction), axis);
    return aids.Drawn(int(x), int(y), tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height),
                      distance < HUGE_VAL && depth > 0.0 ? depth : std::numeric_limits<double>::infinity(), colour);
}

void TraceAidTile(TracePixel& trace, const ViewData& view, const POVRect& rect, std::vector<Colour>& pixels)
{
    for (unsigned int y = rect.top; y <= rect.bottom; y++)
        for (unsigned int x = rect.left; x <= rect.right; x++)
            pixels.push_back(AidPixel(trace, x, y, view.GetWidth(), view.GetHeight()));
    TiltLensTracer::Of(trace)->Stats()[Number_Of_Pixels] += rect.GetArea();
}

} // namespace pov
