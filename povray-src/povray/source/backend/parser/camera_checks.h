// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_checks.h
/// Checks a `tilt_lens` block against the camera around it. The functions named Require throw tilt_lens::OpticsError; the others return a
/// warning, which is empty where nothing is wrong.

#ifndef POVRAY_BACKEND_CAMERA_CHECKS_H
#define POVRAY_BACKEND_CAMERA_CHECKS_H

#include <string>

#include "backend/parser/parse_tilt_lens.h"

namespace pov
{

/// Items of the block that exclude each other, or items of the camera.
void RequireConsistent(const Camera& camera);

/// `variance` and `confidence`, for which other cameras get a warning and the default.
void RequireQuality(const CameraDraft& draft);

/// A point from which tilt and swing turn the plane of sharp focus.
void RequireFocalPoint(const TiltLensCamera& lens);

/// Tilt_Lens_Facade cannot see whether the camera is left-handed or right-handed.
/// @param across  from the lower left to the lower right corner
void RequireFacade(const tilt_lens::Vec3& across, const tilt_lens::Vec3& right);

/// Warns of a focal point that has no effect.
std::string FocalPointWarning(const Camera& camera);

/// Warns of a camera whose sky is not the one that the macros of tilt_lens.inc assume.
std::string SkyWarning(const tilt_lens::Vec3& sky, const tilt_lens::Vec3& assumed);

} // namespace pov

#endif
