// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lattice_noise.h
/// POV-Ray's noise of its generators 1 and 2, and its noise of vectors, for processors with AVX2: gradients at the corners of a
/// lattice's cell, blended (K. Perlin, "An Image Synthesizer", 1985). The operations of each number, and so its value to the last bit,
/// are those of POV-Ray's own functions; but three axes, three components, or four corners lie side by side.

#ifndef TILT_LENS_LATTICE_NOISE_H
#define TILT_LENS_LATTICE_NOISE_H

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

class LatticeNoise
{
  public:
    static constexpr int kHashes = 8192, kNumbers = 267;

    /// Makes this ready, if the processor can.
    /// @param itsHashes  a number up to 4095 for each of kHashes places; they outlive this
    /// @param numbers    kNumbers numbers, `stride` apart
    void SetTables(const unsigned short* itsHashes, const double* numbers, int stride);

    /// If not, the functions below cannot be called.
    bool Ready() const { return hashes != nullptr; }

    /// Noise between 0 and 1.
    /// @param point   three numbers
    /// @param wide    of generator 2, which uses the whole range; else that of generator 1
    double At(const double* point, bool wide) const;

    /// Noise of vectors.
    /// @param point, vector  three numbers each; may be the same
    void VectorAt(const double* point, double* vector) const;

  private:
    struct Cell;

    /// Where the numbers of a corner's gradient begin, four for each component.
    int Gradient(int hash, int z) const { return hashes[hash ^ z] & 0xFF; }

    const unsigned short* hashes = nullptr;
    double row[kNumbers];              ///< the numbers
    Double4 components[kNumbers - 8];  ///< three of them, four apart: those of the three components of a vector
};

} // namespace tilt_lens

#endif
