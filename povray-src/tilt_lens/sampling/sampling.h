// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampling.h
/// What sampling a picture is asked for, what one sample brings, and what a set of pixels cost.

#ifndef TILT_LENS_SAMPLING_H
#define TILT_LENS_SAMPLING_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>

#include "tilt_lens/sampling/sequence.h"

namespace tilt_lens
{

/// Red, green, blue, filter, transmit; linear.
using Radiance = std::array<double, 5>;

inline double Square(double x) { return x * x; }

inline void AddTo(Radiance& sum, const Radiance& value)
{
    for (std::size_t c = 0; c < sum.size(); c++)
        sum[c] += value[c];
}

/// Whether all channels are finite.
inline bool IsLight(const Radiance& value)
{
    return std::all_of(value.begin(), value.end(), [](double x) { return std::isfinite(x); });
}

/// Whether any channel is not zero.
inline bool IsAny(const Radiance& value)
{
    bool any = false;
    for (const double x : value)
        any |= x != 0.0;
    return any;
}

/// What a variance is divided by where the mean is so bright: above white an error is seen relative to it.
inline double Brightness(double mean) { return mean > 1.0 ? mean * mean : 1.0; }

/// What one sample brings home.
struct Traced
{
    Radiance light;
    double blur = 0.0;   ///< radius in pixels over which the surface that was met is spread, at most
    double sought = 0.0; ///< light of the emitters that the pixel's aimed samples are sent at (emitters.h), if nothing
                         ///< hides them; 0: this sample was not aimed. Every fourth is, every second or none
    bool met = true;     ///< anything on its way, were it only haze

    Traced& operator=(const Radiance& value)
    {
        light = value;
        blur = 0.0;
        sought = 0.0;
        met = true;
        return *this;
    }
};

/// `blur_samples MIN, MAX`, `variance`, `confidence` and `denoise` of a camera.
struct SamplingLimits
{
    std::uint32_t min = 8, max = 1024;  ///< samples per pixel, 1 <= min <= max
    double variance = 1e-4;             ///< of a pixel's value, where its brightness is at most 1
    double confidence = 0.9;            ///< that the variance is below, (0, 1)
    bool denoise = false;               ///< smooth the noise away (reconstruction.h)

    /// Samples that every pixel gets before it is judged: min, rounded up to a power of two that max allows.
    std::uint32_t First() const;

    /// `variance 0` asks for the samples as they are.
    bool Denoises() const { return denoise && variance > 0.0; }
};

/// Variance that pixels may keep after a number of samples: `variance` on the whole, but more where noise is strong and
/// less where it is weak. Rays lower the mean square error of a picture most if a pixel gets them in proportion to the
/// standard deviation of its samples, not to their variance (J. Neyman, "On the two different aspects of the
/// representative method", 1934): n of a deviation s leave s^2/n, which is then in proportion to n.
class Allowance
{
  public:
    Allowance(const SamplingLimits& limits, std::uint32_t samples) :
        variance(limits.variance), proportional(samples * limits.variance / kUsualSpread) {}

    /// @param unusual  standard deviation of one sample over its mean around the pixel: more than `variance` is
    ///                 for pixels that stand out, and much less for those that are quiet beside others; where all are as
    ///                 noisy or as quiet, all keep about what was asked for, so that no ray is wasted
    double operator()(double unusual) const;

    /// Variance of one sample where a pixel keeps just `variance`: between what texture and blurred edges have.
    static constexpr double kUsualSpread = 0.003;
    /// And how far from `variance` a pixel's own may be, as factors: so that nothing looks rough in a good picture.
    static constexpr double kLeast = 0.25, kLeastWhereEven = 0.75, kMost = 1.9;
    /// What stands out by more than this is rare, and may keep more.
    static constexpr double kFew = 3.0, kMostOfFew = 3.0;

  private:
    double variance;
    double proportional;  ///< what the samples are in proportion to, as a factor
};

/// Identifies one sample of one pixel.
struct SampleId
{
    std::uint32_t x, y;   ///< pixel in the whole picture
    std::uint32_t index;  ///< 0, 1, ... in the order taken
};

/// Traces one sample, that which PixelSampler(id.x, id.y, 0) gives for id.index.
using Tracer = std::function<void(const SampleId& id, Traced& result)>;

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

/// What a set of pixels cost and how good they are.
struct SamplingAccount
{
    std::map<std::uint32_t, std::uint64_t> pixelsBySamples;  ///< samples of a pixel -> pixels
    double variance = 0.0;                                   ///< sum over pixels, worst channel each
    std::uint64_t notFinite = 0;                             ///< samples that were no light
    std::uint64_t aimed = 0;                                 ///< samples that were aimed at emitters
    std::uint64_t rebuilt = 0;                               ///< pixels that were averaged
    std::uint64_t lightPoints = 0;                           ///< points of area lights that were asked for
    std::uint64_t lightPointsLeft = 0;                       ///< and those beside them that were not

    void Add(const SamplingAccount& other);
    std::uint64_t Pixels() const;
    std::uint64_t Samples() const;
    /// Pixels with that many samples or fewer.
    std::uint64_t PixelsUpTo(std::uint32_t samples) const;
    std::uint32_t Most() const;
    /// Samples that `share` of the pixels did not exceed.
    std::uint32_t Quantile(double share) const;
    /// Root of the mean estimated variance.
    double StandardError() const;
};

} // namespace tilt_lens

#endif
