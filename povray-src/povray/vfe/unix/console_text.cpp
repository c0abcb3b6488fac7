// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "vfe/unix/console_text.h"

namespace vfePlatform
{

const char* OwnOptionsHelp()
{
    return "\nOptions of povray-tilt-lens, beside those of POV-Ray's manual:\n\n"
           "    +N, Output_Layers=on           write depth, blur, position, samples and noise of each pixel\n"
           "                                   beside the picture, as NAME.layers.exr\n"
           "    +FE32, Bits_Per_Color=32       write the picture as OpenEXR with 32-bit colours\n\n"
           "The camera's block tilt_lens { ... } is described in povray-tilt-lens(7) and in docs/manual.md.\n";
}

} // namespace vfePlatform
