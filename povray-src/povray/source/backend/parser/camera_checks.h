// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_checks.h
/// Checks a `tilt_lens` block against its camera. Require...() throw tilt_lens::OpticsError; the others return a warning, or "".

#ifndef POVRAY_BACKEND_CAMERA_CHECKS_H
#define POVRAY_BACKEND_CAMERA_CHECKS_H

#include <string>

#include "backend/parser/parse_tilt_lens.h"

namespace pov
{

void RequireConsistent(const Camera& camera);

void RequireQuality(const CameraDraft& draft, double budget);

void RequireFocalPoint(const TiltLensCamera& lens);

/// @param across  lower left to lower right corner
void RequireFacade(const tilt_lens::Vec3& across, const tilt_lens::Vec3& right);

std::string FocalPointWarning(const Camera& camera);

std::string SkyWarning(const tilt_lens::Vec3& sky, const tilt_lens::Vec3& assumed);

} // namespace pov

#endif
