// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include <iterator>
#include <utility>

#include "tilt_lens/kernels/variant.h"
#include "tilt_lens/reconstruction/filter_input.h"
#include "tilt_lens/reconstruction/filters.h"
#include "tilt_lens/reconstruction/padded_spread.h"

namespace tilt_lens::TILT_LENS_VARIANT
{

namespace
{

constexpr int kColumns = PaddedBlock::kColumns;
constexpr int kSide = int(Settings::blockSide);
constexpr int kPixels = kSide * kSide;

constexpr std::size_t kPlane = PaddedBlock::kRows * PaddedBlock::kColumns;
using Plane = float[kPlane];

constexpr int kWidth = kVectorWidth<Floats>;

TILT_LENS_INLINED constexpr int At(int x, int y)
{
    return PaddedBlock::At(x, y);
}

struct Part
{
    int left, right, top, bottom;

    Part(const FilterInput& input, int margin) :
        left(-margin), right(kSide + margin), top(input.firstRow - margin), bottom(input.endRow + margin)
    {
    }

    template<class Visit>
    TILT_LENS_INLINED void ForEachPixel(const Visit& visit) const
    {
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x++)
                visit(At(x, y));
    }

    /// A row's last vector may extend beyond it.
    template<class Visit>
    TILT_LENS_INLINED void ForEach(const Visit& visit) const
    {
        for (int y = top; y < bottom; y++)
            for (int x = left; x < right; x += kWidth)
                visit(At(x, y));
    }
};

template<int kRadius>
TILT_LENS_INLINED void MeanAround(const float* values, const FilterInput& input, Plane& means)
{
    constexpr float share = 1.0f / ((2 * kRadius + 1) * (2 * kRadius + 1));
    float column[kColumns];
    for (int y = input.firstRow; y < input.endRow; y++)
    {
        for (int x = -kRadius; x < kSide + kRadius; x += kWidth)
        {
            Floats sum = Floats();
            for (int dy = -kRadius; dy <= kRadius; dy++)
                sum += Load<Floats>(&values[At(x, y + dy)]);
            Store(column + x + kRadius, sum);
        }
        for (int x = 0; x < kSide; x += kWidth)
        {
            Floats sum = Floats();
            for (int dx = 0; dx <= 2 * kRadius; dx++)
                sum += Load<Floats>(column + x + dx);
            Store(&means[At(x, y)], share * sum);
        }
    }
}

template<int kChannels>
class FilteredRows
{
  public:
    TILT_LENS_INLINED FilteredRows(const FilterInput& around, const Part& risky) : around(around)
    {
        FilterRows<kFit5>(risky);
        FilterRows<kFit9>(risky);
        FilterRows<kMean9>(risky);
    }

    TILT_LENS_INLINED const float* Mean(Filter across, int c) const { return across == kNone ? around.mean[c] : means[across - 1][c]; }

  private:
    const FilterInput& around;
    Plane means[kFilters - 1][kChannels];

    template<Filter kFilter>
    TILT_LENS_INLINED void FilterRows(const Part& risky)
    {
        const auto filter = [](const Part& part, const float* from, float* to) TILT_LENS_INLINED_LAMBDA
        {
            Part higher = part;
            higher.top -= Settings::filterRadius;
            higher.bottom += Settings::filterRadius;
            higher.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA { Store(&to[i], Filtered<Floats, kFilter>(&from[i], 1)); });
        };
        for (int c = 0; c < kChannels; c++)
            filter(risky, around.mean[c], means[kFilter - 1][c]);
    }
};

template<int kChannels, int kNumber>
struct ProductFilter
{
    const FilteredRows<kChannels>& rows;

    static constexpr FilterPair pair = kBank[kNumber];
    static constexpr float centreTap = TapOf(pair, 0, 0);

    static constexpr float CentreTap(int) { return centreTap; }
    static constexpr float Preference(int) { return 1.0f; }
    static float DeviationLeft(int) { return SquareRoot(kCovariances.of[kNumber][kNumber]); }

    TILT_LENS_INLINED Floats Mean(int c, int i) const
    {
        return Filtered<Floats, pair.down>(&rows.Mean(pair.across, c)[i], kColumns + pair.slant);
    }
};

template<bool kCorrected>
class SpreadCandidate;

