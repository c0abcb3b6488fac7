// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file partly_covered.h
/// What holds for every aperture that rims cover a part of: a point that is covered is drawn again from random numbers.

#ifndef TILT_LENS_PARTLY_COVERED_H
#define TILT_LENS_PARTLY_COVERED_H

#include <cstdint>
#include <random>

namespace tilt_lens
{

/// Random points that are tried where the sequence's own is covered. Where half is covered, one sample in 2^65 finds nothing.
constexpr int kTries = 64;

/// Less open than this in the middle of the picture is refused: the exposure would have to make up for it.
constexpr double kLeastOpen = 0.01;

/// Uniform numbers between 0 and 1 for these points.
class UniformNumbers
{
  public:
    explicit UniformNumbers(std::uint32_t seed) : engine(seed) {}

    double operator()() { return (engine() - 0.5) / (engine.max() + 1.0); }

  private:
    std::minstd_rand engine;
};

} // namespace tilt_lens

#endif
