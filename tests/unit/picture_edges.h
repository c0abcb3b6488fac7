// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_TESTS_PICTURE_EDGES_H
#define TILT_LENS_TESTS_PICTURE_EDGES_H

#include "tilt_lens/reconstruction/block_statistics.h"

namespace tilt_lens
{

/// For the middle block of a picture of three by three.
constexpr PictureEdges kFarEdges{-int(Settings::blockSide), -int(Settings::blockSide), 2 * int(Settings::blockSide),
                                 2 * int(Settings::blockSide)};

}  // namespace tilt_lens

#endif
