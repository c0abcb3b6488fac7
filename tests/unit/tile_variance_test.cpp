// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/convergence.h"
#include "tilt_lens/stop_rule/tile_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tile_results.h"

namespace tilt_lens
{
namespace
{

struct Picture
{
    const char* name;
    Tracer trace;
    double (*mean)(std::uint32_t x, std::uint32_t y);
    double leap = 4.0;  ///< factor of possible undershoot in the last round
};

double Half(std::uint32_t, std::uint32_t)
{
    return 0.5;
}

double BlurredEdgeMean(std::uint32_t x, std::uint32_t)
{
    return std::min(1.0, (x % 64 + 0.5) / 64.0);
}

void BlurredEdge(const SampleId& id, SampleResult& light)
{
    const SequencePoint s = SequencePointOf(id);
    light = Grey(s.lensU * 64.0 + (s.pixelX - 0.5) < id.x % 64 + 0.5 ? 1.0 : 0.0);
}

double LinearMean(std::uint32_t x, std::uint32_t)
{
    return 0.5 + 0.5 * ((x % 8) - 3.5) / 8.0;
}

void Linear(const SampleId& id, SampleResult& light)
{
    const SequencePoint s = SequencePointOf(id);
    light = Grey(0.5 + 0.5 * ((id.x % 8) - 3.5) / 8.0 + 0.4 * (s.lensU + s.lensV - 1.0) + 0.2 * (s.pixelX - 0.5));
}

void Checker(const SampleId& id, SampleResult& light)
{
    const SequencePoint s = SequencePointOf(id);
    light = Grey((int(s.lensU * 6) + int(s.lensV * 6)) % 2 ? 1.0 : 0.0);
}

void Lamp(const SampleId& id, SampleResult& light)
{
    const SequencePoint s = SequencePointOf(id);
    const double u = s.lensU - 0.9 * (PixelHash(id.x, id.y, 0, 5) * 0x1p-32);
    const double v = s.lensV - 0.9 * (PixelHash(id.x, id.y, 0, 6) * 0x1p-32);
    light = Grey(u >= 0 && u < 0.1 && v >= 0 && v < 0.1 ? 1.0 : 0.0);
    static const LensFootprint footprint(Lens(), Aperture::Disc(), 4096.0, 4096.0);
    light.circle = {id.x + 0.5f, id.y + 0.5f, 100.0f, 0.0f, 0.0f, 100.0f, &footprint};
}

double LampMean(std::uint32_t, std::uint32_t)
{
    return 0.01;
}

const Picture kPictures[] = {{"white noise", WhiteNoise, Half},
                             {"linear", Linear, LinearMean, 16.0},
                             {"blurred edge", BlurredEdge, BlurredEdgeMean},
                             {"checker", Checker, Half}};
const Picture kLamp = {"lamp", Lamp, LampMean};

struct Score
{
    double error = 0.0, claimed = 0.0, beyond = 0.0, errorAboveMin = 0.0;
    std::uint64_t pixels = 0, samples = 0, aboveMin = 0;

