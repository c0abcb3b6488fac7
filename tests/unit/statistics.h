// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#ifndef TILT_LENS_TESTS_STATISTICS_H
#define TILT_LENS_TESTS_STATISTICS_H

#include <cstddef>
#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

namespace tilt_lens
{

inline double Square(double x)
{
    return x * x;
}

/// Pearson's test: the probability that such samples fit no better.
inline double ChiSquareP(const std::vector<double>& count, const std::vector<double>& probability)
{
    double total = 0, chi = 0;
    int used = 0;
    for (double c : count)
        total += c;
    for (std::size_t i = 0; i < count.size(); ++i)
    {
        const double expected = probability[i] * total;
        if (expected == 0)
        {
            if (count[i] != 0)
                return 0;
            continue;
        }
        chi += Square(count[i] - expected) / expected;
        ++used;
    }
    if (used == 1)
        return 1;
    const boost::math::chi_squared law(used - 1);
    return boost::math::cdf(boost::math::complement(law, chi));
}

inline double ChiSquareP(const std::vector<double>& count)
{
    return ChiSquareP(count, std::vector<double>(count.size(), 1.0 / static_cast<double>(count.size())));
}

} // namespace tilt_lens

#endif
