// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/lens_camera.h"

namespace tilt_lens
{

namespace
{

using Kind = std::variant<Vignetting, GlassCamera>;

Kind KindOf(const std::shared_ptr<const SolvedLens>& lens, const Aperture& aperture, const Character& character)
{
    return lens->glass ? Kind(GlassCamera(lens, aperture, character.naturalVignetting)) : Kind(Vignetting(lens, aperture, character));
}

} // namespace

LensCamera::LensCamera(std::shared_ptr<const SolvedLens> itsLens, const Aperture& itsAperture, const Character& character,
                       bool itsDeflected) :
    lens(std::move(itsLens)),
    aperture(itsAperture),
    deflected(itsDeflected),
    hasRim(character.opticalVignetting != 0.0),
    kind(KindOf(lens, aperture, character))
{
}

const Vignetting& LensCamera::ThinVignetting() const
{
    static const Vignetting none;
    const Vignetting* const thin = std::get_if<Vignetting>(&kind);
    return thin != nullptr ? *thin : none;
}

bool LensCamera::HasColours() const
{
    return lens->lateralColour != 0.0 || lens->axialColour != 0.0 || lens->dispersion;
}

bool LensCamera::CanSpread() const
{
    return !deflected && !hasRim && !BendsChiefRays() && !HasColours() && lens->fieldCurvature == 0.0;
}

std::optional<LensRay> LensCamera::MiddleRay(const FilmPoint& film) const
{
    return Glass() != nullptr ? Glass()->MiddleRay(film) : MakeRay(*lens, film.x, film.y, 0.0, 0.0);
}

double LensCamera::Blur(const FilmPoint& film, double depth, double width) const
{
    return BlurDiameter(*lens, ChiefRay(*lens, film), depth / Dot(lens->direction, lens->axis), width);
}

bool IsPlainPinhole(const SolvedLens& lens, const Character& character)
{
    return lens.diameter == 0.0 && !lens.distorts && lens.lateralColour == 0.0 && character.naturalVignetting == 0.0;
}

} // namespace tilt_lens
