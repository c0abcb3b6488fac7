// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef POVRAY_BASE_OPTION_VALUES_H
#define POVRAY_BASE_OPTION_VALUES_H

#include "base/povms.h"

namespace tilt_lens
{

/// Whether all of the text is a value of this option: a number, on or off, NAME=VALUE. Other types of option take any text.
bool IsValueOf(POVMSType key, POVMSType type, const char *text);

}

#endif // POVRAY_BASE_OPTION_VALUES_H
