// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file prescription_rows.h
/// Readers of the three forms for ReadPrescription() (prescription.h).

#ifndef TILT_LENS_PRESCRIPTION_ROWS_H
#define TILT_LENS_PRESCRIPTION_ROWS_H

#include <string>
#include <vector>

#include "tilt_lens/glass/prescription.h"

namespace tilt_lens
{

struct ReadRow
{
    PrescriptionRow row;
    int line = 0;
    bool stop = false;  ///< marked by the file
};

struct ReadLens
{
    std::vector<ReadRow> rows;
    std::vector<double> objectDistances;
    int objectDistanceLine = 0;
};

/// Shortened for an error, with question marks for unprintable characters.
std::string Shown(const std::string& written);

/// @throws PrescriptionError
std::vector<ReadRow> ReadPbrtRows(const std::string& text);

/// Lentil's or ISET's form.
/// @throws PrescriptionError
ReadLens ReadJsonRows(const std::string& text, const std::string& choice);

} // namespace tilt_lens

#endif
