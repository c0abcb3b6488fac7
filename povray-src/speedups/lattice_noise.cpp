// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "speedups/lattice_noise.h"

#include <cstring>

/// GCC 11 lacks the builtin.
#if __has_builtin(__builtin_shufflevector)
#define TILT_LENS_CHOOSE(a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define TILT_LENS_CHOOSE(a, b, ...) __builtin_shuffle(a, b, LongMask4{__VA_ARGS__})
#endif

namespace speedups
{

struct LatticeNoise::Cell
{
    Double4 from, to;     ///< relative to the lower corner, and to the upper one
    Double4 weights[2];   ///< four corners at near z, at far z; x varies fastest
    int gradients[2][4];

    TILT_LENS_INLINED Cell(const LatticeNoise& noise, const double* point)
    {
        const double almostOne = 1.0 - 1e-10;     // 1 - EPSILON
        const int shift = 10000, mask = 0xFFF;    // MINX, MINY, MINZ
        const Double4 at = {point[0], point[1], point[2], 0.0};
        const Mask4 whole = __builtin_convertvector(at >= 0.0 ? at : at - almostOne, Mask4);
        const Mask4 lattice = (whole + shift) & mask;
        const Double4 part = at - __builtin_convertvector(whole, Double4);
        const Double4 far = part * part * (3.0 - 2.0 * part), near = 1.0 - far;
        from = part;
        to = part - 1.0;

        const Double4 x = {near[0], far[0], near[0], far[0]}, y = {near[1], near[1], far[1], far[1]};
        weights[0] = x * y * near[2];
        weights[1] = x * y * far[2];

        const int z = lattice[2];
        for (int i = 0; i < 4; i++)
        {
            const int hash = noise.hashes[noise.hashes[lattice[0] + i % 2] ^ (lattice[1] + i / 2)];
            gradients[0][i] = noise.Gradient(hash, z);
            gradients[1][i] = noise.Gradient(hash, z + 1);
        }
    }
};

void LatticeNoise::SetTables(const unsigned short* itsHashes, const double* numbers, int stride)
{
    hashes = HasAvx2() ? itsHashes : nullptr;
    for (int i = 0; i < kNumbers; i++)
        row[i] = numbers[i * stride];
    for (int i = 0; i < kNumbers - 8; i++)
        components[i] = Double4{row[i], row[i + 4], row[i + 8], 0.0};
}

TILT_LENS_FOR_AVX2 double LatticeNoise::At(const double* point, bool wide) const
{
    const Cell cell(*this, point);
    const Double4 x = {cell.from[0], cell.to[0], cell.from[0], cell.to[0]}, y = {cell.from[1], cell.from[1], cell.to[1], cell.to[1]};
    double sum = 0.0;
    for (int level = 0; level < 2; level++)
    {
        const double z = (level == 0 ? cell.from : cell.to)[2];
        const int* const gradients = cell.gradients[level];
        const auto numbers = [&](int i) TILT_LENS_FOR_AVX2 -> Double4
        {
            Double4 corner;  // clang forbids returning such a register from a function without AVX
            std::memcpy(&corner, row + gradients[i], sizeof(corner));
            return corner;
        };
        const Double4 a = numbers(0), b = numbers(1), c = numbers(2), d = numbers(3);
        const Double4 ab0 = TILT_LENS_CHOOSE(a, b, 0, 4, 2, 6), ab1 = TILT_LENS_CHOOSE(a, b, 1, 5, 3, 7);
        const Double4 cd0 = TILT_LENS_CHOOSE(c, d, 0, 4, 2, 6), cd1 = TILT_LENS_CHOOSE(c, d, 1, 5, 3, 7);
        const Double4 first = TILT_LENS_CHOOSE(ab0, cd0, 0, 1, 4, 5), second = TILT_LENS_CHOOSE(ab1, cd1, 0, 1, 4, 5);
        const Double4 third = TILT_LENS_CHOOSE(ab0, cd0, 2, 3, 6, 7), fourth = TILT_LENS_CHOOSE(ab1, cd1, 2, 3, 6, 7);
        const Double4 corners = cell.weights[level] * (first * 0.5 + second * x + third * y + fourth * z);
        sum = level == 0 ? corners[0] : sum + corners[0];
        sum = sum + corners[1] + corners[2] + corners[3];
    }
    if (wide)
    {
        sum += 1.05242;
        sum *= 0.48985582;
    }
    else
        sum = sum + 0.5;
    if (sum < 0.0)
        sum = 0.0;
    if (sum > 1.0)
        sum = 1.0;
    return sum;
}

TILT_LENS_FOR_AVX2 void LatticeNoise::VectorAt(const double* point, double* vector) const
{
    const Cell cell(*this, point);
    const auto corner = [&](int level, int i) TILT_LENS_FOR_AVX2
    {
        const Double4* const numbers = components + cell.gradients[level][i];
        const double x = (i % 2 == 0 ? cell.from : cell.to)[0], y = (i < 2 ? cell.from : cell.to)[1];
        const double z = (level == 0 ? cell.from : cell.to)[2];
        return cell.weights[level][i] * (numbers[0] * 0.5 + numbers[1] * x + numbers[2] * y + numbers[3] * z);
    };
    // POV-Ray's order of addition
    const Double4 sum = corner(0, 0) + corner(0, 1) + corner(0, 3) + corner(0, 2) + corner(1, 2) + corner(1, 3) + corner(1, 1) +
                        corner(1, 0);
    for (int i = 0; i < 3; i++)
        vector[i] = sum[i];
}

} // namespace speedups