template<int kChannels>
class RiskWeightedMean
{
  public:
    explicit TILT_LENS_INLINED RiskWeightedMean(const FilterInput& around) :
        around(around), risky(around, Settings::riskRadius), wanted(around, 0), leastRisk(1.0f / around.settings.greatestRisk)
    {
        const Floats least = Floats() + 1e-30f, most = Floats() + 1e30f;
        risky.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const Floats variance = Min(Load<Floats>(&around.noise[i]), most);
            const Floats unit = 1.0f / (variance + least);
            Store(&units[i], unit);
            Store(&noises[i], unit * variance);
        });
        MeanAround<Settings::riskRadius>(noises, around, noiseAround);
        MeanAround<Settings::nearRiskRadius>(noises, around, noiseNear);
    }

    template<int kNumber>
    TILT_LENS_INLINED void Add(const ProductFilter<kChannels, kNumber>& filter)
    {
        Add(filter, [&](int i, const Floats& weight) TILT_LENS_INLINED_LAMBDA { Store(&bankWeights[kNumber][i], weight); });
    }
    template<bool kCorrected>
    TILT_LENS_INLINED void Add(const SpreadCandidate<kCorrected>& candidate)
    {
        Add(candidate, [&](int i, const Floats& weight) TILT_LENS_INLINED_LAMBDA
        { Store(&spreadDeviation[i], Load<Floats>(&spreadDeviation[i]) + weight * candidate.DeviationLeft(i)); });
    }

    float MeanOf(int c, int i) const
    {
        const float own = around.mean[c][i];
        if (!(weights[i] > 0.0f))
            return own;
        // fitted parabolas overshoot: colours stay non-negative, transparency at most 1
        const float mean = Max(Min(own, 0.0f), means[c][i] / weights[i]);
        return c < 3 ? mean : Min(Max(own, 1.0f), mean);
    }
    /// Upper bound of the variance that is left of noise of variance 1.
    float NoiseBoundOf(int i) const
    {
        const float deviation = weights[i] > 0.0f ? deviationLeft[i] / weights[i] : 1.0f;
        return deviation * deviation;
    }
    /// Estimate of the same.
    TILT_LENS_INLINED void FindNoiseLeft(Plane& left) const
    {
        wanted.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const Floats bank = VarianceOfBank(i), spread = Load<Floats>(&spreadDeviation[i]), all = Load<Floats>(&weights[i]);
            const Floats both = bank + spread * spread + 2.0f * Settings::spreadCorrelation * SquareRoot(bank) * spread;
            Store(&left[i], all > Floats() ? both / (all * all) : Floats() + 1.0f);
        });
    }
    /// Over the noise: mean risk of the block. Negative where chance made the filters agree with the noise.
    float Risk() const
    {
        float sum = 0.0f, all = 0.0f;
        wanted.ForEachPixel([&](int i)
        {
            if (!(weights[i] > 0.0f) || !(around.noise[i] > 0.0f))
                return;
            float squares = 0.0f;
            for (int c = 0; c < kChannels; c++)
            {
                const float difference = means[c][i] / weights[i] - around.mean[c][i];
                squares += difference * difference;
            }
            sum += squares - (1.0f - 2.0f * centreTap[i] / weights[i]) * around.noise[i];
            all += around.noise[i];
        });
        return all > 0.0f ? Min(sum / all, 1.0f) : 0.0f;
    }

    const Part& Risky() const { return risky; }

  private:
    const FilterInput& around;
    const Part risky, wanted;
    const float leastRisk;  ///< over the noise
    Plane units, noises, noiseAround, noiseNear, risk, limited, riskAround, riskNear;
    Plane bankWeights[kFiltersOfBank], spreadDeviation{};
    Plane weights{}, deviationLeft{}, centreTap{};
    Plane means[kChannels]{};
    Plane filtered[kChannels];  ///< means of the candidate that is added

    /// @param candidate  linear estimate from index i on; CentreTap(i) is the tap of the pixel itself, DeviationLeft(i) the remaining
    ///                   standard deviation, Preference(i) a factor of its weight
    /// @param keep       receives i and the weights
    template<class Candidate, class Keep>
    TILT_LENS_INLINED void Add(const Candidate& candidate, const Keep& keep)
    {
        FindRisk(candidate);
        MeanAround<Settings::riskRadius>(limited, around, riskAround);
        MeanAround<Settings::nearRiskRadius>(risk, around, riskNear);
        wanted.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const Floats weight = candidate.Preference(i) * WeightOf(i);
            Store(&weights[i], Load<Floats>(&weights[i]) + weight);
            Store(&deviationLeft[i], Load<Floats>(&deviationLeft[i]) + weight * candidate.DeviationLeft(i));
            keep(i, weight);
            Store(&centreTap[i], Load<Floats>(&centreTap[i]) + weight * candidate.CentreTap(i));
            for (int c = 0; c < kChannels; c++)
                Store(&means[c][i], Load<Floats>(&means[c][i]) + weight * Load<Floats>(&filtered[c][i]));
        });
    }

    template<class Candidate>
    TILT_LENS_INLINED void FindRisk(const Candidate& candidate)
    {
        risky.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA
        {
            const auto noiseTaken = 1.0f - 2.0f * candidate.CentreTap(i);
            Floats squares = Floats();
            for (int c = 0; c < kChannels; c++)
            {
                const Floats mean = candidate.Mean(c, i);
                Store(&filtered[c][i], mean);
                const Floats difference = mean - Load<Floats>(&around.mean[c][i]);
                squares += difference * difference;
            }
            const Floats noise = Load<Floats>(&noises[i]), all = squares * Load<Floats>(&units[i]) - noiseTaken * noise;
            const Floats whole = Min(all, Floats() + Settings::greatestFiniteRisk);
            Store(&risk[i], whole);
            Store(&limited[i], Min(whole, around.settings.greatestRisk * noise));
        });
    }

    /// Variance of the bank's weighted sum of noise of variance 1.
    TILT_LENS_INLINED Floats VarianceOfBank(int i) const
    {
        Floats variance = Floats();
        for (int a = 0; a < kFiltersOfBank; a++)
        {
            Floats sum = kCovariances.of[a][a] * Load<Floats>(&bankWeights[a][i]);
            for (int b = 0; b < a; b++)
                sum += 2.0f * kCovariances.of[a][b] * Load<Floats>(&bankWeights[b][i]);
            variance += sum * Load<Floats>(&bankWeights[a][i]);
        }
        return Max(variance, Floats());
    }

    TILT_LENS_INLINED Floats WeightOf(int i) const
    {
        const Floats before = Load<Floats>(&noiseAround[i]);
        const Floats near = Load<Floats>(&riskNear[i]) - around.settings.chanceRisk * Load<Floats>(&noiseNear[i]);
        const Floats after = Max(Max(Load<Floats>(&riskAround[i]), near), leastRisk * before + 1e-30f);
        const Floats root = Max(before / after - leastRisk, Floats());
        return root * root;
    }
};

