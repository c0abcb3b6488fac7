// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file settings.h
/// Every number that steers the sampler, the emitter sampling and the reconstruction, with its unit and its meaning.
/// Sections are those of docs/sampling.md, whose last one has the evidence: of the numbers of Settings, what the error costs
/// without each of them; of the constants before it, which the compiler must know or which no picture depends on, the reason.

#ifndef TILT_LENS_SETTINGS_H
#define TILT_LENS_SETTINGS_H

#include <cstddef>
#include <cstdint>

namespace tilt_lens
{

/// @name Windows and blocks, in pixels unless said otherwise
/// @{
/// Side of the blocks that are sampled and reconstructed together, on a grid fixed to the whole picture.
constexpr std::uint32_t kBlockSide = 16;
/// Blocks from a pixel's own to the farthest that it depends on (section 10): filtering needs converged neighbours, whose
/// stop rule needs their neighbours' first rounds.
constexpr std::int64_t kDependencyRadius = 2;
/// To the farthest pixels whose sample variance counts for one: 3 by 3 (sections 3 and 4).
constexpr int kNeighbourRadius = 1;
constexpr int kNeighbourhoodPixels = (2 * kNeighbourRadius + 1) * (2 * kNeighbourRadius + 1);
/// To the farthest pixels that local variance ratios and residual variance ratios are pooled over: 5 by 5 (sections 3 and 8).
constexpr int kRatioRadius = 2;
/// From the middle of a filter to its end (section 8).
constexpr int kFilterRadius = 4;
/// From a pixel to the farthest whose risk counts for it: 7 by 7; and to those whose risk counts in full: 3 by 3 (section 8).
constexpr int kRiskRadius = 3, kNearRiskRadius = 1;
/// From a sample's pixel to the farthest pixel that it serves, along rows and columns (section 8).
constexpr int kSpreadReach = 7;
/// Cells, in a row, of the table of an opening that is no disc.
constexpr int kDensityCells = 64;
/// @}

/// @name First round
/// @{
/// Samples of a pixel's first round where a scene does not state MIN (section 1): where the picture is reconstructed and samples
/// are sent at emitters; and elsewhere, because small lamps are missed by four too often.
constexpr std::uint32_t kFirstSamples = 4, kFirstSamplesAlone = 8;
/// @}

/// @name Steps and limits of computing
/// @{
/// Steps of the iteration for the variance ratio of the mean (section 3).
constexpr int kRatioIterations = 4;
/// What greater risks, and those that are no number, are taken for (section 8): sums of 49 of them are still floats.
constexpr float kGreatestFiniteRisk = 1e12f;
/// Camera rays that are made at a time; no picture depends on it.
constexpr std::uint32_t kCameraRaysOfBatch = 8;
/// Samples of the pixel of each block that the progress display tries; no picture depends on it.
constexpr std::uint32_t kProbeSamples = 8;
/// @}

/// @name Emitter sampling (section 7)
/// @{
/// Radiance (1 is white) that what is lit seldom exceeds, however bright the lights are. An emitter is brighter by its own
/// finish; all else is found as lit surfaces are.
constexpr double kGreatestLitRadiance = 1.0;
/// Samples that share one decision about their lens coordinate: the sequence has one of each aligned block of four in each
/// quarter of it.
constexpr std::uint32_t kEmitterStratum = 4;
/// Points around the opening of the lens from which an emitter's disc of confusion is bounded.
constexpr int kBlurBoxPoints = 16;
/// Bins of pixels in a row or column of the picture, at most; their least side in pixels; and the emitters that a bin lists,
/// the brightest.
constexpr std::uint32_t kEmitterBins = 64, kLeastEmitterBinSide = 8;
constexpr std::size_t kEmittersOfBin = 1024;
/// @}

struct Settings
{
    /// @name Estimator of a pixel's variance (section 3)
    /// @{
    /// Samples after which a pixel's sample variance counts as much as that of the 3 by 3 pixels around.
    double shrinkageSamples = 4.0;
    /// Noisy pixels, all as noisy, that what was known before counts as: for a quadrant of a block its variance ratio of
    /// the round before, for the 5 by 5 pixels around one that of their quadrant.
    double varianceRatioPrior = 2.0;
    /// @}

    /// @name Undetected error (section 4)
    /// @{
    /// Distance, in blur radii of what a pixel has hit, up to which other pixels may see the same: a point covers all
    /// pixels within its blur radius, so that two pixels that see it are at most twice that apart.
    double blurReach = 2.0;
    /// A converged pixel is reactivated for an undetected error of so many times its target: what its neighbours hit is
    /// as uncertain as their samples are few.
    double reactivationFactor = 4.0;
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
    double leastTarget = 0.75, greatestTarget = 1.9;
    /// @}

    /// @name Emitter sampling (section 7)
    /// @{
    /// Blur, in pixels, from which on the lens point is chosen and not the film point.
    double lensPointBlur = 1.5;
    /// Share of a pixel's samples that is sent at emitters: a multiple of 1 / kEmitterStratum.
    double emitterShare = 0.5;
    /// Emitters that one pixel's samples are sent at, at most: the brightest. With 0, no sample is.
    std::uint32_t emittersOfPixel = 16;
    /// Emitter samples that must have missed before the emitter is believed hidden: an object fills only a part of the
    /// sphere around it, and that may lie over two pixels.
    std::uint32_t hiddenEmitterSamples = 16;
    /// @}

    /// @name Reconstruction (section 8)
    /// @{
    /// Least risk of a filter over that of the unfiltered pixels: less is chance.
    float leastRisk = 0.05f;
    /// Risk over that of the unfiltered pixels from which on a filter has no weight.
    float greatestRisk = 20.0f;
    /// Limit of a pixel's risk over its noise, for pixels not beside it.
    float riskLimit = 8.0f;
    /// Risk over noise of the 3 by 3 pixels around one that may be chance.
    float chanceRisk = 2.0f;
    /// Share of a pixel's variance that remains whatever the filters leave of the noise: their bias.
    float leastResidualRatio = 0.25f;
    /// Weight of a spread estimate that is wholly made of other pixels' samples, over that of a filter with the same risk.
    float spreadWeight = 16.0f;
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
