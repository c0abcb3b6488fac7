// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file cell.h
/// How many rays a pixel gets. Pixels are judged in cells of 16 by 16 on a grid fixed to the whole
/// picture; beyond its own cell a pixel is only compared with the first samples of its neighbours.
/// Both depend on places in the picture alone, so that neither threads nor tiles nor sub-images
/// change a value.
///
/// A pixel's samples are a prefix of one low-discrepancy sequence, taken in rounds that double it.
/// After each round three things are known of the pixel, for each channel:
///
///     s^2 / n        variance of the mean if the n samples were independent (n - 1 in s^2); where some
///                    are aimed at emitters, that is a fixed share, so that only differences among
///                    these and among the others count;
///     (A - B)^2 / 4  with A and B the means of the two halves of the prefix: one number, but it sees
///                    what stratification gains. The halves of such a prefix fill each other's gaps,
///                    so that their difference overstates the error of their mean, never the reverse;
///     gain           the second over the first, pooled over a quarter of the cell, and leaning on that of the
///                    round before where few pixels of it are noisy.
///
/// What decides is gain (s^2 / n + u), with u for what the pixel's samples may have missed: a few equal samples beside
/// an edge are no certainty, and a small light far out of focus shows in few samples, but in some of every pixel that
/// it covers. Where the pixels around, or what is blurred as far as over this pixel, vary more than its own samples by
/// v, and by up to a from their mean in one sample, something fills a share p = v / a^2 there. Here it may be any
/// smaller share q, which n samples miss with probability (1 - q)^n, for a square error of (q a)^2: u is the mean of
/// (q a)^2 exp(-q n) over q from 0 to p. A pixel that was good enough is opened again once those beside it meet what makes
/// u too large, so that what all missed at first, an edge along them say, is followed from pixel to pixel. After few samples
/// s^2 leans towards the mean of that of the 3 by 3 pixels around.
///
/// The estimate is raised to the upper limit of the confidence interval that the number of samples leaves
/// (chi-square), and lowered to what the reconstruction will leave of it where that is asked for and less than half.
/// What a pixel may keep is the Allowance: noisy ones more than quiet ones, so that a picture gets the most out of its
/// rays.
///
/// A sample that is not finite counts as black and is counted apart.
///
/// Sources: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for distributed
/// ray tracing" (1985) for a stop by variance and confidence; A. B. Owen, "Monte Carlo theory, methods
/// and examples", chapter 17, for estimating the error of randomised sequences.

#ifndef TILT_LENS_CELL_H
#define TILT_LENS_CELL_H

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "tilt_lens/reconstruction/reconstruction.h"
#include "tilt_lens/sampling/sampling.h"

namespace tilt_lens
{

/// How the samples of a pixel, or of several, differ.
struct Variation
{
    Radiance variance{};  ///< of one sample; of several pixels the sum or the mean
    Radiance leap{};      ///< largest square by which one sample leaves its pixel's mean

    void Join(const Variation& other);
};

/// A square of pixels, sampled in two steps: the first samples, which neighbours look at, and the
/// rest. Steps may be asked for by any thread; each is done once.
class Cell
{
  public:
    /// A pixel after its first samples.
    struct First
    {
        Variation own;
        double deviation = 0.0;  ///< of one sample, worst channel; relative to what is above 1
        double blur = 0.0;       ///< widest blur met, pixels
    };

    /// A pixel after its last sample.
    struct Final
    {
        double variance = 0.0;  ///< of the mean, worst channel; relative to the square of what is above 1
        Radiance mean{};
        std::uint32_t samples = 0, notFinite = 0, aimed = 0;
        bool rebuilt = false;  ///< by the reconstruction
    };

    /// The cell and its eight neighbours, row by row; null outside the picture.
    using Neighbours = std::array<const Cell*, 9>;

    explicit Cell(const Area& area) : area(area) {}

    const Area area;

    void TakeFirst(const SamplingLimits& limits, const Tracer& trace);
    /// The neighbours have taken their first samples.
    void Finish(const Neighbours& neighbours, const SamplingLimits& limits, const Tracer& trace);

    /// @name Known after the first step. (x, y) is in the whole picture.
    /// @{
    const First& FirstOf(std::uint32_t x, std::uint32_t y) const { return first[Index(x, y)]; }
    /// @}

    /// @name Known after the second.
    /// @{
    const Final& FinalOf(std::uint32_t x, std::uint32_t y) const { return final[Index(x, y)]; }
    /// @}

    /// For the reconstruction, once the cells have taken their last samples. Null outside the picture.
    static Surroundings SurroundingsOf(const Neighbours& cells);
    /// The rows that are worth rebuilding.
    Rows NoisyRows(const SamplingLimits& limits) const;
    bool IsFinished() const { return done; }

