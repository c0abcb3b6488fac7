// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file undetected_error.h
/// Error from features that all samples of a pixel may have missed: docs/sampling.md, section 4. A few equal samples beside an edge prove
/// nothing, and a small blurred light appears in few samples, but in some of every pixel that it covers.

#ifndef TILT_LENS_UNDETECTED_ERROR_H
#define TILT_LENS_UNDETECTED_ERROR_H

#include "tilt_lens/sampling/pixel_statistics.h"

namespace tilt_lens
{

/// Expected square error after n independent samples have all missed a feature that deviates from the mean by 1 and covers a fraction of
/// the pixel. A fraction q costs q^2 with probability exp(-q n). Adjacent pixels see different fractions of a feature, so q is uniform in
/// [0, share].
double MissedSquareError(double share, double n);

/// Expected square error of a pixel's mean from features that other pixels hit and its own samples show less of.
/// @param own     samples of the pixel
/// @param around  samples of its 3 by 3 window
Radiance UndetectedError(const PixelStatistics& own, const SampleVariation& around);

/// True if the pixel needs no further search for its emitters: it has none, the error expected after its misses is below the target, or
/// there are so many misses that the emitters are taken for hidden.
bool HasSearchedEmitters(const PixelStatistics& own, double target);

} // namespace tilt_lens

#endif
