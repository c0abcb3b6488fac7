// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/dispersion.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

/// Per third of the spectrum.
constexpr int kWavelengths = 16;

double NormalPartialDispersion(double abbe)
{
    return 0.6438 - 0.001682 * abbe;
}

double InverseSquare(double wavelength)
{
    return 1.0 / (wavelength * wavelength);
}

} // namespace

double IndexAt(double index, double abbe, double wavelength)
{
    if (abbe == 0.0)
        return index;
    const double C = InverseSquare(kLineC), d = InverseSquare(kLineD), F = InverseSquare(kLineF), g = InverseSquare(kLineG);
    const double dispersion = (index - 1.0) / abbe;
    const double slopeFC = dispersion / (F - C), slopeGF = NormalPartialDispersion(abbe) * dispersion / (g - F);
    const double c = (slopeGF - slopeFC) / (g - C), b = slopeFC - c * (F + C), x = InverseSquare(wavelength);
    return index + (x - d) * (b + c * (x + d));
}

Prescription AtWavelength(const Prescription& prescription, double wavelength)
{
    Prescription coloured = prescription;
    for (PrescriptionRow& row : coloured.rows)
        row.index = IndexAt(row.index, row.abbe, wavelength);
    return coloured;
}

void RequireAbbeNumbers(const Prescription& prescription)
{
    for (const PrescriptionRow& row : prescription.rows)
        if (row.index != 1.0 && row.abbe == 0.0)
            throw PrescriptionError(row.line, "a glass of index " + Number(row.index) +
                                                  " without an Abbe number, which dispersion needs. "
                                                  "Give it, as the fifth number of a row or as \"abbe\" in JSON, or remove dispersion.");
}

GlassOfColours::GlassOfColours(const GlassLens& lens, const Prescription& prescription)
{
    const int count = 3 * kWavelengths;
    for (int i = 0; i < count; i++)
    {
        lenses.push_back(lens);
        lenses.back().TakeIndices(AtWavelength(prescription, WavelengthOf(2.0 * (i + 0.5) / count - 1.0)));
    }
}

const GlassLens& GlassOfColours::Of(double hue) const
{
    const int count = int(lenses.size()), place = int(std::ceil(0.5 * (hue + 1.0) * count)) - 1;
    return lenses[std::clamp(place, 0, count - 1)];
}

} // namespace tilt_lens
