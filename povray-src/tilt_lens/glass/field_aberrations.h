// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file field_aberrations.h
/// A glass lens's distortion and field curvature, in the units of `distortion` and `field_curvature`.

#ifndef TILT_LENS_FIELD_ABERRATIONS_H
#define TILT_LENS_FIELD_ABERRATIONS_H

#include <optional>

#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

struct FieldAberrations
{
    double distortion;  ///< an ideal lens shows the point (1 + this) times as far from the axis
    double sagittal;    ///< mm by which rays equally far from the axis meet before the film
    double tangential;  ///< mm by which rays in the plane through the axis meet before the film
};

/// @param filmDistance  mm, from H' along the axis
/// @param height        mm, film point from the axis
/// @return              none if the ray through the stop's centre does not pass
std::optional<FieldAberrations> FieldAberrationsOf(const GlassLens& lens, double filmDistance, double height);

} // namespace tilt_lens

#endif
