// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// The list of files that a render depends on, for programs that must know when a picture is out of date.
///
/// Where the environment variable `TILT_LENS_FILE_LIST` names a file, every file that the program opens for
/// reading is appended to it, and every one that it looked for and did not find: had that one been there, the
/// picture could be another. So is every picture and every file of layers that was written whole. Each entry is
/// `+` (read), `-` (missing) or `=` (written), the name as it was used (relative to the current folder), and a
/// zero byte, so that any name is possible. Each name is listed once a run.
///
/// The names of the files that the present scene has read are kept as well: they belong to the key of a state file.

#ifndef POVRAY_TILT_LENS_FILE_LIST_H
#define POVRAY_TILT_LENS_FILE_LIST_H

#include <string>
#include <vector>

namespace tilt_lens
{

/// Lists `name`. A list that cannot be written ends the render with an error: a list with gaps is worse than none.
void ListFile(const std::string &name, bool found);

/// Lists a picture that was written; fails in the same way.
void ListPicture(const std::string &name);

/// The parsing of a scene begins: nothing was read for it yet.
void StartSceneFiles();

/// What was read since then, each name once, in the order of reading.
std::vector<std::string> SceneFiles();

}

#endif // POVRAY_TILT_LENS_FILE_LIST_H
