// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_points.h
/// `sharp_points`: the points that the plane of sharp focus serves as well as it can (sharp_plane.h), the aperture that holds them
/// within a blur, and the numbers that a photographer asks for.
///
/// The plane is the best for an ideal lens. Blurs and the aperture are those of the lens as it is, with its distortion and field
/// curvature.

#ifndef TILT_LENS_SHARP_POINTS_H
#define TILT_LENS_SHARP_POINTS_H

#include <optional>
#include <vector>

#include "tilt_lens/lens_camera/solve.h"

namespace tilt_lens
{

/// Least and greatest number of points in one block.
inline constexpr int kFewestSharpPoints = 3, kMostSharpPoints = 100;

/// No lens in air has a smaller f-number.
inline constexpr double kWidestStop = 0.5;

/// A statement with the smallest f-number, not below kWidestStop and not wider than the lens itself opens, that keeps all sharp
/// points within `sharpWithin`. Others are left as they are.
/// @throws OpticsError  as Solve()
Statement WithWidestStop(const CameraFrame& camera, const Statement& given);

/// Signed blur (optics.h) of each sharp point, mm on the film.
/// @param location  of the lens centre, world
/// @param lens      that the statement makes there
std::vector<double> SharpPointBlurs(const Vec3& location, const Statement& given, const Lens& lens);

/// The greatest magnitude of some blurs.
double GreatestBlur(const std::vector<double>& blurs);

/// Greatest blur of the sharp points, mm on the film, through the same lens at the same f-number, parallel to the film and focused
/// so that it is least. Nothing where that lens cannot focus so. Not for a pinhole.
std::optional<double> BlurWithoutTilt(const Vec3& location, const Statement& given, const Lens& lens);

} // namespace tilt_lens

#endif
