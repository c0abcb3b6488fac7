// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tilt_lens/camera/frame_table.h"
#include "tilt_lens/camera/partly_covered.h"
#include "tilt_lens/math/kernels.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

void Copy(std::size_t i, const FourGlassRays& from, FourGlassRays& to)
{
    for (int axis = 0; axis < 3; axis++)
    {
        to.origin[axis][i] = from.origin[axis][i];
        to.direction[axis][i] = from.direction[axis][i];
    }
}

/// From the lens's axes to those of the ellipses.
void TurnAimed(const FourGlassPoints& points, const FourPupils& pupils, std::array<double, 4>& a, std::array<double, 4>& b)
{
    for (int i = 0; i < 4; i++)
        if ((points.aimed >> i & 1u) != 0)
        {
            a[i] = pupils.axisL[i] * points.u[i] + pupils.axisM[i] * points.v[i];
            b[i] = pupils.axisL[i] * points.v[i] - pupils.axisM[i] * points.u[i];
        }
}

} // namespace

GlassCamera::GlassCamera(std::shared_ptr<const SolvedLens> itsLens, const Aperture& aperture, double natural) :
    lens(std::move(itsLens)),
    glass(*lens->glass),
    frame{lens.get(), glass.Cardinal(), natural, Normalized(lens->lensX), Normalized(lens->lensY), {}, {}, {}}
{
    if (!aperture.IsDisc())
        glass.ShapeStop([aperture](const StopPoint& stop) { return aperture.Density({stop.a, stop.b}) > 0.0; });
    if (lens->dispersion)
        colours.emplace(glass, *lens->dispersion);
    PlaceFilm();
    Tabulate();
    const PupilNode& middle = nodes[nodes.size() / 2];
    if (!middle.seen || !(middle.open > kLeastOpen))
        throw std::invalid_argument("The lens of the prescription leaves " + Number(100.0 * middle.open) +
                                    " per cent of its stop open in the "
                                    "middle of the picture: its image circle ends before. More than 1 is needed; turn or shift the "
                                    "lens less, or stop it down.");
    frame.middleOpen = middle.open;
    frame.middleNatural = middle.natural;
    FillUnseen();
}

void GlassCamera::PlaceFilm()
{
    const double scale = -lens->filmDistance / (Dot(lens->direction, lens->axis) * lens->millimetre);
    const auto inLens = [&](const Vec3& v) { return scale * Vec3{Dot(v, frame.axisX), Dot(v, frame.axisY), Dot(v, lens->normal)}; };
    frame.middle = inLens(lens->direction) - Vec3{0.0, 0.0, glass.Cardinal().separation};
    frame.right = inLens(lens->right);
    frame.up = inLens(lens->up);
}

PupilNode GlassCamera::NodeAt(const FilmPoint& film, std::optional<PupilPoint>& near) const
{
    const Vec3 place = FilmInLens(film);
    PupilNode node;
    const std::optional<PupilView> view = ViewOf(glass, place, near);
    if (!view)
        return node;
    near = view->bounds.centre;
    const PupilPoint aim = ParaxialAim(glass.Cardinal(), place);
    node.l = view->bounds.centre.l - aim.l;
    node.m = view->bounds.centre.m - aim.m;
    node.radial = view->bounds.radial;
    node.tangential = view->bounds.tangential;
    node.open = view->open / view->stop;
    node.passing = view->open / (kPi * node.radial * node.tangential);
    // the solid angle is projected on the lens's plane, not on the film
    if (const std::optional<GlassRay> ray = RayTowards(place, view->bounds.centre))
    {
        const Vec3 filmNormal{Dot(lens->axis, frame.axisX), Dot(lens->axis, frame.axisY), Dot(lens->axis, lens->normal)};
        node.natural = view->stop * std::max(0.0, Dot(ray->direction, filmNormal)) / ray->direction.z;
    }
    node.seen = true;
    return node;
}

void GlassCamera::Tabulate()
{
    for (int row = 0; row < kPupilTableSide; row++)
    {
        std::optional<PupilPoint> near;
        for (int column = 0; column < kPupilTableSide; column++)
            nodes.push_back(NodeAt(FilmPointOfPlace(kPupilTableSide, row, column), near));
    }
}

/// Gives dark entries the nearest lit ellipse, since points between may be lit.
void GlassCamera::FillUnseen()
{
    const std::vector<PupilNode> found = nodes;
    for (int at = 0; at < kPupilTableSide * kPupilTableSide; at++)
    {
        if (found[at].seen)
            continue;
        int nearest = 0, least = 4 * kPupilTableSide * kPupilTableSide;
        for (int other = 0; other < kPupilTableSide * kPupilTableSide; other++)
        {
            const int right = other % kPupilTableSide - at % kPupilTableSide, down = other / kPupilTableSide - at / kPupilTableSide;
            if (found[other].seen && right * right + down * down < least)
            {
                nearest = other;
                least = right * right + down * down;
            }
        }
        nodes[at] = found[nearest];
        nodes[at].open = 0.0;
    }
}

PupilEllipse GlassCamera::BoundsOf(const PupilNode& node, const Vec3& place) const
{
    const PupilPoint aim = ParaxialAim(glass.Cardinal(), place);
    return {{aim.l + node.l, aim.m + node.m}, node.radial, node.tangential};
}

PupilEllipse GlassCamera::BoundsAt(const FilmPoint& film) const
{
    return BoundsOf(Between(film), FilmInLens(film));
}

