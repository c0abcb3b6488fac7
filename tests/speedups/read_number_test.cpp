// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// Values equal sscanf's bit for bit.

#include "speedups/read_number.h"

#include <cstring>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace speedups
{
namespace
{

void ExpectSameAsSscanf(const std::string& text)
{
    double expected = -7.0, value = -7.0;
    const bool isNumber = std::sscanf(text.c_str(), "%lf", &expected) != 0;
    EXPECT_EQ(isNumber, ReadNumber(text.data(), text.data() + text.size(), &value)) << text;
    EXPECT_EQ(0, std::memcmp(&expected, &value, sizeof value)) << text << ": " << value << " instead of " << expected;
}

TEST(ReadNumber, EqualsSscanfForEveryForm)
{
    for (const char* text : {"0", "5", "5.", "0.5", "007", "1e5", "1E5", "1e+5", "1e-5", "1.e3", "2.5e0", "0e0",
                             "0.1000000000000000055511151231257827", "9007199254740993", "179769313486231580793728971405303415079934"})
        ExpectSameAsSscanf(text);
}

TEST(ReadNumber, EqualsSscanfForIncompleteExponentsAndOverflow)
{
    for (const char* text : {"1e", "1e+", "1.5E-", "1e999", "1e-999", "4.9e-324", "2e-324", "1.7976931348623159e308"})
        ExpectSameAsSscanf(text);
}

TEST(ReadNumber, EqualsSscanfForRandomNumbers)
{
    std::mt19937_64 random(5);
    for (int i = 0; i < 200000 && !testing::Test::HasFailure(); i++)
    {
        std::string text = std::to_string(random() % 100000) + "." + std::to_string(random() >> (random() % 60));
        if (random() % 2)
            text += "e" + std::to_string(int(random() % 640) - 320);
        ExpectSameAsSscanf(text);
    }
}

} // namespace
} // namespace speedups
