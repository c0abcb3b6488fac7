// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file dispersion.h
/// Cauchy's equation through the d, F, C and g lines (docs/lenses.md, "Dispersion"). Sources: Schott, TIE-29, "Refractive index and
/// dispersion" (normal glasses); M. Born, E. Wolf, Principles of Optics, section 2.3.4.

#ifndef TILT_LENS_DISPERSION_H
#define TILT_LENS_DISPERSION_H

#include <memory>
#include <vector>

#include "tilt_lens/glass/glass_lens.h"
#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// @name Wavelengths, nm.
/// @{
constexpr double kLineD = 587.5618, kLineF = 486.1327, kLineC = 656.2725, kLineG = 435.8343;

/// @param hue  -1 (blue end, 400 nm) to 1 (red end, 700 nm); the thirds are blue, green, red
constexpr double WavelengthOf(double hue)
{
    return 550.0 + 150.0 * hue;
}
/// @}

/// @param index  at the d line
/// @param abbe   0: no dispersion
double IndexAt(double index, double abbe, double wavelength);

Prescription AtWavelength(const Prescription& prescription, double wavelength);

/// @throws PrescriptionError  a glass without Abbe number
void RequireAbbeNumbers(const Prescription& prescription);

/// Immutable, thread-safe.
class GlassOfColours
{
  public:
    GlassOfColours(const GlassLens& lens, const Prescription& prescription);

    const GlassLens& Of(double hue) const;

  private:
    std::vector<GlassLens> lenses;  ///< blue to red
};

} // namespace tilt_lens

#endif
