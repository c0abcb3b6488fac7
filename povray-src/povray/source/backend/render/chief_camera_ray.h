// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file chief_camera_ray.h
/// Chief rays of any camera and their first hits.

#ifndef POVRAY_BACKEND_CHIEF_CAMERA_RAY_H
#define POVRAY_BACKEND_CHIEF_CAMERA_RAY_H

#include "backend/frame.h"
#include "backend/render/trace.h"

namespace pov
{

class Camera;
class Ray;
class TracePixel;

/// False: there is none.
bool MakeChiefRay(TracePixel& trace, Ray& ray, DBL x, DBL y, DBL width, DBL height);

/// Distance along a unit ray, or HUGE_VAL.
DBL FirstHit(Trace& trace, const Camera& camera, const Ray& ray);

/// @param x, y  film point
void BendByNormal(Ray& ray, const Camera& camera, double x, double y, TraceThreadData* thread);

} // namespace pov

#endif
