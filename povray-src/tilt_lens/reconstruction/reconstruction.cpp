// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/reconstruction.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

constexpr int kColumns = Surroundings::kColumns, kReach = Surroundings::kReach, kJudged = Surroundings::kJudged;
constexpr int kSide = int(kCell);
constexpr int kPixels = kSide * kSide;

/// A difference of this share of a pixel's brightness, squared, counts as little as its noise does.
constexpr float kFaint = 0.003f;

/// The least risk, as a share of that of the picture as it is: less is chance.
constexpr float kLeastRisk = 0.05f;

/// A filter whose risk is so many times that of the picture as it is gets no weight at all.
constexpr float kMostRisk = 20.0f;

/// Of an error that stands out of the noise so far, no more counts for pixels that are not beside it.
constexpr float kLimit = 8.0f;

/// Beside a pixel, and what the risk of so few pixels may be by chance, as a share of that of the picture as it is.
constexpr int kBeside = 1;
constexpr float kChance = 2.0f;

/// What a pixel's risk is taken for where it is more, or no number.
constexpr float kHuge = 1e12f;

/// Noisy pixels, all as noisy, from which on the noise that is left is known: of 25 some 8 count in even noise.
constexpr float kFewestNoisy = 3.0f;

using Plane = Surroundings::Plane;

constexpr int At(int x, int y) { return Surroundings::At(x, y); }

/// Four pixels of a row. What compilers make of plain loops over so short rows takes three times as long.
typedef float Four __attribute__((vector_size(16)));

inline Four Min(Four a, Four b) { return a < b ? a : b; }  // b if either is no number
inline Four Max(Four a, Four b) { return a > b ? a : b; }  // the same

/// What is done to pixels of a row or of a column: nothing, a parabola fitted to 5 or 9 of them, the mean of 9, or of the
/// pixel and 4 on one side of it, where there is an edge on the other.
enum Filter { kNone, kFit5, kFit9, kMean9, kAhead5, kBehind5, kFilters };

/// Taps from the middle one to one end, or to both.
constexpr float kTaps[kFilters][kReach + 1] = {
    {1.0f},
    {17.0f / 35, 12.0f / 35, -3.0f / 35},
    {59.0f / 231, 54.0f / 231, 39.0f / 231, 14.0f / 231, -21.0f / 231},
    {1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9, 1.0f / 9},
    {0.2f, 0.2f, 0.2f, 0.2f, 0.2f},
    {0.2f, 0.2f, 0.2f, 0.2f, 0.2f},
};

/// The bank: what is done across and what is done down.
constexpr Filter kBank[][2] = {
    {kNone, kNone}, {kFit5, kNone}, {kNone, kFit5}, {kFit5, kFit5},
    {kFit9, kNone}, {kNone, kFit9}, {kFit9, kFit9}, {kFit5, kFit9}, {kFit9, kFit5},
    {kMean9, kNone}, {kNone, kMean9}, {kMean9, kMean9}, {kMean9, kFit5}, {kFit5, kMean9},
    {kAhead5, kNone}, {kBehind5, kNone}, {kNone, kAhead5}, {kNone, kBehind5},
};

/// Four neighbouring pixels filtered along steps of 1 (a row) or kColumns (a column).
template<Filter kFilter>
Four Filtered(const float* at, int step)
{
    constexpr int reach = kFilter == kNone ? 0 : kFilter == kFit5 ? 2 : kReach;
    Four sum = kTaps[kFilter][0] * Load<Four>(at);
    for (int i = 1; i <= reach; i++)
    {
        if (kFilter == kAhead5 || kFilter == kBehind5)
            sum += kTaps[kFilter][i] * Load<Four>(at + (kFilter == kAhead5 ? i : -i) * step);
        else
            sum += kTaps[kFilter][i] * (Load<Four>(at - i * step) + Load<Four>(at + i * step));
    }
    return sum;
}

/// Pixels that something is wanted of: `margin` more than the wanted rows on all sides.
struct Part
{
    int left, right, top, bottom;

