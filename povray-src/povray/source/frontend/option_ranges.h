// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file option_ranges.h
/// Options that leave nothing to render, or nobody to render it.

#ifndef POVRAY_FRONTEND_OPTION_RANGES_H
#define POVRAY_FRONTEND_OPTION_RANGES_H

#include <string>

#include "base/configbase.h"
#include "base/povmscpp.h"

namespace pov_frontend
{

/// What is wrong with the picture's size, the part of it that is to be rendered, and the number of threads, as a
/// sentence or two; empty if nothing.
std::string RangeProblem(POVMS_Object& options);

} // namespace pov_frontend

#endif
