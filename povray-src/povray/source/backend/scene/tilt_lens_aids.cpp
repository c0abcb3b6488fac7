// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "backend/scene/tilt_lens_aids.h"

#include <cmath>
#include <cstdio>

#include "base/povdebug.h"

namespace pov
{

using tilt_lens::Rgb;

namespace
{

void Lay(Colour& under, const Colour& over, double opacity)
{
    under *= COLC(1.0 - opacity);
    under += over * COLC(opacity);
}

} // namespace

TiltLensAids::TiltLensAids(const tilt_lens::FocusAids& theAids, const shared_ptr<const tilt_lens::LensCamera>& theCamera, int itsWidth,
                           int itsHeight, pov_base::GammaCurvePtr theDisplay) :
    aids(theAids),
    camera(theCamera),
    width(itsWidth),
    scale(itsWidth, itsHeight),
    planes(camera->Solved(), itsWidth, itsHeight),
    display(theDisplay)
{
}

Colour TiltLensAids::Light(const Rgb& shown) const
{
    return Colour(pov_base::GammaCurve::Decode(display, shown.red), pov_base::GammaCurve::Decode(display, shown.green),
                  pov_base::GammaCurve::Decode(display, shown.blue));
}

Colour TiltLensAids::Drawn(int x, int y, const tilt_lens::FilmPoint& film, double depth, const Colour& picture) const
{
    const double blur = camera->Blur(film, depth, width);
    if (aids.map)
        return Light(scale.At(x, y).value_or(tilt_lens::FocusMapColour(blur)));

    Colour drawn = picture;
    const Rgb& tint = aids.peakingColour;
    if (aids.peaking && std::fabs(blur) < aids.peakingPixels)
        Lay(drawn, Colour(tint.red, tint.green, tint.blue), tilt_lens::kPeakingTint);
    if (aids.planes)
    {
        const tilt_lens::SolvedLens& lens = camera->Solved();
        const std::vector<tilt_lens::Veil> veils = planes.Before(x, y, depth / Dot(lens.direction, lens.axis));
        for (auto veil = veils.rbegin(); veil != veils.rend(); ++veil)
            Lay(drawn, Light(veil->colour), veil->opacity);
    }
    return drawn;
}

std::string TiltLensAids::Describe() const
{
    char text[160] = "";
    if (aids.map)
        return "  Drawn................focus_map: blue behind the sharp plane, orange before it\n";
    std::string drawn;
    if (aids.peaking)
    {
        std::snprintf(text, sizeof text, "  Drawn................focus_peaking: tinted where blurred under %.4g pixels\n",
                      aids.peakingPixels);
        drawn += text;
    }
    if (aids.planes)
    {
        std::snprintf(text, sizeof text, "  Drawn................show_planes: the sharp plane's grid has %.4g units\n",
                      planes.GridSpacing());
        drawn += text;
    }
    return drawn;
}

} // namespace pov