/// Spread estimate S = (1 - u) q + u o (docs/sampling.md, section 5); corrected, S + mean9(q - S).
template<bool kCorrected>
class SpreadCandidate
{
  public:
    TILT_LENS_INLINED SpreadCandidate(const FilterInput& around, const Part& risky)
    {
        const SpreadInput& spread = *around.spread;
        for (std::size_t i = 0; i < kPlane; i++)
        {
            const float own = spread.ownShare[i] * around.samples[i], further = own - spread.ownShare[i] * spread.ownWeight[i];
            const float all = further + spread.share[i];
            ofReceived[i] = spread.share[i] > 0.0f ? spread.share[i] / all : 0.0f;
            ownTap[i] = own < all ? own / all : 1.0f;
            const float received = spread.samples[i], noise = around.noise[i];
            const float noiseOfMean = received > 0.0f && noise > 0.0f ? Min(spread.variance[i] / (received * noise), 1.0f) : 1.0f;
            const float left = ownTap[i] * ownTap[i] + (1.0f - ownTap[i]) * (1.0f - ownTap[i]) * noiseOfMean;
            deviationLeft[i] = SquareRoot(left + (kCorrected ? mean9Tap : 0.0f));
            weight[i] = around.settings.spreadWeight * (1.0f + around.settings.missedWeight * around.missed[i]);
        }
        for (int c = 0; c < 3; c++)
            Estimate(around.mean[c], spread.mean[c], risky, means[c]);
    }

