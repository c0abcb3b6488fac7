// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/kernels/variant.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

const Kernels kKernels = {FindPoints, FindFilmPoints, AddRadiances, MapToDisc,    FindPositions, MakeRays,      TraceGlass,
                          FindPupils, AimAtPupils,    LeaveGlass,   SpreadSample, FilterBlock,   EstimateSpread};

} // namespace tilt_lens::TILT_LENS_VARIANT
