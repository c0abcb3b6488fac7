// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file
/// The files that a render depends on, for the environment variable `TILT_LENS_FILE_LIST` (docs/batch.md) and for state files.

#ifndef POVRAY_TILT_LENS_FILE_LIST_H
#define POVRAY_TILT_LENS_FILE_LIST_H

#include <string>
#include <vector>

namespace tilt_lens
{

/// Ends the render if the list cannot be written.
void ListFile(const std::string& name, bool found);

void ListPicture(const std::string& name);

/// Call when parsing begins.
void StartSceneFiles();

std::vector<std::string> SceneFiles();

} // namespace tilt_lens

#endif  // POVRAY_TILT_LENS_FILE_LIST_H
