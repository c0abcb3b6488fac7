// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file flat_mirror.h
/// Images of small lamps in flat mirrors: docs/sampling.md, section 4. A ray towards the image of a lamp is reflected to the lamp itself,
/// so emitter sampling aims at images as it does at lamps.

#ifndef TILT_LENS_FLAT_MIRROR_H
#define TILT_LENS_FLAT_MIRROR_H

#include <vector>

#include "tilt_lens/sampling/emitter_sampling.h"

namespace tilt_lens
{

/// Relative to the lens centre, world axes, scene units.
struct FlatMirror
{
    Vec3 corner;
    Vec3 sides[2];  ///< of a parallelogram that reflects where their cross product points to
    bool unbounded;  ///< the sides are two directions in a plane that reflects on either side
    double reflectance;  ///< of the brightest channel
};

/// Images in each mirror, the largest mirrors if there are many, and in each ordered pair of mirrors unless there are many
/// (settings.greatestImages). An image counts if
/// a lens of this diameter sees it in the mirror and if it is brighter than what may be around it; objects before it are not considered.
std::vector<Emitter> MirrorImages(const std::vector<Emitter>& sources, const std::vector<FlatMirror>& mirrors, double lensDiameter);

}  // namespace tilt_lens

#endif
