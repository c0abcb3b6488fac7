// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file settings.h
/// All constants of the sampler, the emitter sampling and the reconstruction, with units. Sections are those of docs/sampling.md; its
/// section 8 gives the error without each constant, or the reason for its value.

#ifndef TILT_LENS_SETTINGS_H
#define TILT_LENS_SETTINGS_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

/// A constant is `static constexpr` if it sizes arrays or affects no picture; the ablation varies the others.
struct Settings
{
    /// @name Windows and blocks, in pixels unless said otherwise
    /// @{
    /// Side of a block: pixels that are sampled and reconstructed together, on a grid fixed to the whole picture.
    static constexpr std::uint32_t blockSide = 16;
    /// Distance, in blocks, of the farthest block that a pixel depends on (section 7).
    static constexpr std::int64_t dependencyRadius = 2;
    /// Rows of blocks, counted from the first unfinished one, in which an idle thread may work ahead. Affects no picture.
    static constexpr std::int64_t windowRows = 6;
    /// Radius of the window whose sample variances are averaged (section 3).
    static constexpr int neighbourRadius = 1;
    static constexpr int neighbourhoodPixels = (2 * neighbourRadius + 1) * (2 * neighbourRadius + 1);
    /// Radius of the longest filters (section 5).
    static constexpr int filterRadius = 4;
    /// Radii of the window over which risks are averaged, and of the window in which they count in full (section 5).
    static constexpr int riskRadius = 3, nearRiskRadius = 1;
    /// Farthest row or column that a sample is spread to (section 5).
    static constexpr int spreadReach = 7;
    /// A pixel spreads this number of samples to others, its first; more would cost more time than the rays they save.
    std::uint32_t mostSentSamples = 32;
    /// Cells in a row and in a column of the density table of an aperture that is not a disc.
    static constexpr int densityCells = 64;
    /// @}

    /// @name First round
    /// @{
    /// Samples of a pixel's first round if the scene does not state MIN (section 1), with and without reconstruction and emitter sampling.
    static constexpr std::uint32_t firstSamples = 4, firstSamplesAlone = 8;
    /// The first round of a block is doubled up to this (section 1), while at least farShare of its pixels need more than farFactor times
    /// the samples taken.
    static constexpr std::uint32_t mostFirstSamples = 16;
    double farShare = 0.25, farFactor = 8.0;
    /// Rounds up to this number of samples double them (section 1).
    std::uint32_t doubledSamples = 8;
    /// @}

    /// @name Steps and limits of computing
    /// @{
    /// Iterations that solve for the variance ratio of the mean (section 3).
    static constexpr int ratioIterations = 4;
    /// Upper bound of risks, also for NaN (section 5). The sum of 49 such risks is a finite float.
    static constexpr float greatestFiniteRisk = 1e12f;
    /// Camera rays computed together in vector registers: 4, 8 or 16. Affects no picture.
    static constexpr std::uint32_t cameraRaysOfBatch = 8;
    /// Samples of the pixel that the progress display probes in each block. Affects no picture.
    static constexpr std::uint32_t probeSamples = 8;
    /// @}

    /// @name Estimator of a pixel's variance (section 3)
    /// @{
    /// Weight of a quadrant's variance ratio of the previous round against that of this round, in equally noisy pixels.
    double varianceRatioPrior = 16.0;
    /// A pixel keeps its own variance ratio if it exceeds that of its quadrant by this factor.
    double outlyingRatio = 4.0;
    /// @}

    /// @name Emitter sampling (section 4)
    /// @{
    /// Radiance (1 is white) that lit surfaces seldom exceed, however bright the lights; and the part of the lights' sum that they seldom
    /// exceed, the `diffuse` of a default finish. An emitter is an object that is brighter by its own finish.
    static constexpr double greatestLitRadiance = 1.0, litShare = 0.6;
    /// Greatest number of images that are looked for in single flat mirrors, and in pairs of them: tenths of a second of computing.
    static constexpr std::size_t greatestImages = 1000000;
    /// Samples in a stratum of the lens coordinate: each aligned block of four samples has one in each quarter of [0, 1).
    static constexpr std::uint32_t emitterStratum = 4;
    /// Iterations that find the brightest point of a highlight: each gains a digit and more where sphere and light are far away.
    static constexpr int highlightIterations = 4;
    /// Points on a circle around the aperture from which the bounding box of an emitter's circle of confusion is computed.
    static constexpr int blurBoxPoints = 16;
    /// Greatest number of bins in a row or column of the picture; least side of a bin, pixels; greatest number of emitters in a bin.
    static constexpr std::uint32_t emitterBins = 64, leastEmitterBinSide = 8;
    static constexpr std::size_t emittersOfBin = 1024;
    /// Blur, in pixels, above which the lens point is importance-sampled; below, the film point.
    double lensPointBlur = 1.5;
    /// Share of a pixel's samples that is aimed at emitters: a multiple of 1 / emitterStratum.
    double emitterShare = 0.5;
    /// Greatest number of emitters that a pixel's samples are aimed at: the brightest. 0: none.
    std::uint32_t emittersOfPixel = 16;
    /// Emitter samples that must miss before the emitter counts as hidden: an object fills only a part of its bounding sphere.
    std::uint32_t hiddenEmitterSamples = 16;
    /// @}

    /// @name Reconstruction (section 5)
    /// @{
    /// A filter with a risk above this multiple of the unfiltered pixels' risk has no weight; risks below the inverse are chance.
    float greatestRisk = 20.0f;
    /// Limit of a pixel's risk over its noise, outside its 3 by 3 window.
    float riskLimit = 8.0f;
    /// Risk over noise of a 3 by 3 window that chance can explain.
    float chanceRisk = 2.0f;
    /// Weight of a spread estimate made of other pixels' samples alone, relative to a filter with the same risk.
    float spreadWeight = 8.0f;
    /// Additional factor of this weight if only other pixels' samples show the noise.
    float missedWeight = 100.0f;
    /// A row of a block is reconstructed if its mean variance over `variance` is at least this.
    double leastRowVariance = 1.0 / 32.0;
    /// @}

    /// @name Forecast of the reconstruction in the stop rule (section 6)
    /// @{
    /// Rays per pixel of a block that a forecast must save: about its cost.
    double forecastCost = 2.0;
    /// @}
};

#ifdef TILT_LENS_VARIABLE_SETTINGS
extern Settings settings;  // varied by the ablation's programs (benchmarks/tools)
#else
constexpr Settings settings;
#endif

}  // namespace tilt_lens

#endif
