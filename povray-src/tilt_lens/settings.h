// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file settings.h
/// Every number that steers the sampler, the emitter sampling and the reconstruction, with its unit and its meaning.
/// Sections are those of docs/sampling.md, whose last one has the evidence: what the error costs without each number, or the
/// reason for its value.

#ifndef TILT_LENS_SETTINGS_H
#define TILT_LENS_SETTINGS_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

/// What the compiler must know, since it sets the size of arrays, or what no picture depends on is constant; the ablation varies
/// the rest.
struct Settings
{
    /// @name Windows and blocks, in pixels unless said otherwise
    /// @{
    /// Side of the blocks that are sampled and reconstructed together, on a grid fixed to the whole picture.
    static constexpr std::uint32_t blockSide = 16;
    /// Blocks from a pixel's own to the farthest that it depends on (section 10): filtering needs converged neighbours, whose
    /// stop rule needs their neighbours' first rounds.
    static constexpr std::int64_t dependencyRadius = 2;
    /// Rows of blocks, from the first that is not finished on, from which a thread takes work while others take what it needs: two rows
    /// of the usual tiles and what they depend on. No picture depends on it.
    static constexpr std::int64_t windowRows = 6;
    /// To the farthest pixels whose sample variance counts for one: 3 by 3 (sections 3 and 4).
    static constexpr int neighbourRadius = 1;
    static constexpr int neighbourhoodPixels = (2 * neighbourRadius + 1) * (2 * neighbourRadius + 1);
    /// To the farthest pixels that local variance ratios are pooled over: 5 by 5 (section 3).
    static constexpr int ratioRadius = 2;
    /// From the middle of a filter to its end (section 8).
    static constexpr int filterRadius = 4;
    /// From a pixel to the farthest whose risk counts for it: 7 by 7; and to those whose risk counts in full: 3 by 3 (section 8).
    static constexpr int riskRadius = 3, nearRiskRadius = 1;
    /// From a sample's pixel to the farthest pixel that it serves, along rows and columns (section 8).
    static constexpr int spreadReach = 7;
    /// Samples of a pixel that serve other pixels, at most: its first. More would cost more time than they save rays.
    std::uint32_t mostSentSamples = 32;
    /// Cells, in a row, of the table of an opening that is no disc.
    static constexpr int densityCells = 64;
    /// @}

    /// @name First round
    /// @{
    /// Samples of a pixel's first round where a scene does not state MIN (section 1): where the picture is reconstructed and samples
    /// are sent at emitters; and elsewhere, because small lamps are missed by four too often.
    static constexpr std::uint32_t firstSamples = 4, firstSamplesAlone = 8;
    /// Up to so many samples the first round of a block is doubled (section 1) while this share of its pixels need more than so many
    /// times the samples that they have.
    static constexpr std::uint32_t mostFirstSamples = 16;
    double farShare = 0.25, farFactor = 4.0;
    /// @}

    /// @name Steps and limits of computing
    /// @{
    /// Steps of the iteration for the variance ratio of the mean (section 3).
    static constexpr int ratioIterations = 4;
    /// What greater risks, and those that are no number, are taken for (section 8): sums of 49 of them are still floats.
    static constexpr float greatestFiniteRisk = 1e12f;
    /// Camera rays that are made at a time, side by side in registers: 4, 8 or 16. No picture depends on it.
    static constexpr std::uint32_t cameraRaysOfBatch = 8;
    /// Samples of the pixel of each block that the progress display tries; no picture depends on it.
    static constexpr std::uint32_t probeSamples = 8;
    /// @}

    /// @name Estimator of a pixel's variance (section 3)
    /// @{
    /// Samples after which a pixel's sample variance counts as much as that of the 3 by 3 pixels around.
    double shrinkageSamples = 4.0;
    /// Noisy pixels, all as noisy, that what was known before counts as: for a quadrant of a block its variance ratio of
    /// the round before, for the 5 by 5 pixels around one that of their quadrant.
    double varianceRatioPrior = 2.0;
    /// A pixel whose own variance ratio is so many times that of the pixels around keeps its own: filters may then take it for noise.
    double outlyingRatio = 4.0;
    /// @}

