// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/reconstruction/reconstruction.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "tilt_lens/math/simd.h"
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

template<class Vector>
constexpr int kWidth = kVectorWidth<Vector>;

constexpr int At(int x, int y) { return PaddedBlock::At(x, y); }

/// The wanted rows with a margin on all sides.
struct Part
{
    int left, right, top, bottom;

    Part(const Rows& rows, int margin) :
        left(-margin), right(kSide + margin), top(rows.begin - margin), bottom(rows.end + margin)
    {
    }

    /// Calls `visit` with the index of the first of each vector of pixels; the last vector of a row may extend beyond it.
    template<class Vector, class Visit>
    TILT_LENS_INLINED void ForEach(const Visit& visit) const
    {
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x += kWidth<Vector>)
                visit(At(x, y));
    }
};

/// Means over a window of radius `kRadius` around each pixel of the wanted rows.
template<class Vector, int kRadius>
TILT_LENS_INLINED void MeanAround(const Plane& values, const Rows& rows, Plane& means)
{
    constexpr float share = 1.0f / ((2 * kRadius + 1) * (2 * kRadius + 1));
    float column[kColumns];
    for (int y = rows.begin; y < rows.end; y++)
    {
        for (int x = -kRadius; x < kSide + kRadius; x += kWidth<Vector>)
        {
            Vector sum = Vector();
            for (int dy = -kRadius; dy <= kRadius; dy++)
                sum += Load<Vector>(&values[At(x, y + dy)]);
            Store(column + x + kRadius, sum);
        }
        for (int x = 0; x < kSide; x += kWidth<Vector>)
        {
            Vector sum = Vector();
            for (int dx = 0; dx <= 2 * kRadius; dx++)
                sum += Load<Vector>(column + x + dx);
            Store(&means[At(x, y)], share * sum);
        }
    }
}

/// Results of the filters along rows, for all products with filters along columns.
template<int kChannels, class Vector>
class FilteredRows
{
  public:
    TILT_LENS_INLINED FilteredRows(const PaddedBlock& around, const Part& risky) : around(around)
    {
        FilterRows<kFit5>(risky);
        FilterRows<kFit9>(risky);
        FilterRows<kMean9>(risky);
    }

    const Plane& Mean(Filter across, int c) const
    {
        return across == kNone ? around.Mean(c) : means[across - 1][c];
    }

  private:
    const PaddedBlock& around;
    std::array<std::array<Plane, kChannels>, kFilters - 1> means;

    template<Filter kFilter>
    TILT_LENS_INLINED void FilterRows(const Part& risky)
    {
        const auto filter = [](const Part& part, const Plane& from, Plane& to) TILT_LENS_INLINED_LAMBDA
        {
            Part higher = part;
            higher.top -= settings.filterRadius;
            higher.bottom += settings.filterRadius;
            higher.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA { Store(&to[i], Filtered<Vector, kFilter>(&from[i], 1)); });
        };
        for (int c = 0; c < kChannels; c++)
            filter(risky, around.Mean(c), means[kFilter - 1][c]);
    }
};

/// Variance of filtered white noise of variance 1.
constexpr float NoiseLeftBy(Filter filter)
{
    float sum = kTaps[filter][0] * kTaps[filter][0];
    for (int i = 1; i <= settings.filterRadius; i++)
        sum += 2.0f * kTaps[filter][i] * kTaps[filter][i];
    return sum;
}

/// A candidate of the bank.
template<int kChannels, class Vector, Filter kAcross, Filter kDown, int kSlant>
struct ProductFilter
{
    const FilteredRows<kChannels, Vector>& rows;

    static constexpr float CentreTap(int) { return kTaps[kAcross][0] * kTaps[kDown][0]; }
    static constexpr float Preference(int) { return 1.0f; }
    static constexpr float NoiseLeft(int) { return NoiseLeftBy(kAcross) * NoiseLeftBy(kDown); }

    TILT_LENS_INLINED Vector Mean(int c, int i) const { return Filtered<Vector, kDown>(&rows.Mean(kAcross, c)[i], kColumns + kSlant); }
};

