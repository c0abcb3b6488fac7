// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file scramble.h
/// Arithmetic on bits of the sample sequence (sequence.h).

#ifndef TILT_LENS_SCRAMBLE_H
#define TILT_LENS_SCRAMBLE_H

#include <cstdint>

#include "tilt_lens/math/simd.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// A group's points relative to its first, bits reversed.
struct GroupTable
{
    std::uint32_t value[4][Settings::cameraRaysOfBatch];
};

TILT_LENS_INLINED constexpr std::uint32_t ReverseBits(std::uint32_t x)
{
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Owen's nested uniform scrambling of a bit-reversed fraction (Vegdahl's hash).
TILT_LENS_INLINED std::uint32_t Scramble(std::uint32_t x, std::uint32_t seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// Middle of a 32-bit fraction's cell in (0, 1). Signed numbers convert faster; this flips the highest bit, which is random.
TILT_LENS_INLINED double ToUnit(std::uint32_t x)
{
    return static_cast<std::int32_t>(x) * 0x1p-32 + (0.5 + 0x1p-33);
}

} // namespace tilt_lens

#endif
