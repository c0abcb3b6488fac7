// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file budget_search.h
/// Search for the variance target of budget.h. Functions of numbers alone.

#ifndef TILT_LENS_BUDGET_SEARCH_H
#define TILT_LENS_BUDGET_SEARCH_H

#include <algorithm>
#include <optional>
#include <vector>

namespace tilt_lens
{

inline double UsualVariance(double budget)
{
    return std::min(1.0, 0.01 / budget);
}

/// Cost of a variance target, in samples per pixel of the whole picture.
struct BudgetRound
{
    double variance = 0.0;
    double samples = 0.0;  ///< taken by the picture
    double doubt = 0.0;    ///< standard error of `samples`, since not all blocks were sampled
    double used = 0.0;     ///< recorded samples that the picture needs

    /// Two standard errors above `samples`.
    double AtMost() const { return samples + 2.0 * doubt; }

    /// @param recorded  all samples of the pilot; unneeded ones are lost
    double Cost(double recorded) const { return AtMost() + (recorded - used); }
};

using BudgetRounds = std::vector<BudgetRound>;

/// The next target to try with a few blocks, from above; nothing once one takes nearly the budget.
/// @param least  samples of the first round: no target takes less
std::optional<double> NextTrialVariance(const BudgetRounds& trials, double budget, double least);

/// The next target to try with all blocks, from above, so that no samples are lost; nothing if the last one is good enough or none keeps
/// the budget.
std::optional<double> NextVariance(const BudgetRounds& trials, const BudgetRounds& rounds, double recorded, double budget, double least);

/// The lowest target that keeps the budget, else the lowest of the cheapest. Null without rounds.
const BudgetRound* BestRound(const BudgetRounds& rounds, double recorded, double budget);

} // namespace tilt_lens

#endif