double GlassCamera::Brightness(const FilmPoint& film) const
{
    const PupilNode node = Between(film);
    return frame.Brightness(node.open, node.natural);
}

double GlassCamera::OpenShare(const FilmPoint& film) const
{
    return Between(film, &PupilNode::open);
}

double GlassCamera::PassingShare(const FilmPoint& film) const
{
    return Between(film, &PupilNode::passing);
}

double GlassCamera::Between(const FilmPoint& film, double PupilNode::* number) const
{
    const double x[] = {film.x, film.x}, y[] = {film.y, film.y};
    return PupilInterpolation<Double2>(nodes.data(), x, y)(number)[0];
}

PupilNode GlassCamera::Between(const FilmPoint& film) const
{
    const double x[] = {film.x, film.x}, y[] = {film.y, film.y};
    const PupilInterpolation<Double2> mean(nodes.data(), x, y);
    PupilNode node;
    for (double PupilNode::* const number :
         {&PupilNode::l, &PupilNode::m, &PupilNode::radial, &PupilNode::tangential, &PupilNode::open, &PupilNode::natural})
        node.*number = mean(number)[0];
    return node;
}

/// @param waiting  one bit per film point that needs a ray
/// @return         one bit per ray
unsigned int GlassCamera::DrawRays(const GlassLens::Four& lenses, const FourGlassPoints& points, const FourPupils& pupils,
                                   unsigned int waiting, FourGlassRays& drawn, FourGlassSamples& samples) const
{
    unsigned int found = 0;
    std::array<double, 4> u, v, a, b;
    std::copy(points.u, points.u + 4, u.begin());
    std::copy(points.v, points.v + 4, v.begin());
    UniformNumbers uniform[4] = {UniformNumbers(points.seed[0]), UniformNumbers(points.seed[1]), UniformNumbers(points.seed[2]),
                                 UniformNumbers(points.seed[3])};
    for (int tries = 0; waiting != 0 && tries <= kTries; tries++)
    {
        FourGlassRays rays;
        disc.Map(u.data(), v.data(), a.data(), b.data(), 4);
        TurnAimed(points, pupils, a, b);
        FourStopPoints stop;
        const unsigned int passed = kernels->aimAtPupils(pupils, a.data(), b.data(), rays) & GlassLens::Trace(lenses, rays, stop);
        for (int i = 0; i < 4; i++)
        {
            if ((waiting >> i & 1u) == 0)
                continue;
            if ((passed >> i & 1u) != 0)
            {
                Copy(i, rays, drawn);
                samples.a[i] = pupils.axisL[i] * a[i] - pupils.axisM[i] * b[i];
                samples.b[i] = pupils.axisL[i] * b[i] + pupils.axisM[i] * a[i];
                found |= 1u << i;
            }
            if (((passed | points.aimed) >> i & 1u) != 0)
            {
                waiting &= ~(1u << i);
                continue;
            }
            // blocked: another direction
            samples.refused[i]++;
            u[i] = uniform[i]();
            v[i] = uniform[i]();
        }
    }
    return found;
}

void GlassCamera::DrawThrough(const GlassLens::Four& lenses, const FourGlassPoints& points, FourGlassSamples& samples) const
{
    FourPupils pupils;
    kernels->findPupils(frame, nodes.data(), points, pupils);
    FourGlassRays drawn{};
    std::fill(samples.refused, samples.refused + 4, 0u);
    const unsigned int found = DrawRays(lenses, points, pupils, points.wanted & pupils.seen, drawn, samples);
    kernels->leaveGlass(frame, points, drawn, samples);
    for (std::size_t i = 0; i < 4; i++)
        samples.weight[i] = (found >> i & 1u) != 0 ? pupils.brightness[i] : 0.0;
}

void GlassCamera::DrawColours(const FourGlassPoints& points, const std::array<double, 3>& hues, FourGlassSamples& samples) const
{
    DrawThrough({&LensOf(hues[0]), &LensOf(hues[1]), &LensOf(hues[2]), &glass}, points, samples);
}

unsigned int GlassCamera::Aim(const FourGlassPoints& points, double hue, FourGlassSamples& samples) const
{
    FourPupils pupils;
    kernels->findPupils(frame, nodes.data(), points, pupils);
    std::array<double, 4> a{}, b{};
    TurnAimed(points, pupils, a, b);
    FourGlassRays rays;
    FourStopPoints stop;
    unsigned int found = kernels->aimAtPupils(pupils, a.data(), b.data(), rays);
    LensOf(hue).Trace(rays, stop);
    kernels->leaveGlass(frame, points, rays, samples);
    for (int i = 0; i < 4; i++)
        if (!std::isfinite(samples.origin[0][i] + samples.direction[0][i]))
            found &= ~(1u << i);
    return found;
}

GlassSample GlassCamera::Draw(const FilmPoint& film, double u, double v, std::uint32_t seed) const
{
    FourGlassSamples samples;
    Draw({{film.x}, {film.y}, {u}, {v}, {seed}, 1}, samples);
    return {samples.RayOf(0), samples.weight[0], samples.refused[0]};
}

std::optional<LensRay> GlassCamera::MiddleRay(const FilmPoint& film) const
{
    const PupilNode node = Between(film);
    const Vec3 place = FilmInLens(film);
    std::optional<GlassRay> ray = RayTowards(place, BoundsOf(node, place).centre);
    StopPoint stop;
    if (!(node.open > 0.0) || !ray || glass.Trace(*ray, stop) != Passage::Passed)
        return {};
    return frame.ToWorld(film.x, film.y, *ray);
}

} // namespace tilt_lens
