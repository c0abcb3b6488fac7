// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file prescription_rows.h
/// The steps of ReadPrescription() (prescription.h): a file's rows with their lines, of each form, and what all forms require.

#ifndef TILT_LENS_PRESCRIPTION_ROWS_H
#define TILT_LENS_PRESCRIPTION_ROWS_H

#include <string>
#include <vector>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

/// A row as it was found.
struct ReadRow
{
    PrescriptionRow row;
    int line = 0;
    bool stop = false;  ///< the file itself says that it is the stop; its index is that before it
};

/// What a file says of a lens.
struct ReadLens
{
    std::vector<ReadRow> rows;
    std::vector<double> objectDistances;  ///< as in Prescription
    int objectDistanceLine = 0;           ///< in which they are stated
};

/// What a file has written, as an error may show it: its beginning, with a question mark for what cannot be printed.
std::string Shown(const std::string& written);

/// @throws PrescriptionError
std::vector<ReadRow> ReadPbrtRows(const std::string& text);

/// Of lentil or ISET.
/// @throws PrescriptionError
ReadLens ReadJsonRows(const std::string& text, const std::string& choice);

} // namespace tilt_lens

#endif
