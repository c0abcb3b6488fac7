// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/render/chief_camera_ray.h"

#include <optional>

#include "backend/frame.h"
#include "backend/math/vector.h"
#include "backend/render/tilt_lens_tracer.h"
#include "backend/render/tracepixel.h"
#include "backend/texture/normal.h"

#include "base/povdebug.h"

namespace pov
{

bool MakeChiefRay(TracePixel& trace, Ray& ray, DBL x, DBL y, DBL width, DBL height)
{
    const bool blurs = trace.useFocalBlur;
    trace.useFocalBlur = false;
    const bool made = trace.CreateCameraRay(ray, x, y, width, height, 0);
    trace.useFocalBlur = blurs;
    const tilt_lens::LensCamera* const lens = trace.tiltLens ? trace.tiltLens->view->camera.lens.get() : NULL;
    if (!made || lens == NULL || !lens->BendsChiefRays())
        return made;
    const tilt_lens::FilmPoint film = tilt_lens::FilmPointAt(x + 0.5, y + 0.5, width, height);
    const std::optional<tilt_lens::LensRay> middle = lens->MiddleRay(film);
    if (!middle)
        return false;
    const VECTOR& location = trace.camera.Location;
    const tilt_lens::Vec3 direction = Normalized(middle->direction);
    Make_Vector(ray.Origin, location[X] + middle->origin.x, location[Y] + middle->origin.y, location[Z] + middle->origin.z);
    Make_Vector(ray.Direction, direction.x, direction.y, direction.z);
    BendByNormal(ray, trace.camera, film.x, film.y, trace.threadData);
    return true;
}

DBL FirstHit(Trace& trace, const Camera& camera, const Ray& ray)
{
    Intersection first;
    const NoSomethingFlagRayObjectCondition visible;
    const TrueRayObjectCondition any;
    if (camera.Max_Ray_Distance >= EPSILON)
        first.Depth = camera.Max_Ray_Distance;
    return trace.FindIntersection(first, ray, visible, any) ? first.Depth : HUGE_VAL;
}

void BendByNormal(Ray& ray, const Camera& camera, double x, double y, TraceThreadData* thread)
{
    if (camera.Tnormal == NULL)
        return;
    VECTOR film = {x, y, 0.0};
    Perturb_Normal(ray.Direction, camera.Tnormal, film, NULL, NULL, thread);
    VNormalizeEq(ray.Direction);
}

} // namespace pov
