// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BACKEND_PERMITTED_FILES_H
#define POVRAY_BACKEND_PERMITTED_FILES_H

#include "base/povmscpp.h"

namespace pov
{

class Parser;

/// Ends parsing with an error where the scene may not read or write this file (base/file_permissions.h).
void RequirePermission(Parser &parser, const UCS2String &name, bool writing);

}

#endif // POVRAY_BACKEND_PERMITTED_FILES_H
