// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file filter_input.h
/// Planes that the reconstruction's kernels read and write.

#ifndef TILT_LENS_FILTER_INPUT_H
#define TILT_LENS_FILTER_INPUT_H

#include "tilt_lens/settings.h"

namespace tilt_lens
{

struct SpreadInput
{
    const float *mean[3], *variance, *share, *samples, *ownShare, *ownWeight;
};

struct FilterInput
{
    const float *mean[5], *noise, *missed, *samples;
    int channels;               ///< 3, or 5 if a pixel is transparent
    int firstRow, endRow;
    const SpreadInput* spread;  ///< null: none
    const Settings& settings;
};

struct FilterOutput
{
    float *mean[5], *residualVarianceBound, *residualVarianceRatio, *risk;
};

} // namespace tilt_lens

#endif
