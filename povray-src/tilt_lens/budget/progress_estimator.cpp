// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/progress_estimator.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

double ExpectedSamples(const SamplingLimits& limits, const std::vector<Radiance>& tried)
{
    const double n = tried.size();
    double wanted = limits.variance > 0.0 ? limits.min : limits.max;
    for (std::size_t c = 0; limits.variance > 0.0 && n > 1.0 && c < Radiance().size(); c++)
    {
        double sum = 0.0, squares = 0.0;
        for (const Radiance& value : tried)
        {
            const double light = std::isfinite(value[c]) ? value[c] : 0.0;
            sum += light;
            squares += light * light;
        }
        const double mean = sum / n, spread = std::max(0.0, squares - sum * mean) / (n - 1.0);
        wanted = std::max(wanted, spread / (limits.variance * std::max(1.0, mean * mean)));
    }
    return std::min<double>(wanted, limits.max);
}

void ProgressEstimator::Plan(const Area& rendered, bool probing)
{
    const std::lock_guard<std::mutex> lock(mutex);
    area = rendered;
    columns = (area.width + Settings::blockSide - 1) / Settings::blockSide;
    const std::size_t blocks = std::size_t(columns) * ((area.height + Settings::blockSide - 1) / Settings::blockSide);
    weights.assign(blocks, 1.0);
    pixels.assign(blocks, 0);
    finished.assign(blocks, 0);
    for (std::uint32_t y = 0; y < area.height; y += Settings::blockSide)
        for (std::uint32_t x = 0; x < area.width; x += Settings::blockSide)
            pixels[y / Settings::blockSide * columns + x / Settings::blockSide] = std::min(Settings::blockSide, area.width - x) *
                                                                                  std::min(Settings::blockSide, area.height - y);
    given = tried = probing ? 0 : blocks;
    all = double(area.width) * area.height;
    done = 0.0;
}

std::optional<ProgressEstimator::Probe> ProgressEstimator::NextProbe()
{
    const std::lock_guard<std::mutex> lock(mutex);
    if (given == weights.size())
        return {};
    const std::size_t block = given++;
    const auto middle = [](std::uint32_t from, std::uint32_t end) { return from + std::min(Settings::blockSide, end - from) / 2; };
    const std::uint32_t x = block % columns * Settings::blockSide, y = block / columns * Settings::blockSide;
    return Probe{block, area.left + middle(x, area.width), area.top + middle(y, area.height)};
}

void ProgressEstimator::SetWeight(std::size_t block, double weight)
{
    const std::lock_guard<std::mutex> lock(mutex);
    done += (weight - weights[block]) * finished[block];
    all += (weight - weights[block]) * pixels[block];
    weights[block] = weight;
    tried++;
}

void ProgressEstimator::Finish(const Area& tile)
{
    const std::lock_guard<std::mutex> lock(mutex);
    for (std::uint32_t y = tile.top; y < tile.Bottom(); y++)
        for (std::uint32_t x = tile.left; x < tile.Right(); x++)
            if (area.Has(x, y))
            {
                const std::size_t block = (y - area.top) / Settings::blockSide * columns + (x - area.left) / Settings::blockSide;
                finished[block]++;
                done += weights[block];
            }
}

std::optional<double> ProgressEstimator::Share() const
{
    const std::lock_guard<std::mutex> lock(mutex);
    if (weights.empty() || tried < weights.size())
        return {};
    return all > 0.0 ? std::min(1.0, done / all) : 1.0;
}

} // namespace tilt_lens
