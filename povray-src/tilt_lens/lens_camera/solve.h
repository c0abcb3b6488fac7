// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file solve.h
/// Solves any `tilt_lens` statement.

#ifndef TILT_LENS_SOLVE_H
#define TILT_LENS_SOLVE_H

#include <memory>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

class GlassLens;

struct SolvedLens : Lens
{
    std::shared_ptr<const GlassLens> glass;          ///< stopped down; null: thin lens
    double groups = 0.0;                             ///< position (inner_focus.h); 0: infinity
    std::shared_ptr<const Prescription> dispersion;  ///< in this focus; null: one wavelength

    SolvedLens() = default;
    SolvedLens(const Lens& thin) : Lens(thin) {}
};

/// @throws OpticsError  as SolveThinLens(); glass too narrow or behind the film
SolvedLens Solve(const CameraFrame& camera, const Statement& given);

Statement IdealStatement(const Statement& given);

/// Focus state as in inner_focus.h.
Statement WithGroups(const Statement& given, double state);

} // namespace tilt_lens

#endif
