// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/reconstruction.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "tilt_lens/math/simd.h"
#include "tilt_lens/math/window.h"
#include "tilt_lens/reconstruction/filters.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

namespace
{

constexpr int kColumns = PaddedBlock::kColumns;
constexpr int kSide = int(settings.blockSide);
constexpr int kPixels = kSide * kSide;

using Plane = PaddedBlock::Plane;

constexpr int At(int x, int y) { return PaddedBlock::At(x, y); }

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

/// Means over the pixels around each that is wanted, at most `kRadius` columns and rows away.
template<int kRadius>
void MeanAround(const Plane& values, const Rows& rows, Plane& means)
{
    constexpr float share = 1.0f / ((2 * kRadius + 1) * (2 * kRadius + 1));
    float column[kColumns];
    for (int y = rows.begin; y < rows.end; y++)
    {
        for (int x = -kRadius; x < kSide + kRadius; x += 4)
        {
            Float4 sum = Float4();
            for (int dy = -kRadius; dy <= kRadius; dy++)
                sum += Load<Float4>(&values[At(x, y + dy)]);
            Store(column + x + kRadius, sum);
        }
        for (int x = 0; x < kSide; x += 4)
        {
            Float4 sum = Float4();
            for (int dx = 0; dx <= 2 * kRadius; dx++)
                sum += Load<Float4>(column + x + dx);
            Store(&means[At(x, y)], share * sum);
        }
    }
}

/// The filters' results along rows, kept for all products with what is done down.
template<int kChannels>
class FilteredRows
{
  public:
    FilteredRows(const PaddedBlock& around, const Part& risky, const Part& wanted) : around(around)
    {
        FilterRows<kFit5>(risky, wanted);
        FilterRows<kFit9>(risky, wanted);
        FilterRows<kMean9>(risky, wanted);
        FilterRows<kAhead5>(risky, wanted);
        FilterRows<kBehind5>(risky, wanted);
    }

    const Plane& Mean(Filter across, int c) const
    {
        return across == kNone ? around.Mean(c) : means[across - 1][c];
    }
    const Plane& DualBufferDifference(Filter across, int c) const
    {
        return across == kNone ? around.DualBufferDifference(c) : differences[across - 1][c];
    }

  private:
    const PaddedBlock& around;
    std::array<std::array<Plane, kChannels>, kFilters - 1> means, differences;

    template<Filter kFilter>
    void FilterRows(const Part& risky, const Part& wanted)
    {
        const auto filter = [](const Part& part, const Plane& from, Plane& to)
        {
            Part higher = part;
            higher.top -= settings.filterRadius;
            higher.bottom += settings.filterRadius;
            higher.ForEachFour([&](int i) { Store(&to[i], Filtered<kFilter>(&from[i], 1)); });
        };
        for (int c = 0; c < kChannels; c++)
        {
            filter(risky, around.Mean(c), means[kFilter - 1][c]);
            filter(wanted, around.DualBufferDifference(c), differences[kFilter - 1][c]);
        }
    }
};

/// A candidate of the bank: four pixels of a channel filtered across and down.
template<int kChannels, Filter kAcross, Filter kDown>
struct ProductFilter
{
    const FilteredRows<kChannels>& rows;

    /// The filter's own tap of the pixel.
    static constexpr float CentreTap(int) { return kTaps[kAcross][0] * kTaps[kDown][0]; }
    static constexpr float Preference(int) { return 1.0f; }

    Float4 Mean(int c, int i) const { return Filtered<kDown>(&rows.Mean(kAcross, c)[i], kColumns); }
    Float4 DualBufferDifference(int c, int i) const
    {
        return Filtered<kDown>(&rows.DualBufferDifference(kAcross, c)[i], kColumns);
    }
};

/// The mean of candidates, weighted by their risks.
template<int kChannels>
class RiskWeightedMean
{
  public:
    RiskWeightedMean(const PaddedBlock& around, const Rows& rows) :
        around(around), rows(rows), risky(rows, settings.riskRadius), wanted(rows, 0)
    {
        const Float4 least = Float4() + 1e-30f, most = Float4() + 1e30f;
        risky.ForEachFour([&](int i)
        {
            const Float4 variance = Min(Load<Float4>(&around.Noise()[i]), most);
            const Float4 unit = 1.0f / (variance + least);
            Store(&units[i], unit);
            Store(&noises[i], unit * variance);
        });
        MeanAround<settings.riskRadius>(noises, rows, noiseAround);
        MeanAround<settings.nearRiskRadius>(noises, rows, noiseNear);
    }

