// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file option_ranges.h
/// Checks options whose values make a render impossible.

#ifndef POVRAY_FRONTEND_OPTION_RANGES_H
#define POVRAY_FRONTEND_OPTION_RANGES_H

#include <string>

#include "base/configbase.h"
#include "base/povmscpp.h"

namespace pov_frontend
{

/// An error in the picture's size, its rendered part, or the number of threads, in one or two sentences; empty if there is none.
std::string RangeProblem(POVMS_Object& options);

} // namespace pov_frontend

#endif
