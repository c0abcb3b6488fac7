// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/prescription.h"

#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/glass/inner_focus.h"
#include "tilt_lens/glass/prescription_rows.h"

namespace tilt_lens
{

namespace
{

constexpr std::size_t kMostRows = 200;

/// Glass has up to 2.2 in visible light, germanium 4 in the infrared.
constexpr double kMostIndex = 4.0;

/// Glasses have 15 to 95.
constexpr double kLeastAbbe = 10.0, kMostAbbe = 150.0;

void RequireSensible(const ReadRow& read, bool last)
{
    const PrescriptionRow& row = read.row;
    if (!std::isfinite(row.radius) || !std::isfinite(row.conic))
        throw PrescriptionError(read.line, "a radius or conic constant that is not finite. Write a plane as radius 0.");
    if (!(row.diameter > 0.0) || !std::isfinite(row.diameter))
        throw PrescriptionError(read.line, "a clear diameter of " + Number(row.diameter) +
                                               ". It must be larger than 0; give the "
                                               "diameter that lets light through.");
    if (!(row.thickness >= 0.0 || last) || !std::isfinite(row.thickness))
        throw PrescriptionError(read.line, "a thickness of " + Number(row.thickness) +
                                               ". It is the distance to the next surface "
                                               "towards the film and must not be negative.");
    for (const double near : row.nearThickness)
        if (!(near >= 0.0 || last) || !std::isfinite(near))
            throw PrescriptionError(read.line, "a thickness of " + Number(near) +
                                                   " for a near focus. It is the distance to the next surface "
                                                   "towards the film and must not be negative.");
    if (!(row.index >= 1.0 && row.index <= kMostIndex))
        throw PrescriptionError(read.line, "an index of refraction of " + Number(row.index) +
                                               ". It must be from 1 (air; pbrt's files "
                                               "may have 0) to " +
                                               Number(kMostIndex) + ".");
    if (!(row.abbe == 0.0 || (row.abbe >= kLeastAbbe && row.abbe <= kMostAbbe)))
        throw PrescriptionError(read.line, "an Abbe number of " + Number(row.abbe) + ". It must be from " + Number(kLeastAbbe) + " to " +
                                               Number(kMostAbbe) + "; give 0 or none where it is not known, and in air.");
}

/// Gives marked stops the medium before them. Unmarked, the stop is the only plane within one medium.
std::size_t FindStop(std::vector<ReadRow>& rows)
{
    std::vector<std::size_t> marked, planes;
    double before = 1.0, abbeBefore = 0.0;
    for (std::size_t i = 0; i < rows.size(); i++)
    {
        PrescriptionRow& row = rows[i].row;
        if (rows[i].stop)
        {
            row.index = before;
            row.abbe = abbeBefore;
        }
        if (rows[i].stop && row.radius != 0.0)
            throw PrescriptionError(rows[i].line, "a stop that is curved. It must be a plane; give it a row of its own.");
        if (rows[i].stop)
            marked.push_back(i);
        else if (row.radius == 0.0 && row.index == before && row.aspheric.empty())
            planes.push_back(i);
        before = row.index;
        abbeBefore = row.abbe;
    }
    const std::vector<std::size_t>& stops = marked.empty() ? planes : marked;
    if (stops.empty())
        throw PrescriptionError(0, "no stop. One row must be the aperture stop: radius 0 and index 0 in the forms of pbrt and ISET, the "
                                   "material \"iris\" in lentil's.");
    if (stops.size() > 1)
        throw PrescriptionError(rows[stops[1]].line, "a second stop (the first is in line " + std::to_string(rows[stops[0]].line) +
                                                         "). One row is the aperture stop; give a further rim in air the index 1, a "
                                                         "plane surface of glass an index of its own.");
    return stops[0];
}

} // namespace

std::string Shown(const std::string& written)
{
    constexpr std::size_t most = 40;
    std::string shown = written.substr(0, most);
    for (char& c : shown)
        if ((unsigned char)c < ' ' || c == 0x7F)
            c = '?';
    return shown;
}

Prescription ReadPrescription(const std::string& text, const std::string& choice)
{
    const std::size_t start = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (start == std::string::npos)
        throw PrescriptionError(1, "nothing: the file is empty.");
    const bool json = text[start] == '{' || text[start] == '[';
    if (!json && !choice.empty())
        throw PrescriptionError(0, "one lens, but '#" + choice + "' behind the file's name chooses one of several. Remove it.");
    ReadLens read = json ? ReadJsonRows(text, choice) : ReadLens{ReadPbrtRows(text), {}, 0};
    std::vector<ReadRow>& rows = read.rows;
    if (rows.size() < 2 || rows.size() > kMostRows)
        throw PrescriptionError(0, std::to_string(rows.size()) + " surfaces. A lens has 2 to " + std::to_string(kMostRows) + ".");
    Prescription prescription;
    prescription.stop = FindStop(rows);
    for (std::size_t i = 0; i < rows.size(); i++)
    {
        RequireSensible(rows[i], i + 1 == rows.size());
        prescription.rows.push_back(rows[i].row);
        prescription.rows.back().line = rows[i].line;
    }
    if (rows[0].row.thickness == 0.0 && prescription.stop != 0)
        throw PrescriptionError(rows[0].line, "a thickness of 0 behind the first surface. In some old files the second column is the "
                                              "distance from the surface before; move that column up by one row.");
    if (prescription.rows.back().index != 1.0)
        throw PrescriptionError(rows.back().line, "an index of " + Number(prescription.rows.back().index) +
                                                      " behind the last surface. "
                                                      "The film is in air; the last index must be 1.");
    prescription.objectDistances = read.objectDistances;
    RequireFocuses(prescription, read.objectDistanceLine);
    return prescription;
}

Prescription Scaled(const Prescription& prescription, double factor)
{
    Prescription scaled = prescription;
    for (double& distance : scaled.objectDistances)
        distance *= factor;
    for (PrescriptionRow& row : scaled.rows)
    {
        row.radius *= factor;
        row.thickness *= factor;
        for (double& near : row.nearThickness)
            near *= factor;
        row.diameter *= factor;
        double power = factor * factor * factor;
        for (double& coefficient : row.aspheric)
        {
            coefficient /= power;
            power *= factor * factor;
        }
    }
    return scaled;
}

} // namespace tilt_lens
