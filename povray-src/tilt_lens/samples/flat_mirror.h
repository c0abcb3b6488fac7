// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file flat_mirror.h
/// Images of small lamps in flat mirrors, as emitters: docs/sampling.md, section 4.

#ifndef TILT_LENS_FLAT_MIRROR_H
#define TILT_LENS_FLAT_MIRROR_H

#include <vector>

#include "tilt_lens/samples/emitter_sampling.h"

namespace tilt_lens
{

/// Relative to the lens centre, world axes, scene units.
struct FlatMirror
{
    Vec3 corner;
    Vec3 sides[2];  ///< of a parallelogram that reflects where their cross product points to
    bool unbounded;  ///< a plane along both sides, reflecting on either side
    double reflectance;  ///< of the brightest channel
};

/// Images in each mirror, the largest first, and in each ordered pair if they are few enough (Settings::greatestImages). The lens must see
/// an image in the mirror, brighter than its surroundings can be. Occlusion is ignored.
std::vector<Emitter> MirrorImages(const std::vector<Emitter>& sources, const std::vector<FlatMirror>& mirrors, double lensDiameter);

}  // namespace tilt_lens

#endif
