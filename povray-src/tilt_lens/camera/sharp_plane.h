// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_plane.h
/// The plane k.X = 1 with the least greatest blur over any number of points (docs/optics.md, "The best plane for many points"). Points are
/// z D, where D has a unit component along the camera's axis. The plane is the strict Chebyshev solution of the equations k.D = 1/z (J. R.
/// Rice, "Tchebycheff Approximation in a Compact Metric Space", 1962).
///
/// A *circuit* is a set of equations with linearly dependent D, any fewer of which are independent. If sum(w D) = 0 over it, its greatest
/// residual is at least |sum(w / z)| / sum|w|; the greatest such bound is the solution's (E. Stiefel, "Über diskrete und lineare
/// Tschebyscheff-Approximationen", Numerische Mathematik 1, 1959).

#ifndef TILT_LENS_SHARP_PLANE_H
#define TILT_LENS_SHARP_PLANE_H

#include <vector>

#include "tilt_lens/camera/real.h"

namespace tilt_lens
{

struct VergenceEquation
{
    RealVec direction;  ///< not zero
    Real vergence;
};

/// Directions are dependent if at most this share of one's length remains beside the others; typed coordinates round to less.
inline constexpr double kDependent = 1e-12;

/// @param points    camera axes, relative to the lens centre
/// @param written   the same points, world
/// @param location  lens centre, world
/// @throws OpticsError  a point not before the lens; all on a line, or in one plane with the lens centre; non-finite numbers
std::vector<VergenceEquation> VergenceEquations(const std::vector<RealVec>& points, const std::vector<Vec3>& written, const Vec3& location);

/// True if the strict solution is unique.
bool SpanSpace(const std::vector<VergenceEquation>& equations);

Real GreatestResidual(const std::vector<VergenceEquation>& equations, const RealVec& k);

/// The strict Chebyshev solution k, the shortest if there are several.
RealVec LeastGreatestBlur(const std::vector<VergenceEquation>& equations);

} // namespace tilt_lens

#endif
