// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file prescription.h
/// The table of a lens's surfaces as a file has it. Three forms are read:
///
/// - the `.dat` files of the renderer pbrt: rows of radius, thickness, index and clear diameter, and here also an Abbe number; `#`
///   begins a comment;
/// - the JSON of the lens shader lentil: an object with `optical-elements-patent` (or `-adjusted`), or a database of such
///   objects, of which one is chosen by its name;
/// - the JSON of the ISET toolboxes: an object with `surfaces`.
///
/// The JSON forms may say how groups of the lens move to focus nearer: `object-distance`, a list of distances from the first surface
/// that begins with infinity, and thicknesses with one value for each of them.
///
/// A file's own order and signs are kept: rows run from the scene to the film, and a radius is positive where the centre of the
/// sphere lies on the side of the film.

#ifndef TILT_LENS_PRESCRIPTION_H
#define TILT_LENS_PRESCRIPTION_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace tilt_lens
{

/// One surface, or the stop. With h the distance from the axis and c = 1/radius, a surface lies behind its vertex by
///
///     c h^2 / (1 + sqrt(1 - (1 + conic) c^2 h^2)) + aspheric[0] h^4 + aspheric[1] h^6 + ...
struct PrescriptionRow
{
    double radius = 0.0;     ///< mm; 0: plane
    double thickness = 0.0;  ///< mm along the axis to the next row; that of the last row has no meaning, but for what nearThickness adds
    std::vector<double> nearThickness;  ///< mm, for each of the prescription's objectDistances; empty: it stays. For the last row the film's
    double index = 1.0;      ///< of refraction behind the surface, for the d line (587.6 nm)
    double abbe = 0.0;       ///< Abbe number of what has this index; 0: not stated, or air
    double diameter = 0.0;   ///< mm, of the clear opening
    double conic = 0.0;      ///< conic constant: 0 is a sphere, -1 a paraboloid
    std::vector<double> aspheric;  ///< 1/mm^3, 1/mm^5, ...
    int line = 0;            ///< of the file; 0 where none can be told
};

struct Prescription
{
    std::vector<PrescriptionRow> rows;
    std::size_t stop = 0;  ///< the row that is the aperture stop, a plane within one medium
    std::vector<double> objectDistances;  ///< mm from the first surface to the focus, from far to near, for each nearThickness; empty: no
                                          ///< group moves. The rows' thickness is for infinity
};

/// What a file says that no lens can be made of. what() says the value found, what is allowed and what to do.
class PrescriptionError : public std::runtime_error
{
  public:
    PrescriptionError(int itsLine, const std::string& text) : std::runtime_error(text), line(itsLine) {}

    const int line;  ///< of the file, from 1; 0 where none can be told
};

/// @param text    the whole file
/// @param choice  of a lentil database with several lenses: the name of one; else empty
/// @throws PrescriptionError
Prescription ReadPrescription(const std::string& text, const std::string& choice = "");

/// The lens made larger or smaller as a whole.
Prescription Scaled(const Prescription& prescription, double factor);

} // namespace tilt_lens

#endif
