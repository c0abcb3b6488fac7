// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "lens_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace witness
{

namespace
{

const double kPi = std::acos(-1.0);

/// Direction numbers (Joe and Kuo 2008).
std::array<std::uint32_t, 32> Directions(int degree, std::uint32_t coefficients, std::array<std::uint32_t, 3> m)
{
    std::array<std::uint32_t, 32> v{};
    if (degree == 0)
    {
        for (int i = 0; i < 32; ++i)
            v[i] = 1u << (31 - i);
        return v;
    }
    for (int i = 0; i < degree; ++i)
        v[i] = m[i] << (31 - i);
    for (int i = degree; i < 32; ++i)
    {
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (int j = 1; j < degree; ++j)
            if ((coefficients >> (degree - 1 - j)) & 1u)
                v[i] ^= v[i - j];
    }
    return v;
}

std::uint64_t Mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

/// Owen scrambling: a hash of all digits before it flips a digit.
std::uint32_t Scrambled(std::uint32_t value, std::uint64_t seed)
{
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit)
    {
        const std::uint64_t before = bit == 0 ? 0u : value >> (32 - bit);
        const std::uint32_t flip = Mixed(Mixed(seed + static_cast<std::uint64_t>(bit)) ^ before) & 1u;
        result |= (((value >> (31 - bit)) & 1u) ^ flip) << (31 - bit);
    }
    return result;
}

void OnDisc(double u, double v, LensPoint& point)
{
    const double radius = std::sqrt(u), angle = 2.0 * kPi * v;
    point.a = radius * std::cos(angle);
    point.b = radius * std::sin(angle);
}

void OnPolygon(double u, double v, int blades, double degrees, LensPoint& point)
{
    const double sector = std::min(std::floor(v * blades), blades - 1.0);
    const double along = v * blades - sector, outward = std::sqrt(u);
    const double turn = 2.0 * kPi / blades, start = degrees * kPi / 180.0 + sector * turn;
    point.a = outward * ((1.0 - along) * std::cos(start) + along * std::cos(start + turn));
    point.b = outward * ((1.0 - along) * std::sin(start) + along * std::sin(start + turn));
}

} // namespace

std::vector<LensPoint> LensPoints(std::uint32_t count, std::uint32_t seed, int blades, double bladesAngle)
{
    const std::array<std::array<std::uint32_t, 32>, 4> directions = {Directions(0, 0, {}), Directions(1, 0, {1}), Directions(2, 1, {1, 3}),
                                                                     Directions(3, 1, {1, 3, 1})};
    std::vector<LensPoint> points(count);
    for (std::uint32_t index = 0; index < count; ++index)
    {
        double u[4];
        for (int dimension = 0; dimension < 4; ++dimension)
        {
            std::uint32_t value = 0;
            for (int bit = 0; bit < 32; ++bit)
                if ((index >> bit) & 1u)
                    value ^= directions[dimension][bit];
            const std::uint64_t key = Mixed((static_cast<std::uint64_t>(seed) << 8) + dimension);
            u[dimension] = (Scrambled(value, key) + 0.5) * 0x1p-32;
        }
        LensPoint& point = points[index];
        point.jitterX = u[0] - 0.5;
        point.jitterY = u[1] - 0.5;
        if (blades == 0)
            OnDisc(u[2], u[3], point);
        else
            OnPolygon(u[2], u[3], blades, bladesAngle, point);
    }
    return points;
}

} // namespace witness
