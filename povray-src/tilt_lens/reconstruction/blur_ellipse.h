// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file blur_ellipse.h
/// Shape of a circle of confusion (spread.h), as a matrix in squared pixels.

#ifndef TILT_LENS_BLUR_ELLIPSE_H
#define TILT_LENS_BLUR_ELLIPSE_H

#include "tilt_lens/math/simd.h"
#include "tilt_lens/reconstruction/spread.h"

namespace tilt_lens
{

struct BlurEllipse
{
    float xx = 0.0f, yy = 0.0f, lean = 0.0f, determinant = 0.0f;

    explicit TILT_LENS_INLINED BlurEllipse(const CircleOfConfusion& circle)
    {
        if (circle.lens == nullptr)
            return;
        const float scale = circle.lens->BoundingRadius() * circle.lens->BoundingRadius();
        xx = scale * (circle.xa * circle.xa + circle.xb * circle.xb);
        yy = scale * (circle.ya * circle.ya + circle.yb * circle.yb);
        const float xy = scale * (circle.xa * circle.ya + circle.xb * circle.yb);
        lean = xy / yy;
        determinant = IsFinite(circle.x) ? xx * yy - xy * xy : 0.0f;
    }

    TILT_LENS_INLINED bool IsWide() const { return Min(yy, xx) >= 1.0f && determinant >= 1.0f && IsFinite(determinant); }
};

} // namespace tilt_lens

#endif
