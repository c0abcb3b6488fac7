// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_VFE_UNIX_CONSOLE_TEXT_H
#define POVRAY_VFE_UNIX_CONSOLE_TEXT_H

namespace vfePlatform
{

const char* OwnOptionsHelp();

} // namespace vfePlatform

#endif
