// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/lamp_search.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/math/numbers.h"
#include "tilt_lens/reconstruction/blur_ellipse.h"

namespace tilt_lens
{

namespace
{

/// Half of the longer side of the rectangle around a point's circle of confusion, pixels. The point is on a ray through the lens centre.
/// @param distance  along the ray
double BlurOfPoint(const SampledCamera& camera, const FilmPoint& film, const LensRay& ray, double distance)
{
    const BlurEllipse blur(camera.footprint.CircleOf(film, {0.0, 0.0}, Length(ray.direction) / distance - ray.w));
    return std::sqrt(std::max(blur.xx, blur.yy));
}

double MarginOf(const SampledCamera& camera, double width, double height)
{
    double blur = 0.0;
    for (const FilmPoint film : {FilmPoint{0.0, 0.0}, {-0.5, -0.5}, {-0.5, 0.5}, {0.5, -0.5}, {0.5, 0.5}})
        blur = std::max(blur, BlurOfPoint(camera, film, MakeRay(camera.lens->Solved(), film.x, film.y, 0.0, 0.0), HUGE_VAL));
    return std::ceil(std::min(Settings::searchMargin * std::max(width, height), blur));
}

/// Side of a cell, pixels.
/// @param rays    for each pixel of the sharp picture
/// @param pixels  of this picture
double SideOf(double rays, double pixels)
{
    return std::sqrt(std::max(1.0 / rays, pixels / Settings::searchCells));
}

} // namespace

LampSearch::LampSearch(SampledCamera& itsCamera, std::uint32_t itsWidth, std::uint32_t itsHeight, double mostRays) :
    camera(itsCamera), width(itsWidth), height(itsHeight), margin(MarginOf(camera, width, height))
{
    const double pixels = (width + 2.0 * margin) * (height + 2.0 * margin);  // with the margin
    const double most = mostRays * width * height / pixels;
    const double coarse = SideOf(std::min(1.0, most), pixels);
    fine = most < 2.0 ? coarse : SideOf(std::min(Settings::searchRays, most - 1.0), pixels);
    Begin(coarse);
}

void LampSearch::Begin(double itsSide)
{
    side = itsSide;
    cells = BrightCells(std::size_t(std::ceil((width + 2.0 * margin) / side)), std::size_t(std::ceil((height + 2.0 * margin) / side)));
    MarkKnown();
    tasks.BeginRound(cells.Rows());
}

void LampSearch::MarkKnown()
{
    for (const EmitterSampling::SharpImage& image : camera.emitters.SharpImages())
    {
        const auto cellAt = [this](double pixel, std::size_t count)
        { return std::size_t(std::clamp(std::floor((pixel + margin) / side), 0.0, double(count))); };
        const double reach = image.radius + 1.0;
        const std::size_t right = cellAt(image.x + reach + side, cells.Columns()), bottom = cellAt(image.y + reach + side, cells.Rows());
        for (std::size_t row = cellAt(image.y - reach, cells.Rows()); row < bottom; row++)
            for (std::size_t column = cellAt(image.x - reach, cells.Columns()); column < right; column++)
                cells[row * cells.Columns() + column].known = true;
    }
}

PixelSampler LampSearch::SamplerOf(std::size_t place) const
{
    return PixelSampler(std::uint32_t(place % cells.Columns()), std::uint32_t(place / cells.Columns()), camera.seed);
}

/// A random ray of the cell, so that no regular pattern falls between the rays.
LampSearch::CellRay LampSearch::RayOf(std::size_t place) const
{
    const SequencePoint point = SamplerOf(place)(0);
    const double x = (place % cells.Columns() + point.pixelX) * side - margin, y = (place / cells.Columns() + point.pixelY) * side - margin;
    const FilmPoint film = FilmPointAt(x, y, width, height);
    return {film, MakeRay(camera.lens->Solved(), film.x, film.y, 0.0, 0.0)};
}

void LampSearch::Take(std::size_t row, RayTracer& rayTracer)
{
    const auto trace = [&]
    {
        CameraRays one{};
        for (std::size_t place = row * cells.Columns(); place < (row + 1) * cells.Columns(); place++)
        {
            const CellRay ray = RayOf(place);
            one.samples.Put(0, {ray.film.x, ray.film.y, {0.0, 0.0}, 1.0, 0.0});
            one.Put(0, ray.ray);
            Hit hit;
            rayTracer.Trace(one, {0, 1, 0, SamplerOf(place), true}, &hit);
            const double brightest = std::max({hit.radiance[0], hit.radiance[1], hit.radiance[2]});
            cells[place].radiance = std::isfinite(brightest) ? FiniteFloat(brightest) : 0.0f;
            cells[place].distance = FiniteFloat(hit.distance);
        }
    };
    tasks.Take(row, trace, [this] { End(); });
}

/// Relative to the lens centre. Points at infinity are placed so far away that all of the lens sees them in the same direction.
Vec3 LampSearch::PointOf(std::size_t place) const
{
    constexpr double far = 1e6;  // lens diameters
    const Vec3 direction = RayOf(place).ray.direction;
    return (std::min<double>(cells[place].distance, far * camera.lens->Solved().diameter) / Length(direction)) * direction;
}

/// Radius of a cell's circle of confusion, in cells: at least one, at most all.
std::size_t LampSearch::BlurOf(std::size_t place) const
{
    const CellRay ray = RayOf(place);
    const double blur = BlurOfPoint(camera, ray.film, ray.ray, cells[place].distance) / side, most = double(cells.Count());
    return std::size_t(blur < most ? std::max(1.0, std::ceil(blur)) : most);
}

bool LampSearch::AllKnown(const Places& part) const
{
    return std::all_of(part.begin(), part.end(), [this](std::size_t place) { return cells[place].known; });
}

Emitter LampSearch::LampOf(const Places& part) const
{
    Emitter lamp{{0.0, 0.0, 0.0}, 0.0, 0.0, cells.RadianceAround(part)};
    for (const std::size_t place : part)
    {
        lamp.centre = lamp.centre + (1.0 / part.size()) * PointOf(place);
        lamp.radiance += cells[place].radiance / part.size();
    }
    for (const std::size_t place : part)
        lamp.radius = std::max(lamp.radius, Length(PointOf(place) - lamp.centre));
    lamp.radius += std::sqrt(0.5) * side * camera.emitters.SizeOfPixelAt(lamp.centre);
    return lamp;
}

std::vector<Emitter> LampSearch::Found() const
{
    std::vector<Emitter> found;
    const BrightShares shares(cells);
    cells.ForEachPart([&](const Places& part)
    {
        const std::size_t middle = part[part.size() / 2];
        if (!AllKnown(part) && shares(middle, BlurOf(middle)) <= Settings::searchShare)
            found.push_back(LampOf(part));
    });
    return found;
}

/// After the last row: finer cells follow if the lamps cover enough pixels.
void LampSearch::End()
{
    rays += cells.Count();
    const std::vector<Emitter> found = Found();
    EmitterSampling emitters = camera.emitters;
    emitters.Add(camera.limits, found);
    const double covered = emitters.PixelsCovered() - camera.emitters.PixelsCovered();
    if (fine < side && covered > Settings::searchCover * width * height)
        return Begin(fine);
    lamps = emitters.Count() - camera.emitters.Count();
    camera.emitters.Add(camera.limits, found);
    cells = BrightCells();
    tasks.BeginRound(0);
}

} // namespace tilt_lens