    Part(const Rows& rows, int margin) :
        left(-margin), right(kSide + margin), top(rows.begin - margin), bottom(rows.end + margin)
    {
    }

    /// Calls with the place of each four pixels; the last ones of a row may lie beyond it.
    template<class Visit>
    void ForEachFour(const Visit& visit) const
    {
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x += 4)
                visit(At(x, y));
    }
};

/// Means over the pixels around each that is wanted, as far as `kFar` from it.
template<int kFar>
void MeanAround(const Plane& values, const Rows& rows, Plane& means)
{
    constexpr float share = 1.0f / ((2 * kFar + 1) * (2 * kFar + 1));
    float column[kColumns];
    for (int y = rows.begin; y < rows.end; y++)
    {
        for (int x = -kFar; x < kSide + kFar; x += 4)
        {
            Four sum = Four();
            for (int dy = -kFar; dy <= kFar; dy++)
                sum += Load<Four>(&values[At(x, y + dy)]);
            Store(column + x + kFar, sum);
        }
        for (int x = 0; x < kSide; x += 4)
        {
            Four sum = Four();
            for (int dx = 0; dx <= 2 * kFar; dx++)
                sum += Load<Four>(column + x + dx);
            Store(&means[At(x, y)], share * sum);
        }
    }
}

/// The mean of what filters make of a cell, weighted by their risks.
template<int kChannels>
class Mixture
{
  public:
    Mixture(const Surroundings& around, const Rows& rows) :
        around(around), rows(rows), judged(rows, kJudged), wanted(rows, 0)
    {
        const Four least = Four() + 1e-30f, most = Four() + 1e30f;
        judged.ForEachFour([&](int i)
        {
            Four light = Four();
            for (int c = 0; c < kChannels; c++)
                light += Load<Four>(&around.Means()[c][i]) * Load<Four>(&around.Means()[c][i]);
            const Four variance = Min(Load<Four>(&around.Noise()[i]), most);
            const Four unit = 1.0f / (variance + kFaint * light + least);
            Store(&units[i], unit);
            Store(&noises[i], unit * variance);
        });
        MeanAround<kJudged>(noises, rows, noiseAround);
        MeanAround<kBeside>(noises, rows, noiseBeside);
        Across<kFit5>();
        Across<kFit9>();
        Across<kMean9>();
        Across<kAhead5>();
        Across<kBehind5>();
    }

    template<Filter kAcross, Filter kDown>
    void Add()
    {
        const float noiseTaken = 1.0f - 2.0f * kTaps[kAcross][0] * kTaps[kDown][0];
        judged.ForEachFour([&](int i)
        {
            Four squares = Four();
            for (int c = 0; c < kChannels; c++)
            {
                const Four difference = Filtered<kDown>(&Means(kAcross)[c][i], kColumns) - Load<Four>(&around.Means()[c][i]);
                squares += difference * difference;
            }
            const Four noise = Load<Four>(&noises[i]), all = squares * Load<Four>(&units[i]) - noiseTaken * noise;
            const Four whole = Min(all, Four() + kHuge);
            Store(&risk[i], whole);
            Store(&limited[i], Min(whole, kLimit * noise));
        });
        MeanAround<kJudged>(limited, rows, riskAround);
        MeanAround<kBeside>(risk, rows, riskBeside);
        wanted.ForEachFour([&](int i)
        {
            const Four before = Load<Four>(&noiseAround[i]);
            const Four beside = Load<Four>(&riskBeside[i]) - kChance * Load<Four>(&noiseBeside[i]);
            const Four after = Max(Max(Load<Four>(&riskAround[i]), beside), kLeastRisk * before + 1e-30f);
            const Four root = Max(before / after - 1.0f / kMostRisk, Four()), weight = root * root;
            Store(&weights[i], Load<Four>(&weights[i]) + weight);
            for (int c = 0; c < kChannels; c++)
            {
                Store(&means[c][i], Load<Four>(&means[c][i]) + weight * Filtered<kDown>(&Means(kAcross)[c][i], kColumns));
                Store(&halves[c][i], Load<Four>(&halves[c][i]) + weight * Filtered<kDown>(&Halves(kAcross)[c][i], kColumns));
            }
        });
    }

