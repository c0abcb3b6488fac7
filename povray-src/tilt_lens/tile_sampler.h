// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tile_sampler.h
/// How many rays a pixel gets. Pixels are judged in cells of 8 by 8 on a grid fixed to the whole
/// picture; beyond its own cell a pixel is only compared with the first samples of its neighbours.
/// Both depend on places in the picture alone, so that neither threads nor tiles nor sub-images
/// change a value.
///
/// A pixel's samples are a prefix of one low-discrepancy sequence, taken in rounds that double it.
/// After each round three things are known of the pixel, for each channel:
///
///     s^2 / n        variance of the mean if the n samples were independent (n - 1 in s^2);
///     (A - B)^2 / 4  with A and B the means of the two halves of the prefix: one number, but it sees
///                    what stratification gains. The halves of such a prefix fill each other's gaps,
///                    so that their difference overstates the error of their mean, never the reverse;
///     gain           the second over the first, pooled over the cell.
///
/// What decides is gain s^2 / n, with s^2 no smaller than its mean over the neighbouring pixels (a few
/// equal samples beside an edge are no certainty) and over all that is blurred as far as the pixel (a
/// small light far out of focus shows in few samples, but in some of every pixel that it covers). It
/// is raised to the upper limit of the confidence interval that the number of samples leaves
/// (chi-square).
///
/// A sample that is not finite counts as black and is counted apart.
///
/// Sources: M. E. Lee, R. A. Redner, S. P. Uselton, "Statistically optimized sampling for distributed
/// ray tracing" (1985) for a stop by variance and confidence; A. B. Owen, "Monte Carlo theory, methods
/// and examples", chapter 17, for estimating the error of randomised sequences.

#ifndef TILT_LENS_TILE_SAMPLER_H
#define TILT_LENS_TILE_SAMPLER_H

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "sampler.h"

namespace tilt_lens
{

/// Red, green, blue, filter, transmit; linear.
using Radiance = std::array<double, 5>;

/// What one sample brings home.
struct Traced
{
    Radiance light;
    double blur = 0.0;  ///< radius in pixels over which the surface that was met is spread, at most

    Traced& operator=(const Radiance& value)
    {
        light = value;
        blur = 0.0;
        return *this;
    }
};

/// `blur_samples MIN, MAX`, `variance` and `confidence` of a camera.
struct SamplingLimits
{
    std::uint32_t min = 8, max = 1024;  ///< samples per pixel, 1 <= min <= max
    double variance = 1e-4;             ///< of a pixel's mean, where its brightness is at most 1
    double confidence = 0.9;            ///< that the variance is below, (0, 1)
};

/// What a set of pixels cost and how good they are.
struct SamplingAccount
{
    std::map<std::uint32_t, std::uint64_t> pixelsBySamples;  ///< samples of a pixel -> pixels
    double variance = 0.0;                                   ///< sum over pixels, worst channel each
    std::uint64_t notFinite = 0;                             ///< samples that were no light

    void Add(const SamplingAccount& other);
    std::uint64_t Pixels() const;
    std::uint64_t Samples() const;
    std::uint32_t Most() const;
    /// Samples that `share` of the pixels did not exceed.
    std::uint32_t Quantile(double share) const;
    /// Root of the mean estimated variance.
    double StandardError() const;
};

/// Identifies one sample of one pixel.
struct SampleId
{
    std::uint32_t x, y;   ///< pixel in the whole picture
    std::uint32_t index;  ///< 0, 1, ... in the order taken
};

/// Pixels of the whole picture; (0, 0) is its upper left corner.
struct Area
{
    std::uint32_t left, top, width, height;

    std::uint32_t Right() const { return left + width; }    ///< first column outside
    std::uint32_t Bottom() const { return top + height; }   ///< first row outside
    bool Has(std::uint32_t x, std::uint32_t y) const
    {
        return x >= left && x < Right() && y >= top && y < Bottom();
    }
};

class TileSampler
{
  public:
    static constexpr std::uint32_t kCell = 8;

    /// Traces one sample; the position in the pixel is sample.pixelX, pixelY.
    using Tracer = std::function<void(const SampleId& id, const Sample& sample, Traced& result)>;

    explicit TileSampler(const SamplingLimits& limits);

    /// Samples a tile of a picture of `width` by `height` pixels; the tile lies inside.
    void Run(const Area& tile, std::uint32_t width, std::uint32_t height, const Tracer& trace);

    /// @name Results for a pixel of the tile, after Run.
    /// @{
    Radiance Mean(std::uint32_t x, std::uint32_t y) const;
    std::uint32_t Samples(std::uint32_t x, std::uint32_t y) const;
    double Variance(std::uint32_t x, std::uint32_t y) const;  ///< estimate, of the mean, worst channel;
                                                              ///< relative to the square of what is above 1
    SamplingAccount Account() const;                          ///< of the tile
    /// @}

  private:
    struct Pixel
    {
        std::array<Radiance, 2> half{};  ///< sums of the samples before and after the middle
        Radiance squares{};              ///< sum over both halves
        Radiance firstSpread{};          ///< variance of one sample, from the first round
        std::uint32_t samples = 0;
        std::uint32_t middle = 0;        ///< samples in the first half
        std::uint32_t notFinite = 0;
        double firstBlur = 0.0;          ///< widest blur of the first round
        Radiance blurredSpread{};        ///< as BlurredSpread() gives it
        double variance = 0.0;           ///< as Variance() gives it
        bool open = true;                ///< wants more samples
    };

    SamplingLimits limits;
    Area tile{};
    Area held{};  ///< the tile's cells and one pixel around them
    std::vector<Pixel> pixels;

    Pixel& At(std::uint32_t x, std::uint32_t y) { return pixels[(y - held.top) * held.width + (x - held.left)]; }
    const Pixel& At(std::uint32_t x, std::uint32_t y) const { return const_cast<TileSampler*>(this)->At(x, y); }

    void RunCell(const Area& cell, const Tracer& trace);
    void TakeSamples(std::uint32_t x, std::uint32_t y, std::uint32_t until, const Tracer& trace);
    bool Judge(const Area& cell, std::uint32_t samples);
    double PooledGain(const Area& cell) const;
    Radiance NeighbourhoodSpread(const Area& cell, std::uint32_t x, std::uint32_t y) const;
    Radiance BlurredSpread(const Area& cell, std::uint32_t x, std::uint32_t y) const;
    static Radiance Spread(const Pixel& pixel);
    static Radiance MeanOf(const Pixel& pixel);
};

} // namespace tilt_lens

#endif
