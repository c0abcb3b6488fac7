// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file filters.h
/// Linear filters along rows or columns, and the bank of their products: docs/sampling.md, section 8.
///
/// Source: A. Savitzky, M. J. E. Golay, "Smoothing and differentiation of data by simplified least squares procedures",
/// Anal. Chem. 36(8), 1964, for the parabolas.

#ifndef TILT_LENS_FILTERS_H
#define TILT_LENS_FILTERS_H

#include "tilt_lens/math/simd.h"
#include "tilt_lens/reconstruction/block_statistics.h"

namespace tilt_lens
{

/// One-dimensional filters: none, a parabola fitted to 5 or 9 pixels, the mean of 9, or the mean of the pixel and 4 on one side, for an
/// edge on the other side.
enum Filter { kNone, kFit5, kFit9, kMean9, kAhead5, kBehind5, kFilters };

/// Taps from the centre to one end, symmetric except for the one-sided filters.
constexpr float kTaps[kFilters][settings.filterRadius + 1] = {
    {1.0f},
    {17.0f / 35, 12.0f / 35, -3.0f / 35},
    {59.0f / 231, 54.0f / 231, 39.0f / 231, 14.0f / 231, -21.0f / 231},
    {1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9},
    {0.2f, 0.2f, 0.2f, 0.2f, 0.2f},
    {0.2f, 0.2f, 0.2f, 0.2f, 0.2f},
};

/// The bank: filter along rows, filter along columns.
constexpr Filter kBank[][2] = {
    {kNone, kNone}, {kFit5, kNone}, {kNone, kFit5}, {kFit5, kFit5},
    {kFit9, kNone}, {kNone, kFit9}, {kFit9, kFit9}, {kFit5, kFit9}, {kFit9, kFit5},
    {kMean9, kNone}, {kNone, kMean9}, {kMean9, kMean9}, {kMean9, kFit5}, {kFit5, kMean9},
    {kAhead5, kNone}, {kBehind5, kNone}, {kNone, kAhead5}, {kNone, kBehind5},
};

/// Filters neighbouring pixels with steps of 1 (a row) or PaddedBlock::kColumns (a column). Plain loops over such short rows compile to
/// code that takes three times as long.
template<class Vector, Filter kFilter>
TILT_LENS_INLINED Vector Filtered(const float* at, int step)
{
    constexpr int reach = kFilter == kNone ? 0 : kFilter == kFit5 ? 2 : settings.filterRadius;
    Vector sum = kTaps[kFilter][0] * Load<Vector>(at);
    for (int i = 1; i <= reach; i++)
    {
        if (kFilter == kAhead5 || kFilter == kBehind5)
            sum += kTaps[kFilter][i] * Load<Vector>(at + (kFilter == kAhead5 ? i : -i) * step);
        else
            sum += kTaps[kFilter][i] * (Load<Vector>(at - i * step) + Load<Vector>(at + i * step));
    }
    return sum;
}

} // namespace tilt_lens

#endif
