// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file field_aberrations.h
/// Distortion and field curvature of a lens of glass, in the units of `distortion` and `field_curvature` of the ideal lens.

#ifndef TILT_LENS_FIELD_ABERRATIONS_H
#define TILT_LENS_FIELD_ABERRATIONS_H

#include <optional>

#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

struct FieldAberrations
{
    double distortion;  ///< relative: an ideal lens shows the same point at (1 + this) times the distance from the axis
    double sagittal;    ///< mm by which the sagittal image (rays at equal distance from the axis) lies before the film
    double tangential;  ///< mm by which the tangential image (rays in the plane through the axis) lies before the film
};

/// From rays near the chief ray, which passes the centre of the stop.
/// @param filmDistance  mm, from H' along the axis, to a film at right angles to it
/// @param height        mm, of the film point from the axis
/// @return              none if the chief ray does not pass
std::optional<FieldAberrations> FieldAberrationsOf(const GlassLens& lens, double filmDistance, double height);

} // namespace tilt_lens

#endif
