// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lamp_light.h
/// The share of lamps' light that a picture keeps.

#ifndef LAMP_LIGHT_H
#define LAMP_LIGHT_H

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "picture.h"

class LampLight
{
  public:
    struct Kept
    {
        double share;       ///< of all lamps' light
        double dark;        ///< of disc pixels: less than 70 % of their light
        int discPixels;
    };

    LampLight(const witness::Picture& with, witness::Picture without) :
        m_without(std::move(without)), m_light(Light(with)), m_brightest(Brightest(m_light, with.width, with.height))
    {
    }

    Kept Of(const witness::Picture& picture) const
    {
        const std::vector<double> light = Light(picture);
        double kept = 0.0, all = 0.0;
        int dark = 0, disc = 0;
        for (std::size_t pixel = 0; pixel < light.size(); ++pixel)
        {
            kept += light[pixel], all += m_light[pixel];
            if (!IsInDisc(pixel))
                continue;
            ++disc;
            dark += light[pixel] < leastShare * m_light[pixel];
        }
        if (all <= 0.0)
            throw std::runtime_error("the scene with lamps is no brighter than without");
        return {kept / all, disc == 0 ? 0.0 : double(dark) / disc, disc};
    }

  private:
    /// `leastLight`: several times the default settings' error.
    static constexpr double leastLight = 0.06, leastShare = 0.7;
    static constexpr int reach = 8;

    bool IsInDisc(std::size_t pixel) const { return m_light[pixel] >= std::max(leastLight, 0.5 * m_brightest[pixel]); }

    std::vector<double> Light(const witness::Picture& picture) const
    {
        if (!picture.SameSize(m_without))
            throw std::runtime_error("pictures with and without lamps differ in size");
        std::vector<double> light;
        for (std::size_t i = 0; i < picture.Size(); i += 3)
        {
            light.push_back(0.0);
            for (std::size_t k = i; k < i + 3; ++k)
                light.back() += picture.values[k] - m_without.values[k];
        }
        return light;
    }

    static std::vector<double> Brightest(const std::vector<double>& light, int width, int height)
    {
        std::vector<double> across(light), around;
        for (int i = 0; i < int(light.size()); ++i)
            for (int x = std::max(0, i % width - reach); x <= std::min(width - 1, i % width + reach); ++x)
                across[i] = std::max(across[i], light[i - i % width + x]);
        around = across;
        for (int i = 0; i < int(light.size()); ++i)
            for (int y = std::max(0, i / width - reach); y <= std::min(height - 1, i / width + reach); ++y)
                around[i] = std::max(around[i], across[y * width + i % width]);
        return around;
    }

    const witness::Picture m_without;
    const std::vector<double> m_light, m_brightest;
};

#endif