    /// Of a pixel of the cell: its mean, and its halves' difference. Pixels among such as have no noise stay.
    float MeanOf(int c, int i) const
    {
        const float own = around.Means()[c][i];
        if (!(weights[i] > 0.0f))
            return own;
        // parabolas reach beyond what they are fitted to: colours are not negative for it, and no transparency is above 1
        const float mean = std::max(means[c][i] / weights[i], std::min(0.0f, own));
        return c < 3 ? mean : std::min(mean, std::max(1.0f, own));
    }
    float HalvesOf(int c, int i) const { return weights[i] > 0.0f ? halves[c][i] / weights[i] : around.Halves()[c][i]; }

  private:
    const Surroundings& around;
    const Rows rows;
    const Part judged, wanted;
    Plane units, noises, noiseAround, noiseBeside, risk, limited, riskAround, riskBeside;
    Plane weights{};
    std::array<Plane, kChannels> means{}, halves{};
    std::array<std::array<Plane, kChannels>, kFilters - 1> acrossMeans, acrossHalves;

    template<Filter kFilter>
    void Across()
    {
        const auto filter = [](const Part& part, const Plane& from, Plane& to)
        {
            Part higher = part;
            higher.top -= kReach;
            higher.bottom += kReach;
            higher.ForEachFour([&](int i) { Store(&to[i], Filtered<kFilter>(&from[i], 1)); });
        };
        for (int c = 0; c < kChannels; c++)
        {
            filter(judged, around.Means()[c], acrossMeans[kFilter - 1][c]);
            filter(wanted, around.Halves()[c], acrossHalves[kFilter - 1][c]);
        }
    }

    const Plane* Means(Filter across) const
    {
        return across == kNone ? around.Means().data() : acrossMeans[across - 1].data();
    }
    const Plane* Halves(Filter across) const
    {
        return across == kNone ? around.Halves().data() : acrossHalves[across - 1].data();
    }
};

/// Noise after filtering over noise before, each the mean square over the 5 by 5 pixels around; 1 where too few of them
/// are noisy to tell.
CellPlane Remains(const CellPlane& before, const CellPlane& after)
{
    CellPlane remains;
    for (int y = 0; y < kSide; y++)
        for (int x = 0; x < kSide; x++)
        {
            float b = 0.0f, a = 0.0f, squared = 0.0f;
            for (int v = std::max(0, y - 2); v <= std::min(kSide - 1, y + 2); v++)
                for (int u = std::max(0, x - 2); u <= std::min(kSide - 1, x + 2); u++)
                {
                    b += before[v * kSide + u];
                    squared += before[v * kSide + u] * before[v * kSide + u];
                    a += after[v * kSide + u];
                }
            const bool known = b * b > kFewestNoisy * squared;
            remains[y * kSide + x] = known ? std::min(1.0f, a / b + kLeastRemains) : 1.0f;
        }
    return remains;
}

template<int kChannels, std::size_t... kNumber>
void AddAll(Mixture<kChannels>& mixture, std::index_sequence<kNumber...>)
{
    (mixture.template Add<kBank[kNumber][0], kBank[kNumber][1]>(), ...);
}

template<int kChannels>
Rebuilt RebuildChannels(const Surroundings& around, const Rows& rows)
{
    Mixture<kChannels> mixture(around, rows);
    AddAll(mixture, std::make_index_sequence<std::size(kBank)>());
    Rebuilt rebuilt{};
    CellPlane before{}, after{};
    for (int c = 0; c < kChannels; c++)
        for (int i = 0; i < kPixels; i++)
        {
            const int at = At(i % kSide, i / kSide);
            rebuilt.mean[c][i] = mixture.MeanOf(c, at);
            const float plain = around.Halves()[c][at], filtered = mixture.HalvesOf(c, at);
            before[i] += plain * plain;
            after[i] += filtered * filtered;
        }
    rebuilt.remains = Remains(before, after);
    return rebuilt;
}

