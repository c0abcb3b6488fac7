// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_WINDOW_H
#define TILT_LENS_WINDOW_H

#include <algorithm>
#include <vector>

#include "tilt_lens/math/radiance.h"

namespace tilt_lens
{

/// Means over pixels at most `kRadius` columns and rows away, within the rectangle.
/// @tparam Value  starts as zero; needs AddTo() and DivideBy()
/// @param values  row by row
template<int kRadius, class Value>
std::vector<Value> WindowMeans(const std::vector<Value>& values, int width)
{
    const int height = int(values.size()) / width;
    const auto means = [](const std::vector<Value>& from, int along, int step, int across, int stepAcross)
    {
        std::vector<Value> to(from.size(), Value());
        for (int y = 0; y < across; y++)
            for (int x = 0; x < along; x++)
            {
                const int first = std::max(0, x - kRadius), last = std::min(along - 1, x + kRadius);
                Value& mean = to[y * stepAcross + x * step];
                for (int u = first; u <= last; u++)
                    AddTo(mean, from[y * stepAcross + u * step]);
                DivideBy(mean, last - first + 1);
            }
        return to;
    };
    return means(means(values, width, 1, height, width), height, width, width, 1);
}

} // namespace tilt_lens

#endif
