// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sequence.h
/// Where the rays of a pixel start (docs/sampling.md, section 2): points of [0, 1)^4, two coordinates for the lens and two for
/// the pixel's square. Each pair is Sobol's sequence in two dimensions, the pixel pair in another order,
/// Owen-scrambled by hashing.
///
/// Properties (each has its test, but for the last sentence):
/// - Pure: a sample depends on (pixel, index, seed) alone; neither threads nor tiles nor the order of
///   calls change it. Every index below 2^32 is valid.
/// - Range: odd multiples of 2^-33, so neither 0 nor 1 occurs and the mean is exactly unbiased.
/// - Stratification of the first 2^m samples, and of every aligned block of 2^m: each coordinate
///   alone has one sample in each of 2^m equal intervals; the lens pair is a (0, m, 2)-net, with
///   one sample in every elementary interval of area 2^-m, and so is the pixel pair. The first 2^m are
///   a (t, m, 4)-net with t <= 2 for m <= 6 and t <= 3 for m <= 14.
/// - Independence: pixels and seeds have scramblings of their own. Means over two seeds are
///   independent and unbiased, so (A - B)^2 / 4 estimates the variance of (A + B) / 2 without bias,
///   whatever the integrand. Within one seed blocks of samples repel each other: the halves of one
///   sequence would overestimate its error.
///
/// Why that order: what is sharp sees the pixel pair alone, what is far out of focus the lens pair, and a
/// blur of about a pixel all four. Shuffled anyhow (padding), the pairs have no strata in common, and such a
/// blur is little better than with random samples; Sobol's third and fourth dimension have them, but are no
/// (0, m, 2)-net, and 16 or 32 samples of all four do little together. The order was searched: for the first
/// seven bits of the index that of the least error over random edges, discs, checkers and sines (six in ten
/// along an axis of the picture) at blurs of 0, 0.5, 1, 3, 10 and 50 pixels; for each further bit that of the
/// most elementary intervals with their share of samples.
///
/// Sources: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020; I. M. Sobol', "On the
/// distribution of points in a cube and the approximate evaluation of integrals", USSR Comput. Math. Math.
/// Phys. 7(4), 1967; the hash is N. Vegdahl's improvement of Laine and
/// Karras's, "Building a Better LK Hash", 2021. Unlike Burley's, indices are not shuffled: a
/// scrambling of its own already sets each pixel apart.

#ifndef TILT_LENS_SEQUENCE_H
#define TILT_LENS_SEQUENCE_H

#include <cstdint>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// One point of (0, 1)^4.
struct SequencePoint
{
    double lensU, lensV;    ///< for the aperture map
    double pixelX, pixelY;  ///< position in the pixel's square
};

/// A number of each sample of a group, side by side. Groups begin with the numbers that cameraRaysOfBatch divides.
using OfGroup = double[settings.cameraRaysOfBatch];

/// The points of a group.
struct SequencePoints
{
    OfGroup lensU, lensV, pixelX, pixelY;

    SequencePoint operator[](std::uint32_t i) const { return {lensU[i], lensV[i], pixelX[i], pixelY[i]}; }
};

/// One point of (0, 1)^2.
struct Pair
{
    double u, v;
};

/// A bijection of 64-bit words without visible structure: the finaliser of SplitMix64 (D. Stafford's variant 13 of
/// MurmurHash3's).
inline std::uint64_t MixBits(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// The step of SplitMix64's counter: 2^64 over the golden ratio, odd.
constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;

/// The samples of one pixel. Cheap to make (a few hashes) and to copy.
class PixelSampler
{
  public:
    /// @param x, y  the pixel in the full image, not in the tile or sub-image that is rendered
    /// @param seed  tells replicates of the pixel apart
    PixelSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

    SequencePoint operator()(std::uint32_t index) const;

    /// The points of the group that a sample is in.
    void FindGroup(std::uint32_t index, SequencePoints& points) const;

    /// Two more numbers for a sample, as well distributed over the pixel's samples as its lens points,
    /// independent of them and of the pairs with other numbers: the sequence of the lens points in
    /// another order of its own (Burley's shuffled padding).
    Pair PaddedPair(std::uint32_t index, std::uint32_t number) const;

    /// A uniform hash for whatever else a sample needs, such as the seed of a random generator.
    /// Independent of the samples; equals PixelHash(x, y, seed, salt).
    std::uint32_t Hash(std::uint32_t salt) const { return std::uint32_t(StreamWord(std::uint64_t{salt} + 3) >> 32); }

  private:
    std::uint64_t key;              ///< of (x, y, seed)
    std::uint32_t scrambleSeed[4];  ///< of each dimension's scrambling

    /// The stream of the key. Words 1 and 2 scramble the samples, the later ones serve Hash().
    std::uint64_t StreamWord(std::uint64_t position) const { return MixBits(key + position * kGoldenStep); }
};

/// A uniform hash of its four arguments; any two that differ give unrelated values.
std::uint32_t PixelHash(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t salt);

}  // namespace tilt_lens

#endif
