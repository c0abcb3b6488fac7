// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sharp_points.h
/// Aperture and blurs for `sharp_points`; the plane of sharp focus is the best for an ideal lens (sharp_plane.h).

#ifndef TILT_LENS_SHARP_POINTS_H
#define TILT_LENS_SHARP_POINTS_H

#include <optional>
#include <vector>

#include "tilt_lens/lens_camera/solve.h"

namespace tilt_lens
{

inline constexpr int kFewestSharpPoints = 3, kMostSharpPoints = 100;

/// No lens in air has less.
inline constexpr double kWidestStop = 0.5;

/// Sets the smallest f-number that keeps all sharp points within `sharpWithin`, at least kWidestStop and the lens's own.
/// @throws OpticsError  as Solve()
Statement WithWidestStop(const CameraFrame& camera, const Statement& given);

/// Signed blur (optics.h) of each sharp point, mm on the film.
/// @param location  of the lens centre, world
std::vector<double> SharpPointBlurs(const Vec3& location, const Statement& given, const Lens& lens);

double GreatestBlur(const std::vector<double>& blurs);

/// Greatest blur of the sharp points, mm on the film, with the same lens and f-number parallel to the film and focused best; none if
/// impossible. Needs an aperture.
std::optional<double> BlurWithoutTilt(const Vec3& location, const Statement& given, const Lens& lens);

} // namespace tilt_lens

#endif
