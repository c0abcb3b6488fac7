// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sampler.h
/// Where the rays of a pixel start: points of [0, 1)^4, two coordinates for the lens and two for
/// the pixel's square. Sobol's sequence with Joe and Kuo's direction numbers, Owen-scrambled by
/// hashing.
///
/// Properties (each has its test, but for the last sentence):
/// - Pure: a sample depends on (pixel, index, seed) alone; neither threads nor tiles nor the order of
///   calls change it. Every index below 2^32 is valid.
/// - Range: odd multiples of 2^-33, so neither 0 nor 1 occurs and the mean is exactly unbiased.
/// - Stratification of the first 2^m samples, and of every aligned block of 2^m: each coordinate
///   alone has one sample in each of 2^m equal intervals; the lens pair is a (0, m, 2)-net, with
///   one sample in every elementary interval of area 2^-m; all four are a (3, m, 4)-net, the pixel
///   pair with it.
/// - Independence: pixels and seeds have scramblings of their own. Means over two seeds are
///   independent and unbiased, so (A - B)^2 / 4 estimates the variance of (A + B) / 2 without bias,
///   whatever the integrand. Within one seed blocks of samples repel each other: the halves of one
///   sequence would overestimate its error.
///
/// Which dimensions: measured as the RMS error over random edges, discs, checkers and sines seen
/// through a lens that blurs by a radius of 0, 0.5, 1, 3, 10 and 50 pixels (geometric mean, as a
/// fraction of the error of independent random samples):
///
///     samples                                         16     64    256   1024
///     lens = dimensions 0, 1; pixel = 2, 3          0.54   0.37   0.27   0.19   (chosen)
///     lens = dimensions 0, 2; pixel = 1, 3          0.55   0.37   0.29   0.19
///     lens = dimensions 3, 2; pixel = 0, 1          0.54   0.38   0.29   0.20
///     two (0, 2)-sequences, shuffled (padding)      0.59   0.48   0.41   0.37
///     two (0, 2)-sequences, second reordered by
///     a matrix searched for its 4-D quality         0.52   0.36   0.28   0.19
///
/// Padding spoils the strata across the pairs, which is what a blur of about a pixel needs: there
/// it is little better than random. The searched matrix makes the pixel pair a (0, m, 2)-net too,
/// but its 4-D quality decays with m (t = 7 at 2^18 samples) where the chosen one keeps t = 3.
///
/// Sources: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; S. Joe and F. Y.
/// Kuo, "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci.
/// Comput. 30, 2008 (file new-joe-kuo-6); the hash is N. Vegdahl's improvement of Laine and
/// Karras's, "Building a Better LK Hash", 2021. Unlike Burley's, indices are not shuffled: a
/// scrambling of its own already sets each pixel apart.

#ifndef TILT_LENS_SAMPLER_H
#define TILT_LENS_SAMPLER_H

#include <cstdint>

namespace tilt_lens
{

/// One point of (0, 1)^4.
struct Sample
{
    double lensU, lensV;    ///< for the aperture map
    double pixelX, pixelY;  ///< position in the pixel's square
};

/// One point of (0, 1)^2.
struct Pair
{
    double u, v;
};

/// The samples of one pixel. Cheap to make (a few hashes) and to copy.
class PixelSampler
{
  public:
    /// @param x, y  the pixel in the full image, not in the tile or sub-image that is rendered
    /// @param seed  tells replicates of the pixel apart
    PixelSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

    Sample operator()(std::uint32_t index) const;

    /// Two more numbers for a sample, as well distributed over the pixel's samples as its lens points,
    /// independent of them and of the pairs with other numbers: the sequence of the lens points in
    /// another order of its own (Burley's shuffled padding).
    Pair Further(std::uint32_t index, std::uint32_t number) const;

    /// A uniform hash for whatever else a sample needs, such as the seed of a random generator.
    /// Independent of the samples; equals PixelHash(x, y, seed, salt).
    std::uint32_t Hash(std::uint32_t salt) const;

  private:
    std::uint64_t key;              ///< of (x, y, seed)
    std::uint32_t scrambleSeed[4];  ///< of each dimension's scrambling
};

/// A uniform hash of its four arguments; any two that differ give unrelated values.
std::uint32_t PixelHash(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t salt);

}  // namespace tilt_lens

#endif
