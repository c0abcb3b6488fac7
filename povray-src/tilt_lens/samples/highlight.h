// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file highlight.h
/// Highlights of light sources on spheres, as emitters: docs/sampling.md, section 4.

#ifndef TILT_LENS_HIGHLIGHT_H
#define TILT_LENS_HIGHLIGHT_H

#include <optional>

#include "tilt_lens/samples/emitter_sampling.h"

namespace tilt_lens
{

/// Relative to the lens centre, world axes, scene units.
struct GlossySphere
{
    Vec3 centre;
    double radius;
    double peak;  ///< radiance added at its brightest point
    /// The highlight falls as cos^exponent of the angle between normal and bisector of the directions to lens and light.
    double exponent;
    double around;  ///< possible radiance around it
};

/// Part of the sphere that sends most of the highlight to the lens; none if lens or light is within the sphere.
std::optional<Emitter> HighlightOf(const GlossySphere& sphere, const Vec3& light, double lensDiameter);

}  // namespace tilt_lens

#endif
