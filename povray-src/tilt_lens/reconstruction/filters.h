// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file filters.h
/// Linear filters and the bank of their products: docs/sampling.md, section 5.
///
/// Source of the parabolas: A. Savitzky, M. J. E. Golay, "Smoothing and differentiation of data by simplified least squares procedures",
/// Anal. Chem. 36(8), 1964.

#ifndef TILT_LENS_FILTERS_H
#define TILT_LENS_FILTERS_H

#include <iterator>

#include "tilt_lens/math/simd.h"
#include "tilt_lens/reconstruction/block_statistics.h"

namespace tilt_lens
{

/// None, a parabola fitted to 5 or 9 pixels, or the mean of 9.
enum Filter
{
    kNone,
    kFit5,
    kFit9,
    kMean9,
    kFilters
};

/// From the centre to one end.
constexpr float kTaps[kFilters][Settings::filterRadius + 1] = {
    {1.0f},
    {17.0f / 35, 12.0f / 35, -3.0f / 35},
    {59.0f / 231, 54.0f / 231, 39.0f / 231, 14.0f / 231, -21.0f / 231},
    {1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9},
};

struct FilterPair
{
    Filter across, down;
    int slant = 0;  ///< column step per row of `down`: 0, or 1 or -1 along a diagonal
};

/// Diagonals have the filters of rows and columns, and products have equal factors, so that remaining noise has no preferred direction.
// clang-format off
constexpr FilterPair kBank[] = {
    {kNone, kNone},
    {kFit5, kNone}, {kNone, kFit5}, {kNone, kFit5, 1}, {kNone, kFit5, -1},
    {kFit9, kNone}, {kNone, kFit9}, {kNone, kFit9, 1}, {kNone, kFit9, -1},
    {kMean9, kNone}, {kNone, kMean9}, {kNone, kMean9, 1}, {kNone, kMean9, -1},
    {kFit5, kFit5}, {kFit9, kFit9}, {kMean9, kMean9},
};
// clang-format on

constexpr float TapOf(Filter filter, int distance)
{
    const int away = distance < 0 ? -distance : distance;
    return away > Settings::filterRadius ? 0.0f : kTaps[filter][away];
}

/// Tap of the pixel (x, y) away from the centre.
constexpr float TapOf(const FilterPair& pair, int x, int y)
{
    return TapOf(pair.down, y) * TapOf(pair.across, x - pair.slant * y);
}

constexpr int kFiltersOfBank = int(std::size(kBank));

/// White noise of variance 1, filtered by two filters of kBank, has these covariances.
struct Covariances
{
    float of[kFiltersOfBank][kFiltersOfBank]{};

    constexpr Covariances()
    {
        constexpr int radius = Settings::filterRadius;  // a slanted filter is a line: it reaches no farther
        for (int i = 0; i < kFiltersOfBank; i++)
            for (int j = 0; j < kFiltersOfBank; j++)
                for (int y = -radius; y <= radius; y++)
                    for (int x = -radius; x <= radius; x++)
                        of[i][j] += TapOf(kBank[i], x, y) * TapOf(kBank[j], x, y);
    }
};
constexpr Covariances kCovariances;

/// @param step  1 (a row), PaddedBlock::kColumns (a column), or one more or less (a diagonal)
template<class Vector, Filter kFilter>
TILT_LENS_INLINED Vector Filtered(const float* at, int step)
{
    constexpr int reach = kFilter == kNone ? 0 : kFilter == kFit5 ? 2 : Settings::filterRadius;
    Vector sum = kTaps[kFilter][0] * Load<Vector>(at);
    for (int i = 1; i <= reach; i++)
        sum += kTaps[kFilter][i] * (Load<Vector>(at - i * step) + Load<Vector>(at + i * step));
    return sum;
}

} // namespace tilt_lens

#endif
