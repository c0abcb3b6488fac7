// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lattice_noise.h
/// POV-Ray's noise (K. Perlin, "An Image Synthesizer", 1985) for AVX2. POV-Ray's operations keep their order, so results are equal to the
/// last bit.

#ifndef SPEEDUPS_LATTICE_NOISE_H
#define SPEEDUPS_LATTICE_NOISE_H

#include "tilt_lens/math/simd.h"

namespace speedups
{

using namespace tilt_lens;

class LatticeNoise
{
  public:
    static constexpr int kHashes = 8192, kNumbers = 267;

    /// Has no effect without AVX2.
    /// @param itsHashes  kHashes numbers up to 4095; must outlive this object
    /// @param numbers    kNumbers numbers, `stride` apart
    void SetTables(const unsigned short* itsHashes, const double* numbers, int stride);

    /// If false, call neither At() nor VectorAt().
    bool Ready() const { return hashes != nullptr; }

    /// @param wide  generator 2; else generator 1
    /// @return      in [0, 1]
    double At(const double* point, bool wide) const;

    /// @param point, vector  may be the same array
    void VectorAt(const double* point, double* vector) const;

  private:
    struct Cell;

    int Gradient(int hash, int z) const { return hashes[hash ^ z] & 0xFF; }

    const unsigned short* hashes = nullptr;
    double row[kNumbers];
    Double4 components[kNumbers - 8];  ///< row[i], row[i + 4], row[i + 8]
};

} // namespace speedups

#endif
