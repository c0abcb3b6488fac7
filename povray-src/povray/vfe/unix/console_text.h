// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file console_text.h
/// What the console prints, beside what upstream prints.

#ifndef POVRAY_VFE_UNIX_CONSOLE_TEXT_H
#define POVRAY_VFE_UNIX_CONSOLE_TEXT_H

namespace vfePlatform
{

/// Options that upstream does not have, for `--help`: a section in the form of the others, with the blank line before it.
const char* OwnOptionsHelp();

} // namespace vfePlatform

#endif
