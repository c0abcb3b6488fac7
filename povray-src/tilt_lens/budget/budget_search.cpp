// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/budget/budget_search.h"

#include <algorithm>
#include <cmath>

namespace tilt_lens
{

namespace
{

/// More samples would not be seen: the standard error is then below a fortieth of an 8-bit step.
constexpr double kLeastVariance = 1e-8;
constexpr std::size_t kMostTrials = 24, kMostRounds = 12;
/// Greatest factor between two trials' variances. Greatest growth of the excess between two rounds with all blocks, as a factor or a share
/// of the budget.
constexpr double kGreatestTrialFactor = 4.0, kGreatestGrowth = 1.5, kGreatestShare = 0.15;
/// Nearer variances are not distinguished.
constexpr double kLeastFactor = 1.02;
/// Shares of the budget: limit of the first round with all blocks, since the trials may have missed lamps; aim of each search; enough.
constexpr double kFirstShare = 0.4, kAim = 0.96, kEnough = 0.91;
/// The excess grows as a power of the inverse variance. The exponent is about 1, more where many pixels have the same noise. Where it is less
/// between two rounds, this does not last.
constexpr double kLeastExponent = 1.0, kGreatestExponent = 2.0;
/// Nearer variances tell nothing of the exponent.
constexpr double kLeastSlopeFactor = 1.1;
/// A step, where many pixels have the same noise: least growth as a share of the budget, greatest factor between variances. All blocks do
/// not cross it.
constexpr double kStep = 0.25, kStepFactor = 1.1;

const auto AtMost = [](const BudgetRound& trial) { return trial.AtMost(); };

struct Range
{
    const BudgetRound* within = nullptr;  ///< lowest variance such that none as high exceeds the budget
    const BudgetRound* beyond = nullptr;  ///< highest variance that exceeds it
};

template<class Cost>
Range RangeOf(const BudgetRounds& rounds, double budget, Cost cost)
{
    Range range;
    for (const BudgetRound& round : rounds)
        if (cost(round) > budget && (!range.beyond || round.variance > range.beyond->variance))
            range.beyond = &round;
    for (const BudgetRound& round : rounds)
        if ((!range.beyond || round.variance > range.beyond->variance) && (!range.within || round.variance < range.within->variance))
            range.within = &round;
    return range;
}

/// Samples above the least; positive, for quotients.
double Excess(double samples, double least)
{
    return std::max(1e-3 * least, samples - least);
}

/// Share of the budget above the least samples.
double ShareOf(double budget, double share, double least)
{
    return least + share * (budget - least);
}

/// Steepest growth of the excess between variances at least kLeastSlopeFactor apart, the lower one below `greatest`.
double ExponentOf(BudgetRounds rounds, double greatest, double least)
{
    std::sort(rounds.begin(), rounds.end(), [](const BudgetRound& a, const BudgetRound& b) { return a.variance < b.variance; });
    double steepest = kLeastExponent;
    for (auto low = rounds.begin(); low != rounds.end() && low->variance < greatest; ++low)
    {
        const auto isHigher = [low](const BudgetRound& round) { return round.variance >= kLeastSlopeFactor * low->variance; };
        const auto high = std::find_if(low, rounds.end(), isHigher);
        if (high == rounds.end())
            break;
        const double growth = Excess(low->samples, least) / Excess(high->samples, least);
        steepest = std::max(steepest, std::log(growth) / std::log(high->variance / low->variance));
    }
    return std::min(steepest, kGreatestExponent);
}

/// Nothing if nearer than kLeastFactor.
std::optional<double> Lower(double variance, double factor)
{
    const double next = std::max(variance / factor, kLeastVariance);
    return next * kLeastFactor <= variance ? next : std::optional<double>();
}

}  // namespace

std::optional<double> NextTrialVariance(const BudgetRounds& trials, double budget, double least)
{
    if (trials.empty())
        return 1.0;
    const auto [within, beyond] = RangeOf(trials, budget, AtMost);
    if (!within || trials.size() == kMostTrials || within->AtMost() >= ShareOf(budget, kEnough, least))
        return {};
    const double growth = Excess(ShareOf(budget, kAim, least), least) / Excess(within->AtMost(), least);
    const double most = beyond ? std::sqrt(within->variance / beyond->variance) : kGreatestTrialFactor;
    return Lower(within->variance, std::min(growth, most));
}

std::optional<double> NextVariance(const BudgetRounds& trials, const BudgetRounds& rounds, double recorded, double budget, double least)
{
    if (rounds.empty())
    {
        const BudgetRound* first = RangeOf(trials, ShareOf(budget, kFirstShare, least), AtMost).within;
        return first ? first->variance : std::optional<double>();
    }
    const auto [within, beyond] = RangeOf(rounds, budget, [&](const BudgetRound& round) { return round.Cost(recorded); });
    const double cost = within ? within->Cost(recorded) : budget;
    if (beyond || rounds.size() == kMostRounds || cost >= ShareOf(budget, kEnough, least))
        return {};
    const double most = std::max(kGreatestGrowth * Excess(cost, least), Excess(cost, least) + kGreatestShare * (budget - least));
    const double growth = std::max(1.0, std::min(most, Excess(ShareOf(budget, kAim, least), least)) / Excess(cost, least));
    const auto [before, behind] = RangeOf(trials, budget, AtMost);
    const bool step = before && behind && before->variance <= kStepFactor * behind->variance &&
                      behind->samples - before->samples > kStep * (budget - least);
    const double here = within->variance * kLeastFactor;
    const double exponent = std::max(ExponentOf(trials, here, least), ExponentOf(rounds, here, least));
    const double factor = std::pow(growth, 1.0 / exponent);
    return Lower(within->variance, step ? std::min(factor, within->variance / (kLeastFactor * before->variance)) : factor);
}

const BudgetRound* BestRound(const BudgetRounds& rounds, double recorded, double budget)
{
    double allowed = HUGE_VAL;
    for (const BudgetRound& round : rounds)
        allowed = std::min(allowed, round.Cost(recorded));
    allowed = std::max(budget, allowed * (1.0 + 1e-9));
    const BudgetRound* best = nullptr;
    for (const BudgetRound& round : rounds)
        if (round.Cost(recorded) <= allowed && (!best || round.variance < best->variance))
            best = &round;
    return best;
}

}  // namespace tilt_lens
