// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

// The undetected error, in closed form and against integration.

#include "tilt_lens/sampling/undetected_error.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tilt_lens/settings.h"

namespace tilt_lens
{
namespace
{

PixelStatistics Equal(std::uint32_t samples, double value, double expectedEmission = 0.0)
{
    PixelStatistics pixel;
    pixel.BeginRound(samples);
    for (std::uint32_t i = 0; i < samples; i++)
    {
        SampleResult result;
        result = Radiance{value, value, value, 0.0, 0.0};
        result.expectedEmission = expectedEmission;
        pixel.Add(result);
    }
    pixel.EndRound();
    return pixel;
}

TEST(MissedSquareError, IsTheMeanOverAllShares)
{
    for (const double share : {1e-4, 0.01, 0.2, 1.0})
        for (const double n : {1.0, 8.0, 100.0, 10000.0})
        {
            double sum = 0.0;
            constexpr int steps = 100000;
            for (int i = 0; i < steps; i++)
            {
                const double q = share * (i + 0.5) / steps;
                sum += q * q * std::exp(-q * n) / steps;
            }
            EXPECT_NEAR(MissedSquareError(share, n), sum, 0.01 * sum) << share << ", " << n;
        }
}

TEST(UndetectedError, GrowsWithVarianceThatOnlyOthersShow)
{
    SampleVariation around;
    around.variance[1] = 0.25, around.maxSquaredDeviation[1] = 1.0;
    const Radiance error = UndetectedError(Equal(8, 0.5), around);
    EXPECT_NEAR(error[1], MissedSquareError(0.25, 8), 1e-15);
    EXPECT_EQ(error[0], 0.0);
    EXPECT_LT(UndetectedError(Equal(64, 0.5), around)[1], error[1] / 8.0) << "more samples would have hit it";

    PixelStatistics noisy;
    noisy.BeginRound(8);
    for (int i = 0; i < 8; i++)
    {
        SampleResult result;
        result = Radiance{0.0, i % 2 ? 1.0 : 0.0, 0.0, 0.0, 0.0};
        noisy.Add(result);
    }
    noisy.EndRound();
    EXPECT_EQ(UndetectedError(noisy, around)[1], 0.0) << "the pixel has hit as much itself";
}

TEST(HasSearchedEmitters, IsTrueOnceTheirErrorIsBelowTheTarget)
{
    EXPECT_TRUE(HasSearchedEmitters(Equal(4, 0.5), 1e-9)) << "no emitter samples";
    EXPECT_FALSE(HasSearchedEmitters(Equal(4, 0.5, 1.0), 1e-3));
    EXPECT_TRUE(HasSearchedEmitters(Equal(4, 0.5, 0.01), 1e-3)) << "too dim to matter";
    EXPECT_TRUE(HasSearchedEmitters(Equal(settings.hiddenEmitterSamples, 0.5, 100.0), 1e-9)) << "believed hidden";
}

} // namespace
} // namespace tilt_lens
