// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/lens_camera/glass_camera.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "tilt_lens/camera/frame_table.h"
#include "tilt_lens/math/numbers.h"
#include "tilt_lens/camera/partly_covered.h"

namespace tilt_lens
{

GlassCamera::GlassCamera(std::shared_ptr<const SolvedLens> itsLens, const Aperture& aperture, double itsNatural) :
    lens(std::move(itsLens)),
    glass(*lens->glass),
    natural(itsNatural),
    axisX(Normalized(lens->lensX)),
    axisY(Normalized(lens->lensY))
{
    if (!aperture.IsDisc())
        glass.ShapeStop([aperture](const StopPoint& stop) { return aperture.Density({stop.a, stop.b}) > 0.0; });
    if (lens->dispersion)
        colours.emplace(glass, *lens->dispersion);
    PlaceFilm();
    Tabulate();
    const Node& middle = nodes[nodes.size() / 2];
    if (!middle.seen || !(middle.open > kLeastOpen))
        throw std::invalid_argument("The lens of the prescription leaves " + Number(100.0 * middle.open) + " per cent of its stop open in the "
                                    "middle of the picture: its image circle ends before. More than 1 is needed; turn or shift the "
                                    "lens less, or stop it down.");
    middleOpen = middle.open;
    middleNatural = middle.natural;
    FillUnseen();
}

/// The film lies behind the lens, upside down.
void GlassCamera::PlaceFilm()
{
    const double scale = -lens->filmDistance / (Dot(lens->direction, lens->axis) * lens->millimetre);
    const auto inLens = [&](const Vec3& v) { return scale * Vec3{Dot(v, axisX), Dot(v, axisY), Dot(v, lens->normal)}; };
    filmMiddle = inLens(lens->direction) - Vec3{0.0, 0.0, glass.Cardinal().separation};
    filmRight = inLens(lens->right);
    filmUp = inLens(lens->up);
}

GlassCamera::Node GlassCamera::NodeAt(const FilmPoint& film, std::optional<PupilPoint>& near) const
{
    const Vec3 place = FilmInLens(film);
    Node node;
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
    // the solid angle is projected on the lens's plane; the film is tilted against it
    if (const std::optional<GlassRay> ray = RayTowards(place, view->bounds.centre))
    {
        const Vec3 filmNormal{Dot(lens->axis, axisX), Dot(lens->axis, axisY), Dot(lens->axis, lens->normal)};
        node.natural = view->stop * std::max(0.0, Dot(ray->direction, filmNormal)) / ray->direction.z;
    }
    node.seen = true;
    return node;
}

void GlassCamera::Tabulate()
{
    for (int row = 0; row < kTableSide; row++)
    {
        std::optional<PupilPoint> near;
        for (int column = 0; column < kTableSide; column++)
            nodes.push_back(NodeAt(FilmPointOfPlace(kTableSide, row, column), near));
    }
}

/// Gives entries without any light the ellipse of the nearest lit entry, because points between the two may be lit.
void GlassCamera::FillUnseen()
{
    const std::vector<Node> found = nodes;
    for (int at = 0; at < kTableSide * kTableSide; at++)
    {
        if (found[at].seen)
            continue;
        int nearest = 0, least = 4 * kTableSide * kTableSide;
        for (int other = 0; other < kTableSide * kTableSide; other++)
        {
            const int right = other % kTableSide - at % kTableSide, down = other / kTableSide - at / kTableSide;
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

PupilEllipse GlassCamera::BoundsOf(const Node& node, const Vec3& place) const
{
    const PupilPoint aim = ParaxialAim(glass.Cardinal(), place);
    return {{aim.l + node.l, aim.m + node.m}, node.radial, node.tangential};
}

PupilEllipse GlassCamera::BoundsAt(const FilmPoint& film) const { return BoundsOf(Between(film), FilmInLens(film)); }

double GlassCamera::Brightness(const FilmPoint& film) const
{
    const Node node = Between(film);
    return BrightnessOf(node.open, node.natural);
}

double GlassCamera::OpenShare(const FilmPoint& film) const { return Between(film).open; }

} // namespace tilt_lens