/// Copies what of a cell's row lies around another cell; `place` is -1 left of it, 0, or 1 right of it. Instead of the
/// neighbour's own row that of a cell in the middle may be mirrored.
void CopyRow(const float* from, int place, bool mirror, float* row)
{
    constexpr int border = Surroundings::kBorder;
    float* to = row + (place < 0 ? 0 : place == 0 ? border : border + kSide);
    if (place == 0)
        std::copy_n(from, kSide, to);
    else if (mirror)
        std::reverse_copy(place < 0 ? from : from + kSide - border, place < 0 ? from + border : from + kSide, to);
    else
        std::copy_n(place < 0 ? from + kSide - border : from, border, to);
    if (place > 0)
        std::fill(to + border, row + kColumns, 0.0f);  // read, not used
}

} // namespace

void Estimates::Set(std::uint32_t x, std::uint32_t y, const Radiance& ofMean, const Radiance& ofHalves, double ofNoise)
{
    const std::size_t i = y * kCell + x;
    for (std::size_t c = 0; c < mean.size(); c++)
    {
        mean[c][i] = ofMean[c];
        halves[c][i] = ofHalves[c];
    }
    noise[i] = ofNoise;
    transparent = transparent || ofMean[3] != 0.0 || ofMean[4] != 0.0;
}

void Estimates::RepeatEdges(std::uint32_t width, std::uint32_t height)
{
    const auto repeat = [&](CellPlane& plane)
    {
        for (std::uint32_t y = 0; y < kCell; y++)
            for (std::uint32_t x = 0; x < kCell; x++)
                plane[y * kCell + x] = plane[std::min(y, height - 1) * kCell + std::min(x, width - 1)];
    };
    if (width == kCell && height == kCell)
        return;
    std::for_each(mean.begin(), mean.end(), repeat);
    std::for_each(halves.begin(), halves.end(), repeat);
    repeat(noise);
}

Surroundings::Surroundings(const std::array<const Estimates*, 9>& cells)
{
    constexpr int begin[] = {-kBorder, 0, kSide, kSide + kBorder};  // of the rows of cells
    for (int i = 0; i < 9; i++)
    {
        const int row = i / 3, column = i % 3;
        // the neighbour itself, or the nearest of those that are known
        const bool sameRow = cells[row * 3 + 1] != nullptr, sameColumn = cells[3 + column] != nullptr;
        const bool mirrorX = cells[i] == nullptr && (sameRow || !sameColumn);
        const bool mirrorY = cells[i] == nullptr && !sameRow;
        const Estimates& cell = *cells[(mirrorY ? 1 : row) * 3 + (mirrorX ? 1 : column)];
        transparent = transparent || cell.transparent;
        for (int y = begin[row]; y < begin[row + 1]; y++)
        {
            const int inside = y - (row - 1) * kSide, from = (mirrorY ? kSide - 1 - inside : inside) * kSide;
            const auto copy = [&](const CellPlane& plane, Plane& to)
            {
                CopyRow(&plane[from], column - 1, mirrorX, &to[At(-kBorder, y)]);
            };
            for (std::size_t c = 0; c < mean.size(); c++)
            {
                copy(cell.mean[c], mean[c]);
                copy(cell.halves[c], halves[c]);
            }
            copy(cell.noise, noise);
        }
    }
}

Radiance Rebuilt::MeanOf(std::size_t pixel) const
{
    Radiance light;
    for (std::size_t c = 0; c < light.size(); c++)
        light[c] = mean[c][pixel];
    return light;
}

Rebuilt Rebuild(const Surroundings& around, const Rows& rows)
{
    return around.Transparent() ? RebuildChannels<5>(around, rows) : RebuildChannels<3>(around, rows);
}

} // namespace tilt_lens
