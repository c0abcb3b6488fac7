// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file error_spread.h
/// Counts errors by powers of ten, and keeps the worst.

#ifndef TILT_LENS_TESTS_ERROR_SPREAD_H
#define TILT_LENS_TESTS_ERROR_SPREAD_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include <nlohmann/json.hpp>

namespace tilt_lens
{

struct Spread
{
    std::map<int, std::uint64_t> byPower;  ///< floor(log10), -30 for 0, 30 for infinity and NaN
    std::uint64_t count = 0;
    double worst = 0.0, sum = 0.0;

    void Add(double value)
    {
        const double inside = value == value ? value : HUGE_VAL;
        byPower[int(std::floor(std::log10(std::min(std::max(inside, 1e-30), 1e30))))]++;
        worst = std::max(worst, inside);
        sum += inside;
        count++;
    }
    nlohmann::json Report() const
    {
        nlohmann::json powers = nlohmann::json::object();
        for (const auto& [power, n] : byPower)
            powers[std::to_string(power)] = n;
        return {{"count", count}, {"worst", worst}, {"sum", sum}, {"by_power", powers}};
    }
};

} // namespace tilt_lens

#endif