    double MeanError() const { return error / pixels; }
    double MeanErrorAboveMin() const { return errorAboveMin / std::max<std::uint64_t>(1, aboveMin); }
    double Beyond() const { return beyond / pixels; } ///< share of pixels off by more than 2 sqrt(V)
};

Score ScoreOf(const Picture& picture, const SamplingLimits& limits, std::uint32_t blocks)
{
    Score score;
    for (std::uint32_t block = 0; block < blocks; block++)
    {
        const std::uint32_t left = block % 8 * Settings::blockSide, top = block / 8 * Settings::blockSide;
        const std::vector<Result> results = ResultsOf(limits, left, top, picture.trace);
        for (std::uint32_t i = 0; i < results.size(); i++)
        {
            const Result& r = results[i];
            const double error = std::pow(r.mean[0] - picture.mean(left + i % Settings::blockSide, top + i / Settings::blockSide), 2);
            score.error += error;
            score.claimed += r.variance;
            score.beyond += error > 4.0 * limits.variance;
            score.samples += r.samples;
            score.pixels++;
            if (r.samples > limits.min)
            {
                score.errorAboveMin += error;
                score.aboveMin++;
            }
        }
    }
    return score;
}

class RequestedVariance : public testing::TestWithParam<double>
{
};

INSTANTIATE_TEST_SUITE_P(TileSampler, RequestedVariance, testing::Values(1e-3, 1e-4, 1e-5));

Score ReportedScoreOf(const Picture& picture, double V)
{
    const Score s = ScoreOf(picture, Limits(8, 65536, V), V < 5e-5 ? 8 : 32);
    std::printf("[          ] V %g %-12s MSE/V %.3f, claimed/V %.2f, beyond 2 sqrt(V) %.1f %%, "
                "above the minimum "
                "%.0f %% with MSE/V %.3f, samples %.1f\n",
                V, picture.name, s.MeanError() / V, s.claimed / s.pixels / V, 100 * s.Beyond(), 100.0 * s.aboveMin / s.pixels,
                s.MeanErrorAboveMin() / V, double(s.samples) / s.pixels);
    return s;
}

TEST_P(RequestedVariance, IsKept)
{
    const double V = GetParam();
    for (const Picture& picture : kPictures)
    {
        const Score s = ReportedScoreOf(picture, V);
        EXPECT_LE(s.MeanError(), 1.2 * V) << picture.name;
        EXPECT_LE(s.Beyond(), 0.05) << picture.name;
    }
}

TEST_P(RequestedVariance, IsNearlyUsedUpByIndependentNoise)
{
    EXPECT_GE(ReportedScoreOf(kPictures[0], GetParam()).MeanErrorAboveMin(), GetParam() / 4);
}

// Doubling divides smooth light's variance by eight.
TEST_P(RequestedVariance, IsNearlyUsedUpByStratifiedSamples)
{
    for (const Picture& picture : kPictures)
    {
        const Score s = ReportedScoreOf(picture, GetParam());
        if (s.aboveMin * 10 > s.pixels)
        {
            EXPECT_GE(s.MeanErrorAboveMin(), GetParam() / picture.leap) << picture.name;
        }
    }
}

TEST_P(RequestedVariance, IsKeptWhereOneSampleInAHundredMatters)
{
    const Score s = ReportedScoreOf(kLamp, GetParam());
    EXPECT_LE(s.MeanError(), 1.2 * GetParam());
    EXPECT_LE(s.Beyond(), 0.05);
}

void Columns(const SampleId& id, SampleResult& light)
{
    light = Grey(0.5 + (id.x % 4 == 0 ? 0.8 : 0.08) * (Noise(id, 1) - 0.5));
}

TEST_P(RequestedVariance, IsKeptByNoisyPixelsAmongQuietOnes)
{
    const Score s = ReportedScoreOf({"columns", Columns, Half}, GetParam());
    EXPECT_LE(s.MeanError(), 1.2 * GetParam());
    EXPECT_LE(s.Beyond(), 0.05);
}

TEST(TileSamplerStop, ReportsTheVarianceOfWhiteNoise)
{
    for (const std::uint32_t n : {16u, 64u, 100u})
    {
        const Score s = ScoreOf(kPictures[0], Limits(n, n, 1e-9), 50);
        const double truth = 1.0 / 12.0 / n;
        EXPECT_NEAR(s.error / s.pixels / truth, 1.0, 0.05) << n;
        EXPECT_GT(s.claimed / s.pixels / truth, 0.85) << n;
        EXPECT_LT(s.claimed / s.pixels / truth, 1.3) << n;
    }
}

TEST(TileSamplerStop, TheGreatestRadiancesSpoilNoFarPixels)
{
    for (const double bright : {1e18, 1e25, 3e38})
        for (const bool denoise : {false, true})
        {
            const auto spoiled = [bright](const SampleId& id, SampleResult& light)
            { light = Grey(id.x == 20 && id.y == 20 && id.index == 3 ? bright : Noise(id, 1)); };
            SamplingLimits limits = Limits(4, 64, 1e-2);
            limits.denoise = denoise;
            const Area all{0, 0, 48, 48};
            const std::vector<Result> results = ResultsOf(limits, all, 48, 48, spoiled);
            for (int i = 0; i < int(results.size()); i++)
            {
                const int distance = std::max(std::abs(i % 48 - 20), std::abs(i / 48 - 20));
                EXPECT_TRUE(std::isfinite(results[i].variance) && std::isfinite(results[i].mean[0])) << bright << ", pixel " << i;
                if (distance <= 1)
                {
                    EXPECT_EQ(results[i].samples, limits.max) << bright << ", pixel " << i;
                }
                if (distance > (denoise ? 12 : 0))
                {
                    EXPECT_LT(results[i].mean[0], 1.0) << bright << ", pixel " << i;
                }
            }
        }
}

} // namespace
} // namespace tilt_lens
