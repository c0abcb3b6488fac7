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

/// A solved thin lens, and the glass that is traced in its place.
struct SolvedLens : Lens
{
    std::shared_ptr<const GlassLens> glass;          ///< stopped down; null: the lens is thin
    double groups = 0.0;                             ///< position of its focusing groups (inner_focus.h); 0: infinity
    std::shared_ptr<const Prescription> dispersion;  ///< in this focus, for rays of several wavelengths; null: one wavelength

    SolvedLens() = default;
    SolvedLens(const Lens& thin) : Lens(thin) {}
};

/// Solves a statement for a camera.
/// @throws OpticsError  as SolveThinLens(); glass that is too narrow or ends behind the film
SolvedLens Solve(const CameraFrame& camera, const Statement& given);

/// The statement of an ideal lens with the prescription's focal length and f-number; unchanged without a prescription.
Statement IdealStatement(const Statement& given);

/// The statement with its prescription in a focus state (inner_focus.h); unchanged if the lens moves no groups.
Statement WithGroups(const Statement& given, double state);

} // namespace tilt_lens

#endif
