// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "brightness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace paper
{

double Luminance(const witness::Picture& picture, int column, int row)
{
    const double* p = &picture.values[3 * (static_cast<std::size_t>(row) * picture.width + column)];
    return 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
}

double Level(double linear)
{
    const double c = std::clamp(linear, 0.0, 1.0);
    return 255.0 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055);
}

namespace
{

/// Mixes levels, not linear light, as in an 8-bit file.
double LevelAt(const witness::Picture& picture, Point at)
{
    const double x = at.x - 0.5, y = at.y - 0.5;
    const int column = std::clamp(static_cast<int>(std::floor(x)), 0, picture.width - 2);
    const int row = std::clamp(static_cast<int>(std::floor(y)), 0, picture.height - 2);
    const double u = std::clamp(x - column, 0.0, 1.0), v = std::clamp(y - row, 0.0, 1.0);
    const auto level = [&](int i, int j) { return Level(Luminance(picture, column + i, row + j)); };
    return (1.0 - v) * ((1.0 - u) * level(0, 0) + u * level(1, 0)) + v * ((1.0 - u) * level(0, 1) + u * level(1, 1));
}

bool Inside(const witness::Picture& picture, Point at)
{
    return at.x >= 0.0 && at.y >= 0.0 && at.x <= picture.width && at.y <= picture.height;
}

} // namespace

std::vector<double> Profile(const witness::Picture& picture, Point from, Point to, int count)
{
    if (count < 2 || picture.width < 2 || picture.height < 2)
        throw std::invalid_argument("a profile takes two points or more of two pixels or more");
    if (!Inside(picture, from) || !Inside(picture, to))
        throw std::invalid_argument("the line leaves the picture");
    std::vector<double> levels;
    for (int i = 0; i < count; ++i)
    {
        const double t = static_cast<double>(i) / (count - 1);
        levels.push_back(LevelAt(picture, {from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)}));
    }
    return levels;
}

double AverageDifference(const std::vector<double>& a, const std::vector<double>& b)
{
    if (a.size() != b.size() || a.empty())
        throw std::invalid_argument("profiles of different lengths");
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::fabs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

Moments MomentsIn(const witness::Picture& picture, int left, int top, int width, int height)
{
    if (left < 0 || top < 0 || width < 1 || height < 1 || left + width > picture.width || top + height > picture.height)
        throw std::invalid_argument("the window leaves the picture");
    Moments m;
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
    for (int row = top; row < top + height; ++row)
        for (int column = left; column < left + width; ++column)
        {
            const double light = Luminance(picture, column, row);
            const double dx = column + 0.5 - left, dy = row + 0.5 - top;
            m.sum += light;
            x += light * dx;
            y += light * dy;
            xx += light * dx * dx;
            xy += light * dx * dy;
            yy += light * dy * dy;
        }
    if (!(m.sum > 0.0))
        throw std::invalid_argument("the window holds no light");
    x /= m.sum;
    y /= m.sum;
    m.centroid = {left + x, top + y};
    m.xx = xx / m.sum - x * x;
    m.xy = xy / m.sum - x * y;
    m.yy = yy / m.sum - y * y;
    return m;
}

Edges EdgesIn(const witness::Picture& picture, int row, int inside)
{
    if (row < 0 || row >= picture.height || inside < 1 || inside >= picture.width - 1)
        throw std::invalid_argument("the row or the column leaves the picture");
    const double full = Luminance(picture, inside, row);
    if (!(full > 0.0))
        throw std::invalid_argument("the column holds no light");
    double before = 0.0, after = 0.0;
    for (int column = 0; column < picture.width; ++column)
        (column < inside ? before : after) += Luminance(picture, column, row) / full;
    return {inside - before, inside + after};
}

} // namespace paper