    TILT_LENS_INLINED Floats Mean(int c, int i) const { return Load<Floats>(&means[c][i]); }
    TILT_LENS_INLINED Floats CentreTap(int i) const { return Load<Floats>(&ownTap[i]) + (kCorrected ? mean9Tap : 0.0f); }
    TILT_LENS_INLINED Floats DeviationLeft(int i) const { return Load<Floats>(&deviationLeft[i]); }
    /// Favours other pixels' samples, more where the pixel's own missed something.
    TILT_LENS_INLINED Floats Preference(int i) const
    {
        const Floats others = 1.0f - Load<Floats>(&ownTap[i]), square = others * others;
        return Load<Floats>(&weight[i]) * square * square;
    }

  private:
    static constexpr float mean9Tap = kTaps[kMean9][0] * kTaps[kMean9][0];  ///< also the variance that it leaves

    Plane ofReceived;  ///< u
    Plane ownTap, deviationLeft, weight;
    Plane means[3];

    TILT_LENS_INLINED void Estimate(const float* own, const float* received, const Part& part, float* estimate) const
    {
        Plane missing, rows;
        for (std::size_t i = 0; i < kPlane; i++)
        {
            missing[i] = ofReceived[i] * (own[i] - received[i]);
            estimate[i] = own[i] - missing[i];
        }
        if (!kCorrected)
            return;
        Part higher = part;
        higher.top -= Settings::filterRadius;
        higher.bottom += Settings::filterRadius;
        higher.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA { Store(&rows[i], Filtered<Floats, kMean9>(&missing[i], 1)); });
        part.ForEach([&](int i) TILT_LENS_INLINED_LAMBDA
        { Store(&estimate[i], Load<Floats>(&estimate[i]) + Filtered<Floats, kMean9>(&rows[i], kColumns)); });
    }
};

template<int kChannels, int... kNumber>
TILT_LENS_INLINED void AddBank(RiskWeightedMean<kChannels>& mean, const FilteredRows<kChannels>& rows,
                               std::integer_sequence<int, kNumber...>)
{
    (mean.Add(ProductFilter<kChannels, kNumber>{rows}), ...);
}

template<int kChannels>
TILT_LENS_INLINED void FilterChannels(const FilterInput& around, const FilterOutput& block)
{
    RiskWeightedMean<kChannels> mean(around);
    const FilteredRows<kChannels> filteredRows(around, mean.Risky());
    AddBank(mean, filteredRows, std::make_integer_sequence<int, kFiltersOfBank>());
    if (kChannels == 3 && around.spread != nullptr)
    {
        mean.Add(SpreadCandidate<false>(around, mean.Risky()));
        mean.Add(SpreadCandidate<true>(around, mean.Risky()));
    }
    const float risk = *block.risk = mean.Risk();
    Plane noiseLeft{};
    mean.FindNoiseLeft(noiseLeft);
    for (int i = 0; i < kPixels; i++)
    {
        const int at = At(i % kSide, i / kSide);
        for (int c = 0; c < kChannels; c++)
            block.mean[c][i] = mean.MeanOf(c, at);
        block.residualVarianceBound[i] = Min(Max(risk, mean.NoiseBoundOf(at)), 1.0f);
        block.residualVarianceRatio[i] = Min(noiseLeft[at], 1.0f);
    }
}

}  // namespace

void FilterBlock(const FilterInput& input, const FilterOutput& output)
{
    if (input.channels == 3)
        FilterChannels<3>(input, output);
    else
        FilterChannels<5>(input, output);
}

void EstimateSpread(const FilterInput& input, const FilterOutput& output)
{
    const SpreadCandidate<false> estimate(input, Part(input, 0));
    *output.risk = 1.0f;
    for (int i = 0; i < kPixels; i++)
    {
        const int at = At(i % kSide, i / kSide);
        for (int c = 0; c < 5; c++)
            output.mean[c][i] = c < 3 && input.channels == 3 ? estimate.Mean(c, at)[0] : input.mean[c][at];
        output.residualVarianceBound[i] = output.residualVarianceRatio[i] = 1.0f;
    }
}

}  // namespace tilt_lens::TILT_LENS_VARIANT
