// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file undetected_error.h
/// The error of what a pixel's samples may all have missed: docs/sampling.md, section 4. A few equal samples beside an edge
/// are no certainty, and a small light far out of focus shows in few samples, but in some of every pixel that it covers.

#ifndef TILT_LENS_UNDETECTED_ERROR_H
#define TILT_LENS_UNDETECTED_ERROR_H

#include "tilt_lens/sampling/pixel_statistics.h"

namespace tilt_lens
{

/// Expected square error for something that leaves the mean of what a pixel sees by 1 and fills some share of it, after n
/// independent samples that all missed it. A share q costs q^2 with probability exp(-q n). Pixels side by side see
/// different shares of a thing: any up to `share`, each as likely.
double MissedSquareError(double share, double n);

/// Expected square error of a pixel's mean for what others hit and its own samples show less of.
/// @param own     samples of the pixel
/// @param around  samples of the pixels around
Radiance UndetectedError(const PixelStatistics& own, const SampleVariation& around);

/// Whether emitter samples have looked for the pixel's emitters for as long as these may exceed the target, or so often
/// that what hides them is believed.
bool HasSearchedEmitters(const PixelStatistics& own, double target);

} // namespace tilt_lens

#endif
