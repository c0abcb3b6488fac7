// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file measure.h
/// Differences of pictures, and a test for noisy pictures.

#ifndef WITNESS_MEASURE_H
#define WITNESS_MEASURE_H

#include <vector>

#include "picture.h"

namespace witness
{

struct PixelDifference
{
    int x = 0, y = 0;
    double difference = 0.0;
};

struct Figures
{
    double rootMeanSquare = 0.0;
    double signedMean = 0.0;  ///< new minus reference
    double largest = 0.0;         ///< absolute
    double largestLocalMean = 0.0;  ///< absolute, over boxes of 8 by 8 pixels
    std::size_t different = 0;
    std::vector<PixelDifference> worst;
};

Figures Measure(const Picture& picture, const Picture& reference, std::size_t worstCount = 10);

bool IsFinite(const Picture& picture);

struct ZTestSettings
{
    double floor = 0.001;        ///< least standard error, linear units
    double significance = 0.01;  ///< chance that a correct picture fails
    double passing = 0.9975;     ///< share of pixels that must pass
    int box = 8;                 ///< pixels per side
};

struct ZTest
{
    double pixelLimit = 0.0, boxLimit = 0.0;  ///< in standard errors
    double passing = 0.0;
    double largest = 0.0, largestBox = 0.0;   ///< in standard errors
    bool passed = false;
};

/// Gaussian limits by Sidak's correction (docs/testing.md).
ZTest TestNoisy(const Picture& picture, const Reference& reference, const ZTestSettings& settings);

/// Limit in standard errors that one of `count` Gaussian values exceeds with probability `significance`.
double SidakLimit(double significance, double count);

} // namespace witness

#endif