    /// @name Undetected error (section 4)
    /// @{
    /// A converged pixel is reactivated for an undetected error of so many times its target: what its neighbours hit is
    /// as uncertain as their samples are few.
    double reactivationFactor = 4.0;
    /// Samples of other pixels that a pixel's circles must bring, so that its own variance and the mean over the 3 by 3 pixels around
    /// count alike for whether it has converged.
    double samplesToDecideTogether = 8.0;
    /// Factor of the variance that single pixels of a block and of its neighbours have met, as that of all others that may have missed the
    /// like. With 0 nothing is searched for.
    double loneVarianceFactor = 1.0;
    /// Variance that a converged pixel has missed, over `variance`, from which on it takes further rounds.
    double missedVariance = 1.0;
    /// @}

    /// @name Confidence factor (section 5)
    /// @{
    /// Pixels as many as whose samples all that is pooled (variance ratio, undetected error, forecast) adds to the degrees
    /// of freedom.
    double pooledPixels = 2.0;
    /// @}

    /// @name Variance target (section 6)
    /// @{
    /// Variance of one sample where a pixel's target is just `variance`: between those of texture and of blurred edges.
    double typicalSampleVariance = 0.003;
    /// Least target over `variance`; and the greatest, of pixels that deviate more than those around.
    double leastTarget = 0.75, greatestTarget = 1.75;
    /// @}

    /// @name Emitter sampling (section 7)
    /// @{
    /// Radiance (1 is white) that what is lit seldom exceeds, however bright the lights are. An emitter is brighter by its own
    /// finish; all else is found as lit surfaces are.
    static constexpr double greatestLitRadiance = 1.0;
    /// Samples that share one decision about their lens coordinate: the sequence has one of each aligned block of four in each
    /// quarter of it.
    static constexpr std::uint32_t emitterStratum = 4;
    /// Points around the opening of the lens from which an emitter's disc of confusion is bounded.
    static constexpr int blurBoxPoints = 16;
    /// Bins of pixels in a row or column of the picture, at most; their least side in pixels; and the emitters that a bin lists,
    /// the brightest.
    static constexpr std::uint32_t emitterBins = 64, leastEmitterBinSide = 8;
    static constexpr std::size_t emittersOfBin = 1024;
    /// Blur, in pixels, from which on the lens point is chosen and not the film point.
    double lensPointBlur = 1.5;
    /// Share of a pixel's samples that is sent at emitters: a multiple of 1 / emitterStratum.
    double emitterShare = 0.5;
    /// Emitters that one pixel's samples are sent at, at most: the brightest. With 0, no sample is.
    std::uint32_t emittersOfPixel = 16;
    /// Emitter samples that must have missed before the emitter is believed hidden: an object fills only a part of the
    /// sphere around it, and that may lie over two pixels.
    std::uint32_t hiddenEmitterSamples = 16;
    /// @}

    /// @name Reconstruction (section 8)
    /// @{
    /// Risk of a filter over that of the unfiltered pixels from which on it has no weight; below the inverse, less is chance.
    float greatestRisk = 20.0f;
    /// Limit of a pixel's risk over its noise, for pixels not beside it.
    float riskLimit = 8.0f;
    /// Risk over noise of the 3 by 3 pixels around one that may be chance.
    float chanceRisk = 2.0f;
    /// Weight of a spread estimate that is wholly made of other pixels' samples, over that of a filter with the same risk.
    float spreadWeight = 8.0f;
    /// How many times more it weighs where other pixels' samples tell all of the noise, and the pixel's own none of it.
    float missedWeight = 100.0f;
    /// Mean variance of a row of a block, over `variance`, below which the row is not reconstructed.
    double leastRowVariance = 1.0 / 32.0;
    /// @}

    /// @name Forecast of the reconstruction in the stop rule (section 9)
    /// @{
    /// Rays a pixel of a block that a forecast must save: about what it takes the time of.
    double forecastCost = 2.0;
    /// @}
};

#ifdef TILT_LENS_VARIABLE_SETTINGS
extern Settings settings;  // of the ablation's programs (benchmarks/tools)
#else
constexpr Settings settings;
#endif

} // namespace tilt_lens

#endif
