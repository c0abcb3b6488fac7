// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <limits>

#include <gtest/gtest.h>

#include "error_spread.h"

namespace
{

using tilt_lens::Spread;

TEST(Spread, FilesByPowersOfTen)
{
    Spread spread;
    for (double value : {0.0, 5e-324, 2e-16, 0.5, 1.0, 99.0})
        spread.Add(value);
    const std::map<int, std::uint64_t> expected = {{-30, 2}, {-16, 1}, {-1, 1}, {0, 1}, {1, 1}};
    EXPECT_EQ(spread.byPower, expected);
    EXPECT_EQ(spread.worst, 99.0);
    EXPECT_EQ(spread.count, 6u);
}

TEST(Spread, InfinityAndNaNAreTheWorst)
{
    for (double value :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::max()})
    {
        Spread spread;
        spread.Add(value);
        spread.Add(1e-3);
        EXPECT_EQ(spread.byPower[30], 1u) << value;
        EXPECT_EQ(spread.byPower[-30], 0u) << value;
        EXPECT_GE(spread.worst, std::numeric_limits<double>::max()) << value;
    }
}

} // namespace
