// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_SCENE_FILES_H
#define POVRAY_BACKEND_SCENE_FILES_H

#include "base/povmscpp.h"
#include "base/textstream.h"

namespace pov
{

class Parser;

/// Ends parsing with an error where the scene may not read or write this file (base/file_permissions.h).
void RequirePermission(Parser &parser, const UCS2String &name, bool writing);

/// Writes what a file of the scene still holds back, before it is closed. Where that fails, as on a full disk, the file is closed, and parsing
/// ends with an error, or, for a file that the scene has left open, there is a message.
void FinishFile(Parser &parser, pov_base::OTextStream *&file, bool closedByScene);

}

#endif // POVRAY_BACKEND_SCENE_FILES_H
