// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file partly_covered.h
/// Vignetted apertures: a random lens point replaces a covered one.

#ifndef TILT_LENS_PARTLY_COVERED_H
#define TILT_LENS_PARTLY_COVERED_H

#include <cstdint>
#include <random>

namespace tilt_lens
{

/// With half of the aperture covered, one sample in 2^65 finds no open point.
constexpr int kTries = 64;

/// Less would need too long an exposure.
constexpr double kLeastOpen = 0.01;

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
