// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file console_text.h
/// What the console prints, beside what upstream prints.

#ifndef POVRAY_VFE_UNIX_CONSOLE_TEXT_H
#define POVRAY_VFE_UNIX_CONSOLE_TEXT_H

#include <string>

namespace vfePlatform
{

/// Options that upstream does not have, for `--help`: a section in the form of the others, with the blank line before it.
const char* OwnOptionsHelp();

/// Whether a text was printed before: upstream sends an error twice, as a message and as the status, in either order.
/// @param isStatus  whether the text is for the status line; each text that is printed has to be told
bool IsSaidAgain(bool isStatus, const std::string& text);

/// Whether anybody can press a key: at a terminal, or in a window.
bool IsSomebodyThere();

/// Ends the program at once where it was asked to stop reading a scene and has not done so in some seconds.
/// @param hundredths  seconds, times 100, since it was asked
void EndIfStuck(int hundredths);

} // namespace vfePlatform

#endif
