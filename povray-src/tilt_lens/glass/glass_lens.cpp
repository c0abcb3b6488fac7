// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/glass/paraxial.h"
#include "tilt_lens/math/numbers.h"

namespace tilt_lens
{

namespace
{

constexpr int kHalvings = 40;

double IndexBefore(const Prescription& prescription, std::size_t row)
{
    return row > 0 ? prescription.rows[row - 1].index : 1.0;
}

} // namespace

CardinalPoints CardinalPointsOf(const Prescription& prescription)
{
    const std::size_t count = prescription.rows.size(), stop = prescription.stop;
    const ParaxialMap whole = MapBetween(prescription, 0, count);
    if (!(whole.c < 0.0) || !std::isfinite(1.0 / whole.c))
        throw PrescriptionError(0, "a lens of focal length " + Number(-1.0 / whole.c) +
                                       " mm, which does not collect light. Are the signs "
                                       "of the radii those of the file's form (positive: centre on the side of the film)?");
    CardinalPoints points;
    points.focalLength = -1.0 / whole.c;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < count; i++)
        length += prescription.rows[i].thickness;
    const double frontPrincipal = (whole.d - 1.0) / whole.c, rearPrincipal = (1.0 - whole.a) / whole.c;
    points.frontVertex = frontPrincipal;
    points.rearVertex = frontPrincipal - length;
    points.separation = length + rearPrincipal - frontPrincipal;
    points.backFocus = whole.a * points.focalLength;

    // rays through the stop's centre have b reduced = -a height before the first surface
    const ParaxialMap before = MapBetween(prescription, 0, stop);
    points.entrancePupil = frontPrincipal - before.b / before.a;
    points.entranceRadius = 1.0 / before.a;
    const ParaxialMap behind = MapBetween(prescription, stop, count);
    points.exitPupil = points.rearVertex + behind.b / behind.d;
    points.exitMagnification = 1.0 / behind.d;
    return points;
}

GlassLens::GlassLens(const Prescription& prescription) : cardinal(CardinalPointsOf(prescription))
{
    double z = cardinal.frontVertex;
    for (std::size_t i = 0; i < prescription.rows.size(); i++)
    {
        const PrescriptionRow& row = prescription.rows[i];
        GlassSurface surface{z,
                             row.radius == 0.0 ? 0.0 : -1.0 / row.radius,
                             row.index / IndexBefore(prescription, i),
                             0.25 * row.diameter * row.diameter,
                             i == prescription.stop,
                             row.conic == 0.0 && row.aspheric.empty(),
                             row.conic,
                             {}};
        for (const double coefficient : row.aspheric)
            surface.aspheric.push_back(-coefficient);
        surfaces.insert(surfaces.begin(), surface);
        z -= row.thickness;
    }
    widestStop = stopRadius = 0.5 * prescription.rows[prescription.stop].diameter;
    cardinal.fNumber = cardinal.focalLength / (2.0 * WidestRay());
}

double GlassLens::WidestRay() const
{
    double passes = 0.0, ends = std::sqrt(surfaces.back().squaredRim);
    for (int i = 0; i < kHalvings; i++)
    {
        const double middle = 0.5 * (passes + ends);
        GlassRay ray{{middle, 0.0, cardinal.frontVertex + cardinal.focalLength}, {0.0, 0.0, -1.0}};
        StopPoint stop;
        (TraceFromScene(ray, stop) == Passage::Passed ? passes : ends) = middle;
    }
    return passes;
}

void GlassLens::TakeIndices(const Prescription& prescription)
{
    for (std::size_t i = 0; i < surfaces.size(); i++)
    {
        const std::size_t row = surfaces.size() - 1 - i;
        surfaces[i].ratio = prescription.rows[row].index / IndexBefore(prescription, row);
    }
}

void GlassLens::StopDown(double fNumber)
{
    const double height = 0.5 * cardinal.focalLength / fNumber;
    GlassRay ray{{height, 0.0, cardinal.frontVertex + cardinal.focalLength}, {0.0, 0.0, -1.0}};
    StopPoint stop{1.0, 0.0};
    TraceFromScene(ray, stop, false);
    stopRadius = std::min(widestStop, stopRadius * std::fabs(stop.a));
    for (GlassSurface& surface : surfaces)
        if (surface.stop)
            surface.squaredRim = stopRadius * stopRadius;
}

template<bool towardsScene>
inline Passage GlassLens::Cross(const GlassSurface& surface, GlassRay& ray, StopPoint& point, bool rims) const
{
    if (surface.stop)
    {
        const bool passes = CrossStop(surface, ray);
        point = {StopScale() * ray.origin.x, StopScale() * ray.origin.y};
        return passes ? Passage::Passed : Passage::Stopped;
    }
    const Crossing<double> crossing = surface.sphere ? CrossSphere<towardsScene>(surface, surface.ratio, ray)
                                                     : CrossAsphere<towardsScene>(surface, ray);
    if (!crossing.met)
        return Passage::Missed;
    if (rims && !crossing.withinRim)
        return Passage::Rim;
    return crossing.refracted ? Passage::Passed : Passage::Reflected;
}

template<bool towardsScene, class Iterator>
inline Passage GlassLens::TraceAlong(Iterator surface, Iterator end, GlassRay& ray, StopPoint& stop, bool rims) const
{
    for (; surface != end; ++surface)
    {
        const Passage passage = Cross<towardsScene>(*surface, ray, stop, rims);
        if (passage != Passage::Passed)
            return passage;
    }
    if (!Opens(stop))
        return Passage::Stopped;
    return Signed<towardsScene>(ray.direction.z) > 0.0 ? Passage::Passed : Passage::Missed;
}

Passage GlassLens::Trace(GlassRay& ray, StopPoint& stop, bool rims) const
{
    return TraceAlong<true>(surfaces.begin(), surfaces.end(), ray, stop, rims);
}

Passage GlassLens::TraceFromScene(GlassRay& ray, StopPoint& stop, bool rims) const
{
    return TraceAlong<false>(surfaces.rbegin(), surfaces.rend(), ray, stop, rims);
}

double GlassLens::RearRadius() const
{
    return std::sqrt(surfaces.front().squaredRim);
}

GlassLens::Front GlassLens::FrontBox() const
{
    const GlassSurface& front = surfaces.back();
    // an aspherical surface may bend back, so a ball around its vertex is the bound
    const double radius = std::sqrt(front.squaredRim);
    return {radius, front.z - radius, front.z + radius};
}

} // namespace tilt_lens
