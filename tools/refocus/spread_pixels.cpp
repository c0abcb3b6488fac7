// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "spread_pixels.h"

#include <algorithm>
#include <cmath>

namespace refocus
{

Picture Spread(const Picture& picture, const std::vector<float>& diameters, const std::vector<float>& depth)
{
    const int width = picture.width, height = picture.height, channels = picture.channels;
    std::vector<double> sums(picture.values.size(), 0.0), weights(diameters.size(), 0.0);
    for (int row = 0; row < height; row++)
        for (int column = 0; column < width; column++)
        {
            const std::size_t from = std::size_t(row) * width + column;
            const double radius = std::max(0.5, 0.5 * diameters[from]), share = 1.0 / (M_PI * radius * radius);
            const int reach = int(radius + 0.5);
            for (int y = std::max(0, row - reach); y <= std::min(height - 1, row + reach); y++)
                for (int x = std::max(0, column - reach); x <= std::min(width - 1, column + reach); x++)
                {
                    const std::size_t to = std::size_t(y) * width + x;
                    const double own = std::max(0.5, 0.5 * diameters[to]);
                    const double edge = depth[from] > depth[to] ? std::min(radius, own) : radius;
                    // the disc's last pixel is partly covered
                    const double covered = std::clamp(edge + 0.5 - std::hypot(x - column, y - row), 0.0, 1.0);
                    if (covered == 0.0)
                        continue;
                    weights[to] += share * covered;
                    for (int c = 0; c < channels; c++)
                        sums[to * channels + c] += share * covered * picture.values[from * channels + c];
                }
        }
    Picture blurred = picture;
    for (std::size_t i = 0; i < sums.size(); i++)
        blurred.values[i] = float(sums[i] / weights[i / channels]);
    return blurred;
}

} // namespace refocus
