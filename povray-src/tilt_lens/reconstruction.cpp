// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "reconstruction.h"

#include <algorithm>
#include <vector>

namespace tilt_lens
{

namespace
{

constexpr int kSide = Surroundings::kSide, kBorder = Surroundings::kBorder, kReach = Surroundings::kReach;
constexpr int kCompared = int(kCell) + 2;  // side of the square in which single pixels are compared
constexpr int kRow = 12;                   // of which a row takes this much room, for vector registers

/// How different two pixels must be, in standard deviations of their difference, to count as different.
constexpr float kStrictness = 0.7f;

constexpr int At(int x, int y) { return (y + kBorder) * kSide + x + kBorder; }

/// exp(-max(0, x)) but for a hundredth, exactly 0 from 8 on; in a form that vector registers can do.
inline float Falloff(float x)
{
    float base = 1.0f - 0.125f * std::max(0.0f, x);
    base = std::max(0.0f, base);
    base *= base;
    base *= base;
    return base * base;
}

/// Distances of single pixels to those at an offset, summed over the channels that say anything.
void Compare(const Surroundings& around, const std::vector<int>& channels, int offset, float* distance)
{
    std::fill(distance, distance + kCompared * kRow, 0.0f);
    const float scale = 1.0f / (3.0f * kStrictness * kStrictness);  // three channels are usual
    for (const int c : channels)
    {
        const float* mean = around.Means()[c].data();
        const float* variance = around.Variances()[c].data();
        for (int y = 0; y < kCompared; y++)
        {
            const int row = At(-1, y - 1);
            float* out = distance + y * kRow;
            for (int x = 0; x < kCompared; x++)
            {
                const float p = mean[row + x], q = mean[row + x + offset];
                const float vp = variance[row + x], vq = variance[row + x + offset];
                const float unexplained = (p - q) * (p - q) - (vp + std::min(vp, vq));
                out[x] += scale * unexplained / (vp + vq + 1e-20f);
            }
        }
    }
}

/// Weights from the 3 by 3 means of the distances and the samples at both ends.
void Weigh(const Surroundings& around, const float* distance, int offset, float* weight)
{
    float rows[int(kCell) * kRow];
    for (int i = 0; i < int(kCell) * kRow; i++)
        rows[i] = distance[i] + distance[i + kRow] + distance[i + 2 * kRow];
    for (int y = 0; y < int(kCell); y++)
    {
        const float* samples = around.Samples().data() + At(0, y);
        for (int x = 0; x < int(kCell); x++)
        {
            const float* d = rows + y * kRow + x;
            const float known = std::min(samples[x], samples[x + offset]) / std::max(1.0f, samples[x]);
            weight[y * kCell + x] = known * Falloff((d[0] + d[1] + d[2]) / 9.0f);
        }
    }
}

void AddWeighted(const std::array<float, kSide * kSide>& values, int offset, const float* weight,
                 std::array<float, kCell * kCell>& sum)
{
    for (int y = 0; y < int(kCell); y++)
        for (int x = 0; x < int(kCell); x++)
            sum[y * kCell + x] += weight[y * kCell + x] * values[At(x, y) + offset];
}

/// Noise after filtering over noise before, each the mean square over the 5 by 5 pixels around.
std::array<float, kCell * kCell> Remains(const Surroundings& around, const std::vector<int>& channels,
                                         const std::array<std::array<float, kCell * kCell>, 5>& filtered)
{
    constexpr int side = int(kCell);
    float before[side * side] = {}, after[side * side] = {};
    for (const int c : channels)
        for (int y = 0; y < side; y++)
            for (int x = 0; x < side; x++)
            {
                const float plain = around.Halves()[c][At(x, y)], rebuilt = filtered[c][y * side + x];
                before[y * side + x] += plain * plain;
                after[y * side + x] += rebuilt * rebuilt;
            }
    std::array<float, kCell * kCell> remains;
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++)
        {
            float b = 0.0f, a = 0.0f;
            for (int v = std::max(0, y - 2); v <= std::min(side - 1, y + 2); v++)
                for (int u = std::max(0, x - 2); u <= std::min(side - 1, x + 2); u++)
                {
                    b += before[v * side + u];
                    a += after[v * side + u];
                }
            remains[y * side + x] = b > 0.0f ? std::min(1.0f, a / b + kLeastRemains) : 1.0f;
        }
    return remains;
}

} // namespace

void Surroundings::Set(int x, int y, const Estimate& estimate)
{
    const int i = At(x, y);
    for (std::size_t c = 0; c < mean.size(); c++)
    {
        mean[c][i] = estimate.mean[c];
        variance[c][i] = estimate.variance[c];
        halves[c][i] = estimate.halves[c];
    }
    samples[i] = estimate.samples;
}

bool Surroundings::Noiseless() const
{
    for (const auto& channel : variance)
        for (int y = 0; y < int(kCell); y++)
            for (int x = 0; x < int(kCell); x++)
                if (channel[At(x, y)] > 0.0f)
                    return false;
    return true;
}

Rebuilt Rebuild(const Surroundings& around, bool means)
{
    // a channel that is nothing everywhere, as filter and transmit are in most pictures, tells nothing
    std::vector<int> channels;
    for (int c = 0; c < 5; c++)
        if (std::any_of(around.Means()[c].begin(), around.Means()[c].end(), [](float x) { return x != 0.0f; }))
            channels.push_back(c);

    constexpr int pixels = int(kCell * kCell);
    Rebuilt sum{};
    std::array<std::array<float, pixels>, 5> halves{};
    float weights[pixels] = {}, distance[kCompared * kRow], weight[pixels];
    for (int dy = -kReach; dy <= kReach; dy++)
        for (int dx = -kReach; dx <= kReach; dx++)
        {
            const int offset = dy * kSide + dx;
            if (offset == 0)
                std::fill(weight, weight + pixels, 1.0f);
            else
            {
                Compare(around, channels, offset, distance);
                Weigh(around, distance, offset, weight);
            }
            for (int i = 0; i < pixels; i++)
                weights[i] += weight[i];
            for (const int c : channels)
            {
                AddWeighted(around.Halves()[c], offset, weight, halves[c]);
                if (means)
                    AddWeighted(around.Means()[c], offset, weight, sum.mean[c]);
            }
        }
    for (const int c : channels)
        for (int i = 0; i < pixels; i++)
        {
            halves[c][i] /= weights[i];
            sum.mean[c][i] /= weights[i];
        }
    sum.remains = Remains(around, channels, halves);
    return sum;
}

} // namespace tilt_lens