template<int kChannels, class Vector>
class RiskWeightedMean
{
  public:
    TILT_LENS_INLINED RiskWeightedMean(const PaddedBlock& around, const Rows& rows) :
        around(around), rows(rows), risky(rows, settings.riskRadius), wanted(rows, 0)
    {
        const Vector least = Vector() + 1e-30f, most = Vector() + 1e30f;
        risky.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const Vector variance = Min(Load<Vector>(&around.Noise()[i]), most);
            const Vector unit = 1.0f / (variance + least);
            Store(&units[i], unit);
            Store(&noises[i], unit * variance);
        });
        MeanAround<Vector, settings.riskRadius>(noises, rows, noiseAround);
        MeanAround<Vector, settings.nearRiskRadius>(noises, rows, noiseNear);
    }

    /// @param candidate  a linear estimate of the pixels from index i on: Mean(channel, i); CentreTap(i), its tap of the pixel itself;
    ///     NoiseLeft(i), the fraction of the pixel's variance that it leaves; Preference(i), its weight relative to a filter with the same
    ///     risk
    template<class Candidate>
    TILT_LENS_INLINED void Add(const Candidate& candidate)
    {
        FindRisk(candidate);
        MeanAround<Vector, settings.riskRadius>(limited, rows, riskAround);
        MeanAround<Vector, settings.nearRiskRadius>(risk, rows, riskNear);
        wanted.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const Vector weight = candidate.Preference(i) * WeightOf(i);
            Store(&weights[i], Load<Vector>(&weights[i]) + weight);
            Store(&noiseLeft[i], Load<Vector>(&noiseLeft[i]) + weight * candidate.NoiseLeft(i));
            for (int c = 0; c < kChannels; c++)
                Store(&means[c][i], Load<Vector>(&means[c][i]) + weight * candidate.Mean(c, i));
        });
    }

    /// Result for a pixel of the block; unchanged if its surroundings have no noise.
    float MeanOf(int c, int i) const
    {
        const float own = around.Mean(c)[i];
        if (!(weights[i] > 0.0f))
            return own;
        // fitted parabolas overshoot: keep colours non-negative and transparency at most 1
        const float mean = std::max(means[c][i] / weights[i], std::min(0.0f, own));
        return c < 3 ? mean : std::min(mean, std::max(1.0f, own));
    }
    /// Upper bound of the remaining fraction of a pixel's variance: the variance of a mean of estimates is at most the mean of their
    /// variances.
    float NoiseLeftOf(int i) const { return weights[i] > 0.0f ? noiseLeft[i] / weights[i] : 1.0f; }

    const Part& Risky() const { return risky; }

  private:
    const PaddedBlock& around;
    const Rows rows;
    const Part risky, wanted;
    Plane units, noises, noiseAround, noiseNear, risk, limited, riskAround, riskNear;
    Plane weights{}, noiseLeft{};
    std::array<Plane, kChannels> means{};

    template<class Candidate>
    TILT_LENS_INLINED void FindRisk(const Candidate& candidate)
    {
        risky.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const auto noiseTaken = 1.0f - 2.0f * candidate.CentreTap(i);
            Vector squares = Vector();
            for (int c = 0; c < kChannels; c++)
            {
                const Vector difference = candidate.Mean(c, i) - Load<Vector>(&around.Mean(c)[i]);
                squares += difference * difference;
            }
            const Vector noise = Load<Vector>(&noises[i]), all = squares * Load<Vector>(&units[i]) - noiseTaken * noise;
            const Vector whole = Min(all, Vector() + settings.greatestFiniteRisk);
            Store(&risk[i], whole);
            Store(&limited[i], Min(whole, settings.riskLimit * noise));
        });
    }

    TILT_LENS_INLINED Vector WeightOf(int i) const
    {
        const Vector before = Load<Vector>(&noiseAround[i]);
        const Vector near = Load<Vector>(&riskNear[i]) - settings.chanceRisk * Load<Vector>(&noiseNear[i]);
        const Vector after = Max(Max(Load<Vector>(&riskAround[i]), near), 1.0f / settings.greatestRisk * before + 1e-30f);
        const Vector root = Max(before / after - 1.0f / settings.greatestRisk, Vector());
        return root * root;
    }
};

/// Each pixel's spread estimate S = t q + (1 - t) o, with the mean o of received samples and the weight t of its own; corrected, S + F (q -
/// S) with the mean F over 9 by 9 pixels.
template<class Vector, bool kCorrected>
class SpreadCandidate
{
  public:
    TILT_LENS_INLINED SpreadCandidate(const PaddedBlock& around, const PaddedSpread& spread, const Part& risky)
    {
        for (std::size_t i = 0; i < ownTap.size(); i++)
        {
            const float share = spread.ownShare[i] * around.Samples()[i];
            ownTap[i] = spread.share[i] > 0.0f ? share / (share + spread.share[i]) : 1.0f;
            const float others = spread.samples[i], noise = around.Noise()[i];
            const float noiseOfOthers = others > 0.0f && noise > 0.0f ? std::min(1.0f, spread.variance[i] / (others * noise)) : 1.0f;
            noiseLeft[i] = ownTap[i] * ownTap[i] + (1.0f - ownTap[i]) * (1.0f - ownTap[i]) * noiseOfOthers;
            weight[i] = settings.spreadWeight * (1.0f + settings.missedWeight * around.Missed()[i]);
        }
        for (int c = 0; c < 3; c++)
            Estimate(around.Mean(c), spread.mean[c], risky, means[c]);
    }

