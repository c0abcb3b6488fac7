// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file prescription.h
/// The table of a lens's surfaces, read from a file (docs/lenses.md). Rows go from scene to film; a radius is positive if the centre lies
/// towards the film.

#ifndef TILT_LENS_PRESCRIPTION_H
#define TILT_LENS_PRESCRIPTION_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace tilt_lens
{

/// At the distance h from the axis, with c = 1/radius, a surface lies behind its vertex by
///
///     c h^2 / (1 + sqrt(1 - (1 + conic) c^2 h^2)) + aspheric[0] h^4 + aspheric[1] h^6 + ...
struct PrescriptionRow
{
    double radius = 0.0;  ///< mm; 0: plane
    double thickness = 0.0;  ///< mm to the next row, focused at infinity; the last row's counts only against nearThickness
    std::vector<double> nearThickness;  ///< mm, for each of objectDistances (last row: to the film); empty: stays
    double index = 1.0;  ///< behind the surface, at the d line (587.6 nm)
    double abbe = 0.0;  ///< 0: not stated, or air
    double diameter = 0.0;  ///< mm, clear opening
    double conic = 0.0;  ///< 0: sphere, -1: paraboloid
    std::vector<double> aspheric;  ///< 1/mm^3, 1/mm^5, ...
    int line = 0;  ///< 0: unknown
};

struct Prescription
{
    std::vector<PrescriptionRow> rows;
    std::size_t stop = 0;  ///< row of the aperture stop, a plane within one medium
    std::vector<double> objectDistances;  ///< mm from the first surface, from far to near; empty: no group moves
};

/// The prescription is no lens. The text continues the file's name.
class PrescriptionError : public std::runtime_error
{
  public:
    PrescriptionError(int itsLine, const std::string& text) : std::runtime_error(text), line(itsLine) {}

    const int line;  ///< from 1; 0: unknown
};

/// @param choice  a lens's name in a lentil database; else empty
/// @throws PrescriptionError
Prescription ReadPrescription(const std::string& text, const std::string& choice = "");

Prescription Scaled(const Prescription& prescription, double factor);

}  // namespace tilt_lens

#endif
