// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/sampling_limits.h"

namespace tilt_lens
{

// In a file of its own, so that the linker takes another definition in its place.
Settings DefaultSettings()
{
    return {};
}

} // namespace tilt_lens
