// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file settings.h
/// Constants of sampler, emitter sampling and reconstruction. Sections are those of docs/sampling.md; section 8 gives the reason for each
/// value.

#ifndef TILT_LENS_SETTINGS_H
#define TILT_LENS_SETTINGS_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

/// The ablation varies constants that are not `static constexpr`.
struct Settings
{
    /// @name Windows and blocks, in pixels unless said otherwise
    /// @{
    /// Side of a block, on a grid fixed to the whole picture.
    static constexpr std::uint32_t blockSide = 16;
    /// Farthest block that a pixel depends on, in blocks (section 7).
    static constexpr std::int64_t dependencyRadius = 2;
    /// Rows of blocks, from the first unfinished one, in which idle threads work ahead. Affects no picture.
    static constexpr std::int64_t windowRows = 6;
    /// Radius of the window of averaged variances (section 3).
    static constexpr int neighbourRadius = 1;
    static constexpr int neighbourhoodPixels = (2 * neighbourRadius + 1) * (2 * neighbourRadius + 1);
    /// Radius of the longest filters (section 5).
    static constexpr int filterRadius = 4;
    /// Radii of the windows over which risks are averaged, and in which they count in full (section 5).
    static constexpr int riskRadius = 3, nearRiskRadius = 1;
    /// Reach of spread samples (section 5).
    static constexpr int spreadReach = 7;
    /// A pixel's first samples, spread to others; more would cost more time than they save.
    std::uint32_t mostSentSamples = 32;
    /// Cells per row and column of the density table of non-circular apertures.
    static constexpr int densityCells = 64;
    /// @}

    /// @name First round
    /// @{
    /// Default of MIN (section 1), with and without reconstruction and emitter sampling.
    static constexpr std::uint32_t firstSamples = 4, firstSamplesAlone = 8;
    /// Rounds end half-way between powers of two as well (section 1). Off in measurements alone.
    bool halfRounds = true;
    /// @}

    /// @name Steps and limits of computing
    /// @{
    /// Iterations for the variance ratio (section 3).
    static constexpr int ratioIterations = 4;
    /// Upper bound of risks, also for NaN (section 5): the sum of 49 is finite.
    static constexpr float greatestFiniteRisk = 1e12f;
    /// Camera rays computed together in vector registers: 4, 8 or 16. Affects no picture.
    static constexpr std::uint32_t cameraRaysOfBatch = 8;
    /// Samples of a pixel probed for the progress display. Affects no picture.
    static constexpr std::uint32_t probeSamples = 8;
    /// @}

    /// @name Estimator of a pixel's variance (section 3)
    /// @{
    /// Least share of the worst colour's variance that counts.
    static constexpr double worstColourShare = 0.7;
    /// Samples beyond which the pixels around count less.
    static constexpr std::uint32_t reliableSamples = 16;
    /// Weight of the previous round's variance ratio, in equally noisy pixels.
    double varianceRatioPrior = 16.0;
    /// A pixel keeps its own variance ratio if it exceeds its quadrant's by this factor.
    static constexpr double outlyingRatio = 4.0;
    /// @}

    /// @name Targets of single pixels, over V (section 3)
    /// @{
    /// Share of the target in proportion to a pixel's standard deviation; the rest is equal.
    double deviationShare = 0.5;
    /// A pixel with n samples has a target of at most V n over this number, or of V if that is more.
    static constexpr double samplesPerTarget = 48.0;
    /// @}

    /// @name Emitter sampling (section 4)
    /// @{
    /// Radiance (1 is white), and part of the lights' sum (`diffuse` of a default finish), that lit surfaces seldom exceed. Emitters are
    /// brighter.
    static constexpr double greatestLitRadiance = 1.0, litShare = 0.6;
    /// Most images sought in single flat mirrors, and in pairs: tenths of a second of computing.
    static constexpr std::size_t greatestImages = 1000000;
    /// Samples per stratum of the lens coordinate: an aligned block of four has one in each quarter of [0, 1).
    static constexpr std::uint32_t emitterStratum = 4;
    /// Iterations that find a highlight's brightest point: each gains a digit or more on distant spheres.
    static constexpr int highlightIterations = 4;
    /// Points around the aperture that bound an emitter's circle of confusion.
    static constexpr int blurBoxPoints = 16;
    /// Most bins in a row or column; least side of a bin, pixels; most emitters in a bin.
    static constexpr std::uint32_t emitterBins = 64, leastEmitterBinSide = 8;
    static constexpr std::size_t emittersOfBin = 1024;
    /// Blur, in pixels, above which the lens point is importance-sampled; below, the film point.
    double lensPointBlur = 1.5;
    /// Share of samples aimed at emitters: a multiple of 1 / emitterStratum.
    double emitterShare = 0.5;
    /// Most emitters, the brightest, that a pixel's samples are aimed at.
    std::uint32_t emittersOfPixel = 16;
    /// Misses before an emitter counts as hidden: an object fills only a part of its bounding sphere.
    std::uint32_t hiddenEmitterSamples = 16;
    /// Radiance above which the search for lamps in a sharp picture finds them: two f-stops above white.
    static constexpr double searchRadiance = 4.0;
    /// Its rays: most per pixel once one per pixel has found lamps, most in all, and most over the samples that a pixel may take.
    static constexpr double searchRays = 9.0, searchCells = 4194304.0, searchPart = 0.25;
    /// Share of the picture that circles of lamps cover, above which one ray per pixel is not enough.
    static constexpr double searchCover = 0.02;
    /// Its margin over the picture's longer side.
    static constexpr double searchMargin = 0.125;
    /// Share of bright cells in a circle of confusion above which plain samples find lamps.
    static constexpr double searchShare = 0.05;
    /// @}

    /// @name Reconstruction (section 5)
    /// @{
    /// Risk over noise from which a filter has no weight. A pixel outside the 3 by 3 window counts at most with it. Its inverse is the least.
    float greatestRisk = 16.0f;
    /// Risk over noise of a 3 by 3 window that chance can explain.
    float chanceRisk = 2.0f;
    /// Weight of a spread estimate of other pixels' samples alone, relative to a filter with equal risk.
    float spreadWeight = 8.0f;
    /// Additional factor of this weight if only other pixels' samples show the noise.
    float missedWeight = 100.0f;
    /// Correlation of the noise that filters and spread estimates leave; their samples are in part the same. Affects reported errors alone.
    static constexpr float spreadCorrelation = 0.5f;
    /// The stop rule counts on the reconstruction (section 6). Off in measurements alone.
    bool forecasts = true;
    /// @}
};

/// Those of the program. A program that defines this function itself has others (benchmarks/tools/record_samples.cpp).
Settings DefaultSettings();

}  // namespace tilt_lens

#endif
