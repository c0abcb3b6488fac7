// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sequence.h
/// A pixel's sample sequence (docs/sampling.md, section 2): points of (0, 1)^4, two coordinates for the lens and two for the pixel's
/// square. Each pair is a two-dimensional Sobol sequence, the pixel pair reordered, Owen-scrambled by hashing.
///
/// Tested properties:
/// - Pure: a sample depends on (pixel, index, seed) alone. Every index below 2^32 is valid.
/// - Range: odd multiples of 2^-33, so neither 0 nor 1 occurs and the mean is unbiased.
/// - Stratification: both pairs of every aligned block of 2^m are (0, m, 2)-nets, with one sample in every elementary interval of area
///   2^-m. All four coordinates of the first 2^m are a (t, m, 4)-net with t <= 2 for m <= 6 and t <= 3 for m <= 14.
/// - Independence: each pixel and seed has its own scrambling, so (A - B)^2 / 4 of means over two seeds estimates the variance of (A + B) /
///   2 without bias. Halves of one sequence would overestimate it (not tested).
///
/// The order gives both pairs common strata, for blurs of about a pixel; shuffled pairs would be little better than random. Sobol's third
/// and fourth dimensions are no (0, m, 2)-net. The order was searched: its first seven bits minimise the error over random edges, discs,
/// checkers and sines at blurs of 0 to 50 pixels. Further bits maximise the elementary intervals with their share of samples.
///
/// Sources: B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020, without its shuffling of indices; I. M. Sobol', "On the
/// distribution of points in a cube and the approximate evaluation of integrals", USSR Comput. Math. Math. Phys. 7(4), 1967; the hash: N.
/// Vegdahl, "Building a Better LK Hash", 2021.

#ifndef TILT_LENS_SEQUENCE_H
#define TILT_LENS_SEQUENCE_H

#include <cstdint>

#include "tilt_lens/settings.h"

namespace tilt_lens
{

struct SequencePoint
{
    double lensU, lensV;
    double pixelX, pixelY;
};

/// One number per sample of a group.
using OfGroup = double[Settings::cameraRaysOfBatch];

struct SequencePoints
{
    OfGroup lensU, lensV, pixelX, pixelY;

    SequencePoint operator[](std::uint32_t i) const { return {lensU[i], lensV[i], pixelX[i], pixelY[i]}; }
};

struct Pair
{
    double u, v;
};

/// Finaliser of SplitMix64, a bijection (D. Stafford's variant 13 of MurmurHash3's).
inline std::uint64_t MixBits(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// Step of SplitMix64's counter: 2^64 over the golden ratio, odd.
constexpr std::uint64_t kGoldenStep = 0x9e3779b97f4a7c15u;

/// Cheap to make (a few hashes) and copy.
class PixelSampler
{
  public:
    /// @param x, y  in the whole picture
    /// @param seed  gives independent replicates
    PixelSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed);

    SequencePoint operator()(std::uint32_t index) const;

    void FindGroup(std::uint32_t index, SequencePoints& points) const;

    /// Two further coordinates of a sample, independent of its lens point and of pairs with another `number`: the shuffled lens sequence
    /// (Burley's padding).
    Pair PaddedPair(std::uint32_t index, std::uint32_t number) const;

    /// Uniform, independent of the samples; equals PixelHash(x, y, seed, salt).
    std::uint32_t Hash(std::uint32_t salt) const { return std::uint32_t(StreamWord(std::uint64_t{salt} + 3) >> 32); }

  private:
    std::uint64_t key;  ///< of (x, y, seed)
    std::uint32_t scrambleSeed[4];  ///< per dimension

    /// Words 1 and 2 scramble samples, later ones serve Hash().
    std::uint64_t StreamWord(std::uint64_t position) const { return MixBits(key + position * kGoldenStep); }
};

/// Different arguments give unrelated values.
std::uint32_t PixelHash(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t salt);

}  // namespace tilt_lens

#endif