  private:
    struct Pixel
    {
        std::array<Radiance, 2> half{};  ///< sums of the samples before and after the middle
        Radiance squares{};              ///< sum over both halves
        Radiance least, most;            ///< of a sample
        Radiance aimed{};                ///< sum of the samples that were aimed
        Variation own;                   ///< of its samples
        Variation blurred;               ///< as NoteBlurred() has it
        std::uint32_t samples = 0;
        std::uint32_t middle = 0;        ///< samples in the first half
        std::uint32_t aimedSamples = 0;
        std::uint32_t notFinite = 0;
        double blur = 0.0;               ///< widest of the first round
        double sought = 0.0;             ///< as Traced has it
        double gain = 1.0;               ///< of the last round
        double variance = 0.0;           ///< as Final has it
        double allowed = 0.0;            ///< for it, when it was judged last
        double remains = kLeastRemains;  ///< share of the variance after the reconstruction, when last asked
        bool open = true;                ///< wants more samples

        template<class Channels>
        void Add(const Radiance& value, Radiance& sum, std::size_t first);
    };

    /// An open pixel, the variance that decides about it, and what it may be.
    struct Judged
    {
        Pixel* pixel;
        Radiance variance;
        double allowed;
    };

    std::mutex busy;
    bool begun = false;
    bool varied = true;           ///< whether the first samples of any pixel differ
    std::uint64_t met = 0;        ///< samples that met anything
    double metShare = 0.0;        ///< of the first samples, those that did
    double mostMet = 0.0;         ///< the same of that quarter of the cell that met most
    bool meetsEnough = false;     ///< for the reconstruction to look at the cell
    std::atomic<bool> done{false};
    std::vector<Pixel> pixels;
    std::array<double, 4> gainByHalves;  ///< of the cell's quarters, in the last round
    double usualDeviation = 0.0;  ///< mean of the first samples' over the cell and its neighbours
    std::vector<First> first;
    std::unique_ptr<const Estimates> firstEstimates, laterEstimates;  ///< of the first round, for neighbours too; of the last
    std::uint32_t estimatedSamples = 0;  ///< of a pixel that is still open, when last noted; 0: never
    std::vector<Final> final;

    std::size_t Index(std::uint32_t x, std::uint32_t y) const
    {
        return (y - area.top) * std::size_t(area.width) + (x - area.left);
    }
    /// 0 to 3: upper left, upper right, lower left, lower right.
    std::size_t QuarterOf(std::size_t pixel) const
    {
        return 2 * (pixel / area.width / (kCell / 2)) + pixel % area.width / (kCell / 2);
    }
    void TakeSamples(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace);
    void TakeMore(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace);
    bool IsBesideOpen(std::size_t pixel) const;
    void OpenAgain(const Neighbours& neighbours);
    void NoteUsualDeviation(const Neighbours& neighbours);
    bool Judge(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples);
    void NoteGain(std::uint32_t samples);
    std::array<double, 4> GainsByHalves() const;
    std::vector<Radiance> VarianceAround() const;
    std::vector<double> GainAround() const;
    std::unique_ptr<const Estimates> Estimated() const;
    bool MeetsEnough(const Neighbours& neighbours) const;
    bool IsWorthRebuilding(const SamplingLimits& limits) const;
    void NoteEstimates(std::uint32_t samples);
    /// Null where the cell is left out.
    const Estimates* LastEstimates() const { return laterEstimates ? laterEstimates.get() : firstEstimates.get(); }
    void CreditReconstruction(const Neighbours& neighbours, const SamplingLimits& limits, std::uint32_t samples,
                              std::vector<Judged>& judged);
    template<class EstimatesOf>
    static Surroundings Gather(const Neighbours& cells, const EstimatesOf& estimatesOf);
    CellPlane Remains(const Neighbours& neighbours, bool afterFirst) const;
    bool IsVaried() const;
    bool IsVariedAround(const Neighbours& neighbours) const;
    Variation VariationAround(std::size_t pixel, const Neighbours& neighbours) const;
    void NoteBlurred(const Neighbours& neighbours);
    void NoteBlurredOver(std::int64_t x, std::int64_t y, double reach, const Variation& variation);
    static Variation VariationOf(const Pixel& pixel);
    static Radiance Unseen(const Pixel& pixel, const Variation& around);
    static bool HasSought(const Pixel& pixel, double allowed);
    static Radiance MeanOf(const Pixel& pixel);
};

/// The neighbour that holds a pixel beside the cell, or null outside the picture.
const Cell* Holder(const Cell::Neighbours& neighbours, std::int64_t x, std::int64_t y);

} // namespace tilt_lens

#endif
