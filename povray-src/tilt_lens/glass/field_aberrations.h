// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file field_aberrations.h
/// What a lens of glass does to a picture beside its axis, in the numbers that `distortion` and `field_curvature` of the ideal
/// lens take.

#ifndef TILT_LENS_FIELD_ABERRATIONS_H
#define TILT_LENS_FIELD_ABERRATIONS_H

#include <optional>

#include "tilt_lens/glass/glass_lens.h"

namespace tilt_lens
{

struct FieldAberrations
{
    double distortion;  ///< where an ideal lens would show what the film shows there, farther from the axis by this part
    double sagittal;    ///< mm by which the image lies before the film for rays beside each other, at the same distance from the axis
    double tangential;  ///< the same for rays one above the other, in the plane through the axis
};

/// Of rays near the one through the middle of the stop.
/// @param filmDistance  mm, from H' along the axis, to a film at right angles to it
/// @param height        mm, of the film point from the axis
/// @return nothing where that ray does not pass
std::optional<FieldAberrations> FieldAberrationsOf(const GlassLens& lens, double filmDistance, double height);

} // namespace tilt_lens

#endif
