// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file measure.h
/// Figures of a difference, and a test for noisy pictures.

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
    double rootMeanSquare = 0.0;  ///< over all pixels and channels
    double signedMean = 0.0;  ///< of new minus reference
    double largest = 0.0;         ///< absolute
    double largestLocalMean = 0.0;  ///< absolute, of the signed mean over boxes of 8 by 8 pixels, each channel
    std::size_t different = 0;
    std::vector<PixelDifference> worst;
};

Figures Measure(const Picture& picture, const Picture& reference, std::size_t worstCount = 10);

bool IsFinite(const Picture& picture);

struct ZTestSettings
{
    double floor = 0.001;        ///< least standard error of a difference, in linear units
    double significance = 0.01;  ///< probability that a correct picture has a failing pixel (or box)
    double passing = 0.9975;     ///< share of pixels that must pass
    int box = 8;                 ///< pixels per side, for the local mean
};

struct ZTest
{
    double pixelLimit = 0.0, boxLimit = 0.0;  ///< in standard errors
    double passing = 0.0;
    double largest = 0.0, largestBox = 0.0;   ///< in standard errors
    bool passed = false;
};

/// The test of docs/testing.md: Gaussian limits by Sidak's correction for the number of pixels or boxes.
ZTest TestNoisy(const Picture& picture, const Reference& reference, const ZTestSettings& settings);

/// Two-sided, in standard errors: one of `count` Gaussian values exceeds it with probability `significance`.
double SidakLimit(double significance, double count);

} // namespace witness

#endif
