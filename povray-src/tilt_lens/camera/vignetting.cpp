// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/camera/vignetting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tilt_lens/camera/frame_table.h"
#include "tilt_lens/math/numbers.h"
#include "tilt_lens/camera/partly_covered.h"

namespace tilt_lens
{

namespace
{

/// Linear interpolation errs by less than 1/10000.
constexpr int kTableSide = 65;

constexpr int kCountSide = 128;

} // namespace

Vignetting::Vignetting(std::shared_ptr<const Lens> itsLens, const Aperture& aperture, const Character& character) :
    lens(std::move(itsLens)), natural(character.naturalVignetting)
{
    middle = Falloff({0.0, 0.0});
    if (character.opticalVignetting == 0.0 || lens->diameter == 0.0)
        return;
    rimRadius = 0.5 * (character.rimStop ? lens->focalLength / *character.rimStop : lens->diameter);
    const double corner = 0.5 * std::hypot(Length(lens->right), Length(lens->up)) / Dot(lens->direction, lens->axis);
    rimDistance = character.opticalVignetting * 2.0 * rimRadius / corner;
    Tabulate(aperture);
    const double share = OpenShare({0.0, 0.0});
    if (!(share > kLeastOpen))
        throw OpticsError("optical_vignetting " + Number(character.opticalVignetting) + " leaves " + Number(100.0 * share) +
                          " per cent of the aperture open in the middle of the turned or shifted picture. More than 1 is needed; give "
                          "a smaller number, or turn or shift less.");
    exposure = 1.0 / share;
}

/// The fall-off arises behind the lens, so distortion does not change it.
double Vignetting::Falloff(const FilmPoint& film) const
{
    const Vec3 chief = IdealChiefRay(*lens, film);
    const double square = Dot(chief, chief);
    return Dot(chief, lens->axis) * Dot(chief, lens->normal) / (square * square);
}

double Vignetting::Brightness(const FilmPoint& film) const
{
    const double falloff = natural == 0.0 ? 1.0 : 1.0 - natural + natural * std::max(0.0, Falloff(film) / middle);
    return exposure * falloff;
}

Vignetting::Opening Vignetting::OpeningFor(const FilmPoint& film) const
{
    const LensRay ray = MakeRay(*lens, film.x, film.y, 0.0, 0.0);
    const double lensRadius = 0.5 * lens->diameter, part = rimDistance / Dot(ray.direction, lens->normal);
    const double perRadius = part / (lensRadius * lensRadius);
    return {1.0 - part * ray.w, perRadius * Dot(ray.direction, lens->lensX), perRadius * Dot(ray.direction, lens->lensY),
            rimRadius / lensRadius};
}

/// Points near the opening's edge count in part.
void Vignetting::Tabulate(const Aperture& aperture)
{
    std::vector<AperturePoint> points;
    for (int i = 0; i < kCountSide; i++)
        for (int j = 0; j < kCountSide; j++)
            points.push_back(aperture((i + 0.5) / kCountSide, (j + 0.5) / kCountSide));
    for (int row = 0; row < kTableSide; row++)
        for (int column = 0; column < kTableSide; column++)
        {
            const Opening opening = OpeningFor(FilmPointOfPlace(kTableSide, row, column));
            const double ramp = kCountSide / (4.0 * std::fabs(opening.m) * opening.radius);
            double sum = 0.0;
            for (const AperturePoint& point : points)
                sum += std::min(1.0, std::max(0.0, 0.5 + ramp * opening.Left(point)));
            open.push_back(float(sum / points.size()));
        }
}

double Vignetting::OpenShare(const FilmPoint& film) const
{
    if (open.empty())
        return 1.0;
    const TablePlace place = PlaceOf(kTableSide, film);
    const float* at = &open[place.at];
    const double above = at[0] + place.right * (at[1] - at[0]);
    const double below = at[kTableSide] + place.right * (at[kTableSide + 1] - at[kTableSide]);
    return above + place.down * (below - above);
}

bool Vignetting::Passes(const FilmPoint& film, const AperturePoint& point) const
{
    return open.empty() || OpeningFor(film).Left(point) >= 0.0;
}

double Vignetting::DrawPoint(const Aperture& aperture, const FilmPoint& film, double u, double v, std::uint32_t seed,
                             AperturePoint& point) const
{
    point = aperture(u, v);
    const double brightness = Brightness(film);
    if (open.empty())
        return brightness;
    const double share = OpenShare(film);
    if (!(share > 0.0))
        return 0.0;
    const Opening opening = OpeningFor(film);
    UniformNumbers uniform(seed);
    for (int i = 0; i < kTries && !(opening.Left(point) >= 0.0); i++)
    {
        const double first = uniform(), second = uniform();
        point = aperture(first, second);
    }
    return opening.Left(point) >= 0.0 ? brightness / DrawDensity(film) : 0.0;
}

double Vignetting::DrawDensity(const FilmPoint& film) const
{
    const double share = OpenShare(film);
    return share > 0.0 ? (1.0 - std::pow(1.0 - share, kTries + 1)) / share : 0.0;
}

} // namespace tilt_lens
