// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file budget_search.h
/// Finds the variance target with which a picture takes a given mean number of samples: docs/sampling.md, section 9. Functions of numbers
/// alone; budget.h samples the blocks.

#ifndef TILT_LENS_BUDGET_SEARCH_H
#define TILT_LENS_BUDGET_SEARCH_H

#include <algorithm>
#include <optional>
#include <vector>

namespace tilt_lens
{

/// About the variance target of pictures with this budget.
inline double UsualVariance(double budget)
{
    return std::min(1.0, 0.01 / budget);
}

/// Cost of a variance target. All numbers but the first are samples per pixel of the whole picture.
struct BudgetRound
{
    double variance = 0.0;
    double samples = 0.0;  ///< that the picture takes
    double doubt = 0.0;    ///< standard error of this number, because not all blocks were sampled
    double used = 0.0;     ///< recorded samples that the picture needs

    /// Samples that the picture will hardly exceed: two standard errors more.
    double AtMost() const { return samples + 2.0 * doubt; }

    /// Cost of a picture with this target.
    /// @param recorded  all samples of the pilot; those that this target does not need are lost
    double Cost(double recorded) const { return AtMost() + (recorded - used); }
};

using BudgetRounds = std::vector<BudgetRound>;

/// The next target to try with a few blocks, from above; nothing once one takes nearly the budget.
/// @param least  samples of the first round: no target takes less
std::optional<double> NextTrialVariance(const BudgetRounds& trials, double budget, double least);

/// The next target to try with all blocks of the pilot, from above, so that no samples are lost; nothing if the last one is good enough or
/// no target is known to keep the budget.
std::optional<double> NextVariance(const BudgetRounds& trials, const BudgetRounds& rounds, double recorded, double budget, double least);

/// The round with the lowest target that keeps the budget; if none does, the lowest of the cheapest. Null without rounds.
const BudgetRound* BestRound(const BudgetRounds& rounds, double recorded, double budget);

} // namespace tilt_lens

#endif
