// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_plane.h
/// The plane k.X = 1 that leaves the least greatest blur over any number of points.
///
/// A point P = z D, where D has a unit component along the camera's axis, has a circle of confusion proportional to the difference
/// of vergences |1/z - k.D| (optics.h). The factor, film distance times lens diameter, is taken as fixed: it changes by a share
/// of about the focal length times the change of k. The difference is linear in k, so that the best plane is a linear program in k and the greatest blur
/// v: the Chebyshev solution of as many equations k.D = 1/z as there are points.
///
/// By duality v is determined by a *circuit*: equations whose directions D are linearly dependent, while any fewer of them are
/// independent. Four directions in general position are one; so are three in a plane, or two that are equal. If sum(w D) = 0, no
/// plane leaves less over the circuit than |sum(w / z)| / sum|w|, and planes that reach it leave exactly that, with the sign of w,
/// at each of its points. The greatest such deviation of all circuits is v (E. Stiefel, "Über diskrete und lineare
/// Tschebyscheff-Approximationen", Numerische Mathematik 1, 1959, for directions in general position).
///
/// A circuit of fewer than four points leaves a choice of planes with the same greatest blur. Then the plane is taken that also makes
/// the greatest blur of all other points least, and so on: the strict Chebyshev solution (J. R. Rice, "Tchebycheff Approximation
/// in a Compact Metric Space", 1962). It is unique where the directions span space, and does not depend on the points' order.
///
/// Three points get the plane through them.

#ifndef TILT_LENS_SHARP_PLANE_H
#define TILT_LENS_SHARP_PLANE_H

#include <vector>

#include "tilt_lens/camera/real.h"

namespace tilt_lens
{

/// The equation k.direction = vergence.
struct VergenceEquation
{
    RealVec direction;  ///< D, not zero
    Real vergence;  ///< 1/z
};

/// Directions count as linearly dependent where no more than this share of one's length is left beside the others. Coordinates
/// that were typed with a few digits are rounded by less.
inline constexpr double kDependent = 1e-12;

/// The equations of points.
/// @param points    camera axes, relative to the lens centre
/// @param written   the same points, world
/// @param location  of the lens centre, world
/// @throws OpticsError  a point beside or behind the lens; all of them on a line, or in one plane with the lens centre; numbers
///                      that are not finite
std::vector<VergenceEquation> VergenceEquations(const std::vector<RealVec>& points, const std::vector<Vec3>& written, const Vec3& location);

/// Whether the directions span space, so that the strict solution is unique.
bool SpanSpace(const std::vector<VergenceEquation>& equations);

/// The greatest |vergence - k.direction|.
Real GreatestResidual(const std::vector<VergenceEquation>& equations, const RealVec& k);

/// The strict Chebyshev solution k. Where the directions do not span space, the shortest such k.
RealVec LeastGreatestBlur(const std::vector<VergenceEquation>& equations);

}  // namespace tilt_lens

#endif
