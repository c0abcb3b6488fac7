// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file light_path.h
/// Length of a camera ray's path through flat mirrors and panes, which preserve vergences.

#ifndef TILT_LENS_LIGHT_PATH_H
#define TILT_LENS_LIGHT_PATH_H

#include "backend/frame.h"

namespace pov
{

/// Follows TraceRay's recursion along rays that bring at least half of the light, or any if all are black.
class LightPath
{
  public:
    bool wanted = false;

    struct Brightest
    {
        double light = 0.0, length = 0.0;
    };

    Brightest Begin()
    {
        const Brightest outer = brightest;
        brightest = Brightest();
        return outer;
    }

    /// @param hit       may be NULL
    /// @param distance  scene units
    void End(Brightest outer, const ObjectBase* hit, double distance, const Colour& colour, double weight)
    {
        const double light = weight * colour.greyscale();
        length = hit != NULL && 2.0 * brightest.light >= light && IsFlat(*hit) ? distance + brightest.length : distance;
        brightest = light >= outer.light ? Brightest{light, length} : outer;
    }

    /// Scene units; HUGE_VAL without a surface.
    double Length() const { return length; }

  private:
    Brightest brightest;
    double length = HUGE_VAL;

    static bool IsFlat(const ObjectBase& object);
};

} // namespace pov

#endif
