// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "reconstruction.h"

#include <algorithm>
#include <cstring>

namespace tilt_lens
{

namespace
{

constexpr int kSide = Surroundings::kSide, kBorder = Surroundings::kBorder, kReach = Surroundings::kReach;
constexpr int kPixels = int(kCell * kCell);
constexpr int kCompared = int(kCell) + 2;  // side of the square in which single pixels are compared
constexpr int kRow = 12;                   // of which a row takes this much room, for vector registers

/// Pixels farther than the square root of this are not averaged: the corners of the square bring little.
constexpr int kFarthest = 18;

/// Noisy pixels, all as noisy, from which on the noise that is left is known: of 25 some 8 count in even noise.
constexpr float kFewestNoisy = 3.0f;

using Plane = Surroundings::Plane;

constexpr int At(int x, int y) { return (y + kBorder) * kSide + x + kBorder; }

/// Four pixels of a row. What compilers make of plain loops over so short rows takes three times as long.
typedef float Four __attribute__((vector_size(16)));

inline Four Load(const float* from)
{
    Four four;
    std::memcpy(&four, from, sizeof(four));
    return four;
}

inline void Store(float* to, Four four) { std::memcpy(to, &four, sizeof(four)); }
inline Four Min(Four a, Four b) { return a < b ? a : b; }
inline Four Max(Four a, Four b) { return a > b ? a : b; }  // b if either is no number

/// exp(-max(0, x)) but for a hundredth, exactly 0 from 8 on and where x is no number.
inline Four Falloff(Four x)
{
    Four base = Max(1.0f - 0.125f * Max(Four(), x), Four());
    base *= base;
    base *= base;
    return base * base;
}

/// Distances of single pixels to those at an offset, from the row before the first to that after the last.
template<int kChannels>
void Compare(const Surroundings& around, const Rows& wanted, int offset, float* distance)
{
    for (int y = wanted.begin; y < wanted.end + 2; y++)
        for (int x = 0; x < kRow; x += 4)
        {
            const int i = At(x - 1, y - 1);
            Four squares = Four();
            for (int c = 0; c < kChannels; c++)
            {
                const Four difference = Load(&around.Means()[c][i]) - Load(&around.Means()[c][i + offset]);
                squares += difference * difference;
            }
            const Four p = Load(&around.Noise()[i]), q = Load(&around.Noise()[i + offset]);
            Store(distance + y * kRow + x, (squares - (p + Min(p, q))) / (p + q + 1e-20f));
        }
}

/// Weights from the 3 by 3 means of the distances and the samples at both ends.
void Weigh(const Surroundings& around, const Rows& wanted, const CellPlane& perSample, int offset, const float* distance,
           CellPlane& weight)
{
    float rows[int(kCell) * kRow];
    for (int i = wanted.begin * kRow; i < wanted.end * kRow; i += 4)
        Store(rows + i, Load(distance + i) + Load(distance + i + kRow) + Load(distance + i + 2 * kRow));
    const Four one = Four() + 1.0f;
    for (int y = wanted.begin; y < wanted.end; y++)
        for (int x = 0; x < int(kCell); x += 4)
        {
            const float* d = rows + y * kRow + x;
            const int i = y * kCell + x;
            const Four known = Min(one, Load(&around.Samples()[At(x, y) + offset]) * Load(&perSample[i]));
            Store(&weight[i], known * Falloff((Load(d) + Load(d + 1) + Load(d + 2)) / 9.0f));
        }
}

void AddWeighted(const Plane& values, const Rows& wanted, int offset, const CellPlane& weight, CellPlane& sum)
{
    for (int y = wanted.begin; y < wanted.end; y++)
        for (int x = 0; x < int(kCell); x += 4)
        {
            const int i = y * kCell + x;
            Store(&sum[i], Load(&sum[i]) + Load(&weight[i]) * Load(&values[At(x, y) + offset]));
        }
}

/// Noise after filtering over noise before, each the mean square over the 5 by 5 pixels around; 1 where too few of them
/// are noisy to tell.
CellPlane Remains(const Surroundings& around, const std::array<CellPlane, 5>& filtered, int channels)
{
    constexpr int side = int(kCell);
    CellPlane before{}, after{}, remains;
    for (int c = 0; c < channels; c++)
        for (int i = 0; i < kPixels; i++)
        {
            const float plain = around.Halves()[c][At(i % side, i / side)];
            before[i] += plain * plain;
            after[i] += filtered[c][i] * filtered[c][i];
        }
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++)
        {
            float b = 0.0f, a = 0.0f, squared = 0.0f;
            for (int v = std::max(0, y - 2); v <= std::min(side - 1, y + 2); v++)
                for (int u = std::max(0, x - 2); u <= std::min(side - 1, x + 2); u++)
                {
                    b += before[v * side + u];
                    squared += before[v * side + u] * before[v * side + u];
                    a += after[v * side + u];
                }
            const bool known = b * b > kFewestNoisy * squared;
            remains[y * side + x] = known ? std::min(1.0f, a / b + kLeastRemains) : 1.0f;
        }
    return remains;
}

template<int kChannels>
Rebuilt RebuildChannels(const Surroundings& around, bool means, const Rows& wanted)
{
    Rebuilt sum{};
    std::array<CellPlane, 5> halves{};
    CellPlane weights{}, weight, perSample;
    float distance[kCompared * kRow];
    for (int i = 0; i < kPixels; i++)
        perSample[i] = 1.0f / std::max(1.0f, around.Samples()[At(i % kCell, i / kCell)]);
    const auto add = [&](const Rows& rows, int offset)
    {
        for (int i = rows.begin * int(kCell); i < rows.end * int(kCell); i++)
            weights[i] += weight[i];
        for (int c = 0; c < kChannels; c++)
        {
            AddWeighted(around.Halves()[c], rows, offset, weight, halves[c]);
            if (means)
                AddWeighted(around.Means()[c], rows, offset, weight, sum.mean[c]);
        }
    };
    weight.fill(1.0f);
    add(Rows(), 0);
    for (int dy = -kReach; dy <= kReach; dy++)
        for (int dx = -kReach; dx <= kReach; dx++)
        {
            const int offset = dy * kSide + dx;
            if (offset == 0 || dx * dx + dy * dy > kFarthest)
                continue;
            Compare<kChannels>(around, wanted, offset, distance);
            Weigh(around, wanted, perSample, offset, distance, weight);
            add(wanted, offset);
        }
    for (int c = 0; c < kChannels; c++)
        for (int i = 0; i < kPixels; i++)
        {
            halves[c][i] /= weights[i];
            sum.mean[c][i] /= weights[i];
        }
    sum.remains = Remains(around, halves, kChannels);
    return sum;
}

} // namespace

Surroundings::Surroundings(bool complete)
{
    if (complete)
        return;
    mean.fill({});
    halves.fill({});
    noise.fill(0.0f);
    samples.fill(0.0f);
}

void Surroundings::Set(int x, int y, const Estimate& estimate)
{
    const int i = At(x, y);
    float sum = 0.0f;
    for (std::size_t c = 0; c < mean.size(); c++)
    {
        mean[c][i] = estimate.mean[c];
        halves[c][i] = estimate.halves[c];
        sum += estimate.variance[c];
    }
    noise[i] = sum;
    samples[i] = estimate.samples;
    transparent = transparent || estimate.mean[3] != 0.0f || estimate.mean[4] != 0.0f;
}

Radiance Rebuilt::MeanOf(std::size_t pixel) const
{
    Radiance light;
    for (std::size_t c = 0; c < light.size(); c++)
        light[c] = mean[c][pixel];
    return light;
}

Rebuilt Rebuild(const Surroundings& around, bool means, const Rows& rows)
{
    return around.Transparent() ? RebuildChannels<5>(around, means, rows) : RebuildChannels<3>(around, means, rows);
}

} // namespace tilt_lens