    /// @param candidate  linear in the pixels: its Mean(channel, i) of the four pixels at place i, the same filter's
    ///                   DualBufferDifference(channel, i), its CentreTap(i), that is the pixel's own share in it, and
    ///                   Preference(i), its weight over that of a filter with the same risk
    template<class Candidate>
    void Add(const Candidate& candidate)
    {
        FindRisk(candidate);
        MeanAround<settings.riskRadius>(limited, rows, riskAround);
        MeanAround<settings.nearRiskRadius>(risk, rows, riskNear);
        wanted.ForEachFour([&](int i)
        {
            const Float4 weight = candidate.Preference(i) * WeightOf(i);
            Store(&weights[i], Load<Float4>(&weights[i]) + weight);
            for (int c = 0; c < kChannels; c++)
            {
                Store(&means[c][i], Load<Float4>(&means[c][i]) + weight * candidate.Mean(c, i));
                Store(&differences[c][i], Load<Float4>(&differences[c][i]) + weight * candidate.DualBufferDifference(c, i));
            }
        });
    }

    /// Of a pixel of the block. Pixels among such as have no noise stay.
    float MeanOf(int c, int i) const
    {
        const float own = around.Mean(c)[i];
        if (!(weights[i] > 0.0f))
            return own;
        // parabolas reach beyond what they are fitted to: colours are not negative for it, and no transparency is above 1
        const float mean = std::max(means[c][i] / weights[i], std::min(0.0f, own));
        return c < 3 ? mean : std::min(mean, std::max(1.0f, own));
    }
    float DualBufferDifferenceOf(int c, int i) const
    {
        return weights[i] > 0.0f ? differences[c][i] / weights[i] : around.DualBufferDifference(c)[i];
    }

    const Part& Risky() const { return risky; }
    const Part& Wanted() const { return wanted; }

  private:
    const PaddedBlock& around;
    const Rows rows;
    const Part risky, wanted;
    Plane units, noises, noiseAround, noiseNear, risk, limited, riskAround, riskNear;
    Plane weights{};
    std::array<Plane, kChannels> means{}, differences{};

    template<class Candidate>
    void FindRisk(const Candidate& candidate)
    {
        risky.ForEachFour([&](int i)
        {
            const auto noiseTaken = 1.0f - 2.0f * candidate.CentreTap(i);
            Float4 squares = Float4();
            for (int c = 0; c < kChannels; c++)
            {
                const Float4 difference = candidate.Mean(c, i) - Load<Float4>(&around.Mean(c)[i]);
                squares += difference * difference;
            }
            const Float4 noise = Load<Float4>(&noises[i]), all = squares * Load<Float4>(&units[i]) - noiseTaken * noise;
            const Float4 whole = Min(all, Float4() + settings.greatestFiniteRisk);
            Store(&risk[i], whole);
            Store(&limited[i], Min(whole, settings.riskLimit * noise));
        });
    }

    Float4 WeightOf(int i) const
    {
        const Float4 before = Load<Float4>(&noiseAround[i]);
        const Float4 near = Load<Float4>(&riskNear[i]) - settings.chanceRisk * Load<Float4>(&noiseNear[i]);
        const Float4 after = Max(Max(Load<Float4>(&riskAround[i]), near), 1.0f / settings.greatestRisk * before + 1e-30f);
        const Float4 root = Max(before / after - 1.0f / settings.greatestRisk, Float4());
        return root * root;
    }
};

/// Squared difference of a pixel's two buffers, before and after filtering.
struct SquaredDifference
{
    float before = 0.0f, after = 0.0f;
};

void AddTo(SquaredDifference& sum, const SquaredDifference& one)
{
    sum.before += one.before;
    sum.after += one.after;
}

void DivideBy(SquaredDifference& sum, float divisor)
{
    sum.before /= divisor;
    sum.after /= divisor;
}

/// Noise after filtering over noise before, each the mean square over the 5 by 5 pixels around, and the bias that goes with it;
/// 1 where none is noisy.
BlockPlane ResidualVarianceRatio(const std::vector<SquaredDifference>& differences)
{
    const std::vector<SquaredDifference> around = WindowMeans<settings.ratioRadius>(differences, kSide);
    BlockPlane ratio;
    std::transform(around.begin(), around.end(), ratio.begin(), [](const SquaredDifference& mean)
    {
        if (!(mean.before > 0.0f))
            return 1.0f;
        const float noise = std::min(1.0f, mean.after / mean.before);
        return std::min(1.0f, noise + settings.biasOverNoise * noise * (1.0f - noise));
    });
    return ratio;
}

/// The spread estimate S = t q + (1 - t) others of each pixel, with its own samples' share t, as a candidate; corrected it is
/// S + F (q - S), where F is the mean over 9 by 9 pixels.
template<bool kCorrected>
class SpreadCandidate
{
  public:
    SpreadCandidate(const PaddedBlock& around, const PaddedSpread& spread, const Part& risky, const Part& wanted)
    {
        for (std::size_t i = 0; i < ownTap.size(); i++)
        {
            const float share = spread.ownShare[i] * around.Samples()[i];
            ownTap[i] = spread.share[i] > 0.0f ? share / (share + spread.share[i]) : 1.0f;
        }
        for (int c = 0; c < 3; c++)
        {
            Estimate(around.Mean(c), spread.mean[c], risky, means[c]);
            Estimate(around.DualBufferDifference(c), spread.dualBufferDifference[c], wanted, differences[c]);
        }
    }

