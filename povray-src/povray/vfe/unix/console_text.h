// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file console_text.h
/// Additions to upstream's console output.

#ifndef POVRAY_VFE_UNIX_CONSOLE_TEXT_H
#define POVRAY_VFE_UNIX_CONSOLE_TEXT_H

#include <string>

namespace vfePlatform
{

/// Section of `--help` for options that upstream does not have, with the blank line before it.
const char* OwnOptionsHelp();

/// True if a text was printed before: upstream sends an error both as a message and as the status, in either order.
/// @param isStatus  the text is for the status line; call for each printed text
bool IsSaidAgain(bool isStatus, const std::string& text);

/// True if a key can be pressed: at a terminal, or in a window.
bool IsSomebodyThere();

/// Ends the program if it has not stopped reading a scene within three seconds.
/// @param hundredths  hundredths of a second since it was told to stop
void EndIfStuck(int hundredths);

} // namespace vfePlatform

#endif
