// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file solve.h
/// Solves any `tilt_lens` statement, for a thin lens or a lens of glass.

#ifndef TILT_LENS_SOLVE_H
#define TILT_LENS_SOLVE_H

#include <memory>

#include "tilt_lens/camera/optics.h"

namespace tilt_lens
{

class GlassLens;

/// The glass is traced in place of the thin lens.
struct SolvedLens : Lens
{
    std::shared_ptr<const GlassLens> glass;          ///< stopped down; null: thin lens
    double groups = 0.0;                             ///< position (inner_focus.h); 0: infinity
    std::shared_ptr<const Prescription> dispersion;  ///< in this focus; null: one wavelength

    SolvedLens() = default;
    SolvedLens(const Lens& thin) : Lens(thin) {}
};

/// @throws OpticsError  as SolveThinLens(); glass that is too narrow or ends behind the film
SolvedLens Solve(const CameraFrame& camera, const Statement& given);

/// Takes the prescription's focal length and f-number, if any.
Statement IdealStatement(const Statement& given);

/// Puts the prescription in a focus state (inner_focus.h), if it moves groups.
Statement WithGroups(const Statement& given, double state);

} // namespace tilt_lens

#endif