    Float4 Mean(int c, int i) const { return Load<Float4>(&means[c][i]); }
    Float4 DualBufferDifference(int c, int i) const { return Load<Float4>(&differences[c][i]); }
    Float4 CentreTap(int i) const
    {
        return Load<Float4>(&ownTap[i]) + (kCorrected ? kTaps[kMean9][0] * kTaps[kMean9][0] : 0.0f);
    }
    /// Geometry speaks for it where the pixel's value is made of others' samples.
    Float4 Preference(int i) const
    {
        const Float4 others = 1.0f - Load<Float4>(&ownTap[i]), square = others * others;
        return settings.spreadWeight * square * square;
    }

  private:
    Plane ownTap;
    std::array<Plane, 3> means, differences;

    void Estimate(const Plane& own, const Plane& others, const Part& part, Plane& estimate) const
    {
        Plane missing, rows;
        for (std::size_t i = 0; i < own.size(); i++)
        {
            missing[i] = (1.0f - ownTap[i]) * (own[i] - others[i]);
            estimate[i] = own[i] - missing[i];
        }
        if (!kCorrected)
            return;
        Part higher = part;
        higher.top -= settings.filterRadius;
        higher.bottom += settings.filterRadius;
        higher.ForEachFour([&](int i) { Store(&rows[i], Filtered<kMean9>(&missing[i], 1)); });
        part.ForEachFour([&](int i)
            { Store(&estimate[i], Load<Float4>(&estimate[i]) + Filtered<kMean9>(&rows[i], kColumns)); });
    }
};

template<int kChannels, std::size_t... kNumber>
void AddBank(RiskWeightedMean<kChannels>& mean, const FilteredRows<kChannels>& rows, std::index_sequence<kNumber...>)
{
    (mean.Add(ProductFilter<kChannels, kBank[kNumber][0], kBank[kNumber][1]>{rows}), ...);
}

template<int kChannels>
ReconstructedBlock ReconstructChannels(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    RiskWeightedMean<kChannels> mean(around, rows);
    const FilteredRows<kChannels> filteredRows(around, mean.Risky(), mean.Wanted());
    AddBank(mean, filteredRows, std::make_index_sequence<std::size(kBank)>());
    if (kChannels == 3 && spread != nullptr)
    {
        mean.Add(SpreadCandidate<false>(around, *spread, mean.Risky(), mean.Wanted()));
        mean.Add(SpreadCandidate<true>(around, *spread, mean.Risky(), mean.Wanted()));
    }
    ReconstructedBlock block{};
    std::vector<SquaredDifference> noise(kPixels);
    for (int c = 0; c < kChannels; c++)
        for (int i = 0; i < kPixels; i++)
        {
            const int at = At(i % kSide, i / kSide);
            block.mean[c][i] = mean.MeanOf(c, at);
            const float plain = around.DualBufferDifference(c)[at], filtered = mean.DualBufferDifferenceOf(c, at);
            noise[i].before += plain * plain;
            noise[i].after += filtered * filtered;
        }
    block.residualVarianceRatio = ResidualVarianceRatio(noise);
    return block;
}

} // namespace

ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const PaddedSpread& spread)
{
    const Part whole(Rows(), 0);
    const SpreadCandidate<false> estimate(around, spread, whole, whole);
    ReconstructedBlock block{};
    for (int i = 0; i < kPixels; i++)
    {
        const int at = At(i % kSide, i / kSide);
        for (int c = 0; c < 5; c++)
            block.mean[c][i] = c < 3 && !around.IsTransparent() ? estimate.Mean(c, at)[0] : around.Mean(c)[at];
        block.residualVarianceRatio[i] = 1.0f;
    }
    return block;
}

Radiance ReconstructedBlock::MeanOf(std::size_t pixel) const
{
    Radiance light;
    for (std::size_t c = 0; c < light.size(); c++)
        light[c] = mean[c][pixel];
    return light;
}

ReconstructedBlock Reconstruct(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    return around.IsTransparent() ? ReconstructChannels<5>(around, spread, rows) : ReconstructChannels<3>(around, spread, rows);
}

} // namespace tilt_lens
