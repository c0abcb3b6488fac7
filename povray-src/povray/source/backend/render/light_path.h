// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file light_path.h
/// How far a camera ray's light has come, through flat mirrors and panes. A flat mirror keeps vergences: a lamp seen in it is
/// blurred as at the end of the whole path, not as the mirror. Curved surfaces change them, so that there the path ends at the first
/// surface.

#ifndef TILT_LENS_LIGHT_PATH_H
#define TILT_LENS_LIGHT_PATH_H

#include "backend/frame.h"

namespace pov
{

/// Follows TraceRay's recursion: the path of a ray goes on with that of the ray that it gave rise to which brought half of its light
/// or more. Where all is black, it goes on as well.
class LightPath
{
  public:
    /// Only while a camera asks.
    bool wanted = false;

    /// The brightest of the rays that one ray gave rise to.
    struct Brightest
    {
        double light = 0.0, length = 0.0;
    };

    /// A ray has hit a surface, whose light is computed next.
    /// @return  for End()
    Brightest Begin()
    {
        const Brightest outer = brightest;
        brightest = Brightest();
        return outer;
    }

    /// The ray's light is known.
    /// @param hit  object; NULL if there is none
    /// @param distance  to it, scene units
    /// @param weight  of the ray, as TraceRay has it
    void End(Brightest outer, const ObjectBase* hit, double distance, const Colour& colour, double weight)
    {
        const double light = weight * colour.greyscale();
        length = hit != NULL && 2.0 * brightest.light >= light && IsFlat(*hit) ? distance + brightest.length : distance;
        brightest = light >= outer.light ? Brightest{light, length} : outer;
    }

    /// Length of the last path, scene units; HUGE_VAL where it ends at no surface.
    double Length() const { return length; }

  private:
    Brightest brightest;
    double length = HUGE_VAL;

    static bool IsFlat(const ObjectBase& object);
};

} // namespace pov

#endif
