// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// The list of files that a render depends on, for programs that detect outdated pictures.
///
/// If the environment variable `TILT_LENS_FILE_LIST` names a file, every file that the program opens for reading is appended to it, every
/// file that it looked for in vain (its presence could change the picture), and every picture or layers' file that was completely written.
/// An entry is `+` (read), `-` (missing) or `=` (written), the name as used (relative to the current folder), and a zero byte, which allows
/// any name. Each name is listed once per run.
///
/// The files read by the current scene are also kept for the key of its state file.

#ifndef POVRAY_TILT_LENS_FILE_LIST_H
#define POVRAY_TILT_LENS_FILE_LIST_H

#include <string>
#include <vector>

namespace tilt_lens
{

/// Lists `name`. Failure to write the list ends the render with an error, because an incomplete list is worse than none.
void ListFile(const std::string& name, bool found);

/// Lists a written picture; fails in the same way.
void ListPicture(const std::string& name);

/// Call when parsing of a scene begins.
void StartSceneFiles();

/// Files read since StartSceneFiles(), each once, in the order of reading.
std::vector<std::string> SceneFiles();

}  // namespace tilt_lens

#endif  // POVRAY_TILT_LENS_FILE_LIST_H
