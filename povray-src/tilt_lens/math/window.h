// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_WINDOW_H
#define TILT_LENS_WINDOW_H

#include <algorithm>
#include <vector>

#include "tilt_lens/math/radiance.h"
#include "tilt_lens/math/rows.h"

namespace tilt_lens
{

/// Means over pixels at most `kRadius` columns and rows away, within the rectangle.
/// @tparam Value  starts as zero; needs AddTo() and ScaleBy()
/// @param values  row by row
/// @param rows    rows with means; all others are zero
template<int kRadius, class Value>
std::vector<Value> WindowMeans(const std::vector<Value>& values, int width, const Rows& rows)
{
    const auto meanOf = [](const Value* middle, int step, int place, int length)
    {
        const int first = std::max(-kRadius, -place), last = std::min(kRadius, length - 1 - place);
        Value mean = Value();
        for (int i = first; i <= last; i++)
            AddTo(mean, middle[i * step]);
        ScaleBy(mean, 1.0 / (last - first + 1));
        return mean;
    };
    const int height = int(values.size()) / width;
    const Rows wanted = rows.Grown(0, height), read = wanted.Grown(kRadius, height);
    std::vector<Value> ofRows(values.size()), means(values.size());
    for (int y = read.begin; y < read.end; y++)
        for (int x = 0; x < width; x++)
            ofRows[y * width + x] = meanOf(&values[y * width + x], 1, x, width);
    for (int y = wanted.begin; y < wanted.end; y++)
        for (int x = 0; x < width; x++)
            means[y * width + x] = meanOf(&ofRows[y * width + x], width, y, height);
    return means;
}

/// In all rows.
template<int kRadius, class Value>
std::vector<Value> WindowMeans(const std::vector<Value>& values, int width)
{
    return WindowMeans<kRadius>(values, width, Rows{0, int(values.size()) / width});
}

} // namespace tilt_lens

#endif
