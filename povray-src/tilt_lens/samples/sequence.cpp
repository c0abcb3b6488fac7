// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/sequence.h"

#include "tilt_lens/math/kernels.h"
#include "tilt_lens/samples/scramble.h"

namespace tilt_lens
{

namespace
{

constexpr int dimensions = 4;
constexpr int bits = 32;

/// One 32-bit fraction per dimension, adjacent for vector registers.
struct alignas(16) Lanes
{
    std::uint32_t value[dimensions];
};

/// Direction numbers of Sobol's first two dimensions, highest bit first: van der Corput's, and those of x + 1.
struct Directions
{
    std::uint32_t v[bits];
};

constexpr Directions MakeDirections(int dimension)
{
    Directions d{};
    for (int i = 0; i < bits; ++i)
    {
        const std::uint32_t own = 1u << (bits - 1 - i);
        d.v[i] = dimension == 0 || i == 0 ? own : d.v[i - 1] ^ (d.v[i - 1] >> 1);
    }
    return d;
}

/// Order of the pixel pair: bit i of the index toggles the bits kOrder[i] of its point's index. The highest is bit i, so the first 2^m
/// points stay the first.
// clang-format off
constexpr std::uint32_t kOrder[bits] = {
    0x1u, 0x3u, 0x6u, 0xdu, 0x11u, 0x22u, 0x44u, 0x89u,
    0x1b2u, 0x36eu, 0x67du, 0xdd6u, 0x1837u, 0x3f50u, 0x4ac5u, 0xf917u,
    0x19c80u, 0x20c2bu, 0x71ee5u, 0x8e386u, 0x14bfa5u, 0x3a2c59u, 0x4db1e9u, 0xe98bb7u,
    0x1c16e6fu, 0x2befe92u, 0x4539d5eu, 0x821da0fu, 0x103d246eu, 0x374e88b6u, 0x5327f921u, 0xc16c6c80u};
// clang-format on

constexpr Directions Ordered(const Directions& directions)
{
    Directions ordered{};
    for (int i = 0; i < bits; ++i)
        for (int j = 0; j <= i; ++j)
            if ((kOrder[i] >> j) & 1)
                ordered.v[i] ^= directions.v[j];
    return ordered;
}

/// Each hexadecimal digit's part of the Sobol point, bits reversed for the scrambling hash. The scene needs the cache: 2 KiB, a table by
/// bytes would take 16.
struct DigitTable
{
    Lanes entry[bits / 4][16];
};

constexpr DigitTable MakeDigitTable()
{
    DigitTable table{};
    for (int dim = 0; dim < dimensions; ++dim)
    {
        const Directions lens = MakeDirections(dim % 2), directions = dim < 2 ? lens : Ordered(lens);
        for (int place = 0; place < bits / 4; ++place)
            for (int digit = 0; digit < 16; ++digit)
                for (int bit = 0; bit < 4; ++bit)
                    if ((digit >> bit) & 1)
                        table.entry[place][digit].value[dim] ^= ReverseBits(directions.v[4 * place + bit]);
    }
    return table;
}

constexpr DigitTable digitTable = MakeDigitTable();

constexpr GroupTable MakeGroupTable()
{
    static_assert(16 % Settings::cameraRaysOfBatch == 0, "a group lies within the first digit");
    GroupTable table{};
    for (int dim = 0; dim < dimensions; ++dim)
        for (std::uint32_t i = 0; i < Settings::cameraRaysOfBatch; ++i)
            table.value[dim][i] = digitTable.entry[0][i].value[dim];
    return table;
}

constexpr GroupTable groupTable = MakeGroupTable();

/// Two rounds of mixing, so that no pixel of one seed equals a pixel of another.
std::uint64_t PixelKey(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    const std::uint64_t pixel = (std::uint64_t{y} << 32) | x;
    return MixBits(pixel ^ MixBits((std::uint64_t{seed} + 1) * kGoldenStep));
}

inline Lanes SobolPoint(std::uint32_t index)
{
    Lanes point{};
    for (int place = 0; index != 0; ++place, index >>= 4)
        for (int dim = 0; dim < dimensions; ++dim)
            point.value[dim] ^= digitTable.entry[place][index & 15u].value[dim];
    return point;
}

} // namespace

PixelSampler::PixelSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed) : key(PixelKey(x, y, seed))
{
    const std::uint64_t lens = StreamWord(1), pixel = StreamWord(2);
    scrambleSeed[0] = static_cast<std::uint32_t>(lens);
    scrambleSeed[1] = static_cast<std::uint32_t>(lens >> 32);
    scrambleSeed[2] = static_cast<std::uint32_t>(pixel);
    scrambleSeed[3] = static_cast<std::uint32_t>(pixel >> 32);
}

SequencePoint PixelSampler::operator()(std::uint32_t index) const
{
    Lanes point = SobolPoint(index);
    for (int dim = 0; dim < dimensions; ++dim)
        point.value[dim] = Scramble(point.value[dim], scrambleSeed[dim]);
    for (int dim = 0; dim < dimensions; ++dim)
        point.value[dim] = ReverseBits(point.value[dim]);

    return {ToUnit(point.value[0]), ToUnit(point.value[1]), ToUnit(point.value[2]), ToUnit(point.value[3])};
}

void PixelSampler::FindGroup(std::uint32_t index, SequencePoints& points) const
{
    kernels->findPoints(SobolPoint(index - index % Settings::cameraRaysOfBatch).value, scrambleSeed, groupTable, points);
}

Pair PixelSampler::PaddedPair(std::uint32_t index, std::uint32_t number) const
{
    const std::uint64_t seeds = StreamWord((std::uint64_t{number} << 32) + 1);
    // a permutation that maps each aligned block of 2^k samples onto one
    index = ReverseBits(Scramble(ReverseBits(index), Hash(~number)));
    std::uint32_t u = 0, v = 0;
    for (int place = 0; index != 0; ++place, index >>= 4)
    {
        u ^= digitTable.entry[place][index & 15u].value[0];
        v ^= digitTable.entry[place][index & 15u].value[1];
    }
    return {ToUnit(ReverseBits(Scramble(u, std::uint32_t(seeds)))), ToUnit(ReverseBits(Scramble(v, std::uint32_t(seeds >> 32))))};
}

std::uint32_t PixelHash(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t salt)
{
    return PixelSampler(x, y, seed).Hash(salt);
}

} // namespace tilt_lens