    TILT_LENS_INLINED Vector Mean(int c, int i) const { return Load<Vector>(&means[c][i]); }
    TILT_LENS_INLINED Vector CentreTap(int i) const
    {
        return Load<Vector>(&ownTap[i]) + (kCorrected ? kTaps[kMean9][0] * kTaps[kMean9][0] : 0.0f);
    }
    TILT_LENS_INLINED Vector NoiseLeft(int i) const { return Load<Vector>(&noiseLeft[i]) + (kCorrected ? NoiseLeftBy(kMean9) * NoiseLeftBy(kMean9) : 0.0f); }
    /// Geometry favours S where it is made of other pixels' samples, and more where the pixel's own samples have missed something.
    TILT_LENS_INLINED Vector Preference(int i) const
    {
        const Vector others = 1.0f - Load<Vector>(&ownTap[i]), square = others * others;
        return Load<Vector>(&weight[i]) * square * square;
    }

  private:
    Plane ownTap, noiseLeft, weight;
    std::array<Plane, 3> means;

    TILT_LENS_INLINED void Estimate(const Plane& own, const Plane& others, const Part& part, Plane& estimate) const
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
        higher.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA { Store(&rows[i], Filtered<Vector, kMean9>(&missing[i], 1)); });
        part.ForEach<Vector>([&](int i) TILT_LENS_INLINED_LAMBDA
            { Store(&estimate[i], Load<Vector>(&estimate[i]) + Filtered<Vector, kMean9>(&rows[i], kColumns)); });
    }
};

template<int kChannels, class Vector, std::size_t... kNumber>
TILT_LENS_INLINED void AddBank(RiskWeightedMean<kChannels, Vector>& mean, const FilteredRows<kChannels, Vector>& rows, std::index_sequence<kNumber...>)
{
    (mean.Add(ProductFilter<kChannels, Vector, kBank[kNumber].across, kBank[kNumber].down, kBank[kNumber].slant>{rows}), ...);
}

template<int kChannels, class Vector>
TILT_LENS_INLINED ReconstructedBlock ReconstructChannels(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    RiskWeightedMean<kChannels, Vector> mean(around, rows);
    const FilteredRows<kChannels, Vector> filteredRows(around, mean.Risky());
    AddBank(mean, filteredRows, std::make_index_sequence<std::size(kBank)>());
    if (kChannels == 3 && spread != nullptr)
    {
        mean.Add(SpreadCandidate<Vector, false>(around, *spread, mean.Risky()));
        mean.Add(SpreadCandidate<Vector, true>(around, *spread, mean.Risky()));
    }
    ReconstructedBlock block{};
    for (int i = 0; i < kPixels; i++)
    {
        const int at = At(i % kSide, i / kSide);
        for (int c = 0; c < kChannels; c++)
            block.mean[c][i] = mean.MeanOf(c, at);
        block.residualVarianceRatio[i] = std::min(1.0f, mean.NoiseLeftOf(at));
    }
    return block;
}

ReconstructedBlock ReconstructPlain(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    return ReconstructChannels<3, Float4>(around, spread, rows);
}

TILT_LENS_FOR_AVX2 ReconstructedBlock ReconstructByAvx2(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    return ReconstructChannels<3, Float8>(around, spread, rows);
}

ReconstructedBlock ReconstructTransparent(const PaddedBlock& around, const PaddedSpread* spread, const Rows& rows)
{
    return ReconstructChannels<5, Float4>(around, spread, rows);
}

} // namespace

ReconstructedBlock SpreadEstimates(const PaddedBlock& around, const PaddedSpread& spread)
{
    const Part whole(Rows(), 0);
    const SpreadCandidate<Float4, false> estimate(around, spread, whole);
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
    if (around.IsTransparent())
        return ReconstructTransparent(around, spread, rows);
    return HasAvx2() ? ReconstructByAvx2(around, spread, rows) : ReconstructPlain(around, spread, rows);
}

} // namespace tilt_lens
