// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "sampler.h"

namespace tilt_lens
{

namespace
{

constexpr int dimensions = 4;
constexpr int bits = 32;

/// One 32-bit fraction for each dimension, side by side so that compilers use vector registers.
struct alignas(16) Lanes
{
    std::uint32_t value[dimensions];
};

constexpr std::uint32_t ReverseBits(std::uint32_t x)
{
    x = (x << 16) | (x >> 16);
    x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// A primitive polynomial over GF(2) and initial direction numbers, in the notation of Joe and Kuo.
struct Polynomial
{
    int degree;
    std::uint32_t coefficients;
    std::uint32_t initial[3];
};

/// The second to fourth lines of new-joe-kuo-6. The first dimension, van der Corput's sequence, has
/// no polynomial.
constexpr Polynomial polynomials[dimensions - 1] = {
    {1, 0, {1, 0, 0}}, {2, 1, {1, 3, 0}}, {3, 1, {1, 3, 1}}};

/// The direction numbers of one dimension, highest bit first.
struct Directions
{
    std::uint32_t v[bits];
};

constexpr Directions MakeDirections(int dimension)
{
    Directions d{};
    if (dimension == 0)
    {
        for (int i = 0; i < bits; ++i)
            d.v[i] = 1u << (bits - 1 - i);
        return d;
    }
    const Polynomial& p = polynomials[dimension - 1];
    for (int i = 0; i < bits; ++i)
    {
        if (i < p.degree)
        {
            d.v[i] = p.initial[i] << (bits - 1 - i);
            continue;
        }
        d.v[i] = d.v[i - p.degree] ^ (d.v[i - p.degree] >> p.degree);
        for (int k = 1; k < p.degree; ++k)
            if ((p.coefficients >> (p.degree - 1 - k)) & 1u)
                d.v[i] ^= d.v[i - k];
    }
    return d;
}

/// What each hexadecimal digit of the index adds to the Sobol point. Bits are reversed, lowest
/// first: the scrambling hash wants them so. 2 KiB, since the renderer needs the cache for its
/// scene; a table of bytes would take eight times as much.
struct DigitTable
{
    Lanes entry[bits / 4][16];
};

constexpr DigitTable MakeDigitTable()
{
    DigitTable table{};
    for (int dim = 0; dim < dimensions; ++dim)
    {
        const Directions directions = MakeDirections(dim);
        for (int place = 0; place < bits / 4; ++place)
            for (int digit = 0; digit < 16; ++digit)
                for (int bit = 0; bit < 4; ++bit)
                    if ((digit >> bit) & 1)
                        table.entry[place][digit].value[dim] ^=
                            ReverseBits(directions.v[4 * place + bit]);
    }
    return table;
}

constexpr DigitTable digitTable = MakeDigitTable();

/// A bijection of 64-bit words without visible structure: the finaliser of SplitMix64 (D.
/// Stafford's variant 13 of MurmurHash3's).
std::uint64_t Mix(std::uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// The step of SplitMix64's counter: 2^64 over the golden ratio, odd.
constexpr std::uint64_t goldenStep = 0x9e3779b97f4a7c15u;

/// Two rounds, so that no pixel of one seed is a pixel of another.
std::uint64_t PixelKey(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
{
    const std::uint64_t pixel = (std::uint64_t{y} << 32) | x;
    return Mix(pixel ^ Mix((std::uint64_t{seed} + 1) * goldenStep));
}

/// The stream of a key. Words 1 and 2 scramble the samples, the later ones serve Hash().
std::uint64_t StreamWord(std::uint64_t key, std::uint64_t position)
{
    return Mix(key + position * goldenStep);
}

std::uint32_t StreamHash(std::uint64_t key, std::uint32_t salt)
{
    return static_cast<std::uint32_t>(StreamWord(key, std::uint64_t{salt} + 3) >> 32);
}

/// Owen's nested uniform scrambling of a bit-reversed fraction: a bit is flipped or not depending
/// on the seed and the bits below it (Vegdahl's hash).
inline std::uint32_t Scramble(std::uint32_t x, std::uint32_t seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

/// From a 32-bit fraction to the middle of its cell in (0, 1). Read as a signed number, since
/// processors convert those faster; that flips the highest bit, which the scrambling made random.
inline double ToUnit(std::uint32_t x)
{
    return static_cast<std::int32_t>(x) * 0x1p-32 + (0.5 + 0x1p-33);
}

}  // namespace

PixelSampler::PixelSampler(std::uint32_t x, std::uint32_t y, std::uint32_t seed)
    : key(PixelKey(x, y, seed))
{
    const std::uint64_t lens = StreamWord(key, 1), pixel = StreamWord(key, 2);
    scrambleSeed[0] = static_cast<std::uint32_t>(lens);
    scrambleSeed[1] = static_cast<std::uint32_t>(lens >> 32);
    scrambleSeed[2] = static_cast<std::uint32_t>(pixel);
    scrambleSeed[3] = static_cast<std::uint32_t>(pixel >> 32);
}

Sample PixelSampler::operator()(std::uint32_t index) const
{
    Lanes point{};
    for (int place = 0; index != 0; ++place, index >>= 4)
        for (int dim = 0; dim < dimensions; ++dim)
            point.value[dim] ^= digitTable.entry[place][index & 15u].value[dim];

    for (int dim = 0; dim < dimensions; ++dim)
        point.value[dim] = Scramble(point.value[dim], scrambleSeed[dim]);
    for (int dim = 0; dim < dimensions; ++dim)
        point.value[dim] = ReverseBits(point.value[dim]);

    return {ToUnit(point.value[0]), ToUnit(point.value[1]), ToUnit(point.value[2]),
            ToUnit(point.value[3])};
}

Pair PixelSampler::Further(std::uint32_t index, std::uint32_t number) const
{
    const std::uint64_t seeds = StreamWord(key, (std::uint64_t{number} << 32) + 1);
    // an order in which each block of 2^k samples stays one
    index = ReverseBits(Scramble(ReverseBits(index), StreamHash(key, ~number)));
    std::uint32_t u = 0, v = 0;
    for (int place = 0; index != 0; ++place, index >>= 4)
    {
        u ^= digitTable.entry[place][index & 15u].value[0];
        v ^= digitTable.entry[place][index & 15u].value[1];
    }
    return {ToUnit(ReverseBits(Scramble(u, std::uint32_t(seeds)))),
            ToUnit(ReverseBits(Scramble(v, std::uint32_t(seeds >> 32))))};
}

std::uint32_t PixelSampler::Hash(std::uint32_t salt) const
{
    return StreamHash(key, salt);
}

std::uint32_t PixelHash(std::uint32_t x, std::uint32_t y, std::uint32_t seed, std::uint32_t salt)
{
    return StreamHash(PixelKey(x, y, seed), salt);
}

}  // namespace tilt_lens
