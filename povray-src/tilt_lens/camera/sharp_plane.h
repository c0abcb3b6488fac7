// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_plane.h
/// The plane k.X = 1 of least greatest blur over any number of points; three points get the plane through them.
///
/// A point P = z D, where D has a unit component along the camera's axis, has a blur proportional to |1/z - k.D| (optics.h). The factor,
/// film distance times lens diameter, is taken as fixed: its relative change is about the focal length times the change of k. So the
/// plane is the Chebyshev solution of the equations k.D = 1/z, with the greatest residual v.
///
/// By duality v is determined by a *circuit*: equations with linearly dependent D, any fewer of which are independent. Examples are four
/// directions in general position, three in a plane, two equal ones. If sum(w D) = 0, no plane leaves less over the circuit than |sum(w /
/// z)| / sum|w|; planes that reach it leave exactly that, with the sign of w, at each point. The greatest such deviation is v (E.
/// Stiefel, "Über diskrete und lineare Tschebyscheff-Approximationen", Numerische Mathematik 1, 1959, for general position).
///
/// A circuit of fewer than four points leaves a choice of planes. Then the greatest blur of all other points is made least, too, and so
/// on: the strict Chebyshev solution (J. R. Rice, "Tchebycheff Approximation in a Compact Metric Space", 1962). It is unique where the
/// directions span space, and does not depend on the points' order.

#ifndef TILT_LENS_SHARP_PLANE_H
#define TILT_LENS_SHARP_PLANE_H

#include <vector>

#include "tilt_lens/camera/real.h"

namespace tilt_lens
{

/// k.direction = vergence
struct VergenceEquation
{
    RealVec direction;  ///< D, not zero
    Real vergence;  ///< 1/z
};

/// Directions are dependent where no more than this share of one's length is left beside the others. Coordinates typed with a few digits
/// are rounded by less.
inline constexpr double kDependent = 1e-12;

/// @param points    camera axes, relative to the lens centre
/// @param written   the same points, world
/// @param location  of the lens centre, world
/// @throws OpticsError  a point beside or behind the lens; all on a line, or in one plane with the lens centre; non-finite numbers
std::vector<VergenceEquation> VergenceEquations(const std::vector<RealVec>& points, const std::vector<Vec3>& written, const Vec3& location);

/// True if the directions span space: the strict solution is unique.
bool SpanSpace(const std::vector<VergenceEquation>& equations);

/// Greatest |vergence - k.direction|.
Real GreatestResidual(const std::vector<VergenceEquation>& equations, const RealVec& k);

/// The strict Chebyshev solution k; the shortest one if directions do not span space.
RealVec LeastGreatestBlur(const std::vector<VergenceEquation>& equations);

} // namespace tilt_lens

#endif
