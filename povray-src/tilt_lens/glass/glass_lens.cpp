// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/glass/glass_lens.h"

#include <algorithm>
#include <cmath>

#include "tilt_lens/camera/numbers.h"
#include "tilt_lens/glass/paraxial.h"

namespace tilt_lens
{

namespace
{

/// Newton's steps to an aspherical surface, and how exact they must be, as a part of the ray's height or of 1 mm.
constexpr int kMostSteps = 30;
constexpr double kNearEnough = 1e-13;

/// Steps that find the widest ray to 1e-12 of the first surface.
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
        throw PrescriptionError(0, "a lens of focal length " + Number(-1.0 / whole.c) + " mm, which does not collect light. Are the signs "
                                   "of the radii those of the file's form (positive: centre on the side of the film)?");
    CardinalPoints points;
    points.focalLength = -1.0 / whole.c;
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < count; i++)
        length += prescription.rows[i].thickness;
    const double frontPrincipal = (whole.d - 1.0) / whole.c, rearPrincipal = (1.0 - whole.a) / whole.c;  // behind each vertex
    points.frontVertex = frontPrincipal;
    points.rearVertex = frontPrincipal - length;
    points.separation = length + rearPrincipal - frontPrincipal;
    points.backFocus = whole.a * points.focalLength;

    // the stop as the scene sees it: rays through its middle have b reduced = -a height before the first surface
    const ParaxialMap before = MapBetween(prescription, 0, stop);
    points.entrancePupil = frontPrincipal - before.b / before.a;
    points.entranceRadius = 1.0 / before.a;
    // and as the film sees it
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
        Surface surface{z, row.radius == 0.0 ? 0.0 : -1.0 / row.radius, row.index / IndexBefore(prescription, i),
                        0.25 * row.diameter * row.diameter, i == prescription.stop, row.conic == 0.0 && row.aspheric.empty(), row.conic, {}};
        for (const double coefficient : row.aspheric)
            surface.aspheric.push_back(-coefficient);
        surfaces.insert(surfaces.begin(), surface);
        z -= row.thickness;
    }
    widestStop = stopRadius = 0.5 * prescription.rows[prescription.stop].diameter;
    cardinal.fNumber = cardinal.focalLength / (2.0 * WidestRay());
}

/// Height of the widest ray that comes in parallel to the axis and passes: between one that does and one that does not.
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

/// The stop's radius is where the beam's outermost ray crosses it.
void GlassLens::StopDown(double fNumber)
{
    const double height = 0.5 * cardinal.focalLength / fNumber;
    GlassRay ray{{height, 0.0, cardinal.frontVertex + cardinal.focalLength}, {0.0, 0.0, -1.0}};
    StopPoint stop{1.0, 0.0};
    TraceFromScene(ray, stop, false);
    stopRadius = std::min(widestStop, stopRadius * std::fabs(stop.a));
    for (Surface& surface : surfaces)
        if (surface.stop)
            surface.squaredRim = stopRadius * stopRadius;
}

namespace
{

inline double SquaredHeight(const GlassRay& ray) { return ray.origin.x * ray.origin.x + ray.origin.y * ray.origin.y; }

/// Of the way that a ray goes.
template <bool towardsScene>
inline double Signed(double value)
{
    return towardsScene ? value : -value;
}

/// Snell's law. False where all light is reflected.
/// @param cosine  of the normal, of length 1, and the direction
/// @param ratio   index on the side of the film over that of the scene
template <bool towardsScene>
inline bool Refract(double ratio, double cosine, const Vec3& normal, Vec3& direction)
{
    if (!towardsScene)
        ratio = 1.0 / ratio;
    const double left = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if (!(left >= 0.0))
        return false;
    direction = ratio * direction + (Signed<towardsScene>(std::sqrt(left)) - ratio * cosine) * normal;
    return true;
}

} // namespace

/// Sphere or plane: c |p|^2 = 2 p.z for a point p counted from the vertex, so that along the ray c t^2 - 2 half t + constant = 0. The
/// root near the vertex is meant; the square root itself is the cosine of the ray and the normal (-c p.x, -c p.y, 1 - c p.z).
template <bool towardsScene>
inline Passage GlassLens::CrossSphere(const Surface& surface, GlassRay& ray, bool rims)
{
    const double c = surface.curvature;
    const Vec3& d = ray.direction;
    const Vec3 p{ray.origin.x, ray.origin.y, ray.origin.z - surface.z};
    const double constant = c * Dot(p, p) - 2.0 * p.z, half = d.z - c * Dot(p, d);
    const double square = half * half - c * constant;
    if (!(square >= 0.0))
        return Passage::Missed;
    const double cosine = Signed<towardsScene>(std::sqrt(square)), step = constant / (half + cosine), depth = p.z + step * d.z;
    ray.origin = {p.x + step * d.x, p.y + step * d.y, surface.z + depth};
    const Vec3 normal{-c * ray.origin.x, -c * ray.origin.y, 1.0 - c * depth};
    if (!(normal.z > 0.0))  // beyond where the sphere turns back
        return Passage::Missed;
    if (rims && SquaredHeight(ray) > surface.squaredRim)
        return Passage::Rim;
    return Refract<towardsScene>(surface.ratio, cosine, normal, ray.direction) ? Passage::Passed : Passage::Reflected;
}

/// The ray's origin moves to the conic; the normal, of any length, points to the scene. False where there is none, or the ray comes
/// from beyond where the surface turns back.
bool GlassLens::IntersectConic(const Surface& surface, GlassRay& ray, Vec3& normal)
{
    const double c = surface.curvature;
    const Vec3& d = ray.direction;
    // on the plane through the vertex
    const double way = (surface.z - ray.origin.z) / d.z;
    const double x = ray.origin.x + way * d.x, y = ray.origin.y + way * d.y;
    // c (x^2 + y^2 + (1 + conic) z^2) = 2 z along the ray: square t^2 - 2 half t + constant = 0, the root near the vertex
    const double constant = c * (x * x + y * y), half = d.z - c * (x * d.x + y * d.y);
    const double square = c * (1.0 + surface.conic * d.z * d.z);
    const double root = half * half - square * constant;
    if (!(root >= 0.0))
        return false;
    const double step = constant / (half + std::copysign(std::sqrt(root), d.z));
    const double depth = step * d.z;
    ray.origin = {x + step * d.x, y + step * d.y, surface.z + depth};
    normal = {-c * ray.origin.x, -c * ray.origin.y, 1.0 - c * (1.0 + surface.conic) * depth};
    return normal.z > 0.0;
}

/// From the conic's point by Newton's steps along the ray.
bool GlassLens::IntersectAspheric(const Surface& surface, GlassRay& ray, Vec3& normal)
{
    const double c = surface.curvature;
    for (int i = 0; i < kMostSteps; i++)
    {
        const double x = ray.origin.x, y = ray.origin.y, square = x * x + y * y;
        const double inner = 1.0 - (1.0 + surface.conic) * c * c * square;
        if (!(inner > 0.0))
            return false;
        const double root = std::sqrt(inner);
        double sag = c * square / (1.0 + root), slope = c / root;  // slope: of the sag by the height, over the height
        double power = square;
        for (std::size_t j = 0; j < surface.aspheric.size(); j++)
        {
            slope += (2.0 * j + 4.0) * surface.aspheric[j] * power;
            power *= square;
            sag += surface.aspheric[j] * power;
        }
        normal = {-slope * x, -slope * y, 1.0};
        const double step = (surface.z + sag - ray.origin.z) / Dot(normal, ray.direction);
        ray.origin = ray.origin + step * ray.direction;
        if (std::fabs(step) <= kNearEnough * (1.0 + std::sqrt(square)))
            return true;
    }
    return false;
}

template <bool towardsScene>
Passage GlassLens::CrossOther(const Surface& surface, GlassRay& ray, bool rims)
{
    Vec3 normal;
    if (!IntersectConic(surface, ray, normal) || (!surface.aspheric.empty() && !IntersectAspheric(surface, ray, normal)))
        return Passage::Missed;
    if (rims && SquaredHeight(ray) > surface.squaredRim)
        return Passage::Rim;
    normal = normal / std::sqrt(Dot(normal, normal));
    const double cosine = Dot(ray.direction, normal);
    if (!(Signed<towardsScene>(cosine) > 0.0))
        return Passage::Missed;
    return Refract<towardsScene>(surface.ratio, cosine, normal, ray.direction) ? Passage::Passed : Passage::Reflected;
}

inline Passage GlassLens::CrossStop(const Surface& surface, GlassRay& ray, StopPoint& point) const
{
    ray.origin = ray.origin + ((surface.z - ray.origin.z) / ray.direction.z) * ray.direction;
    const double scale = std::copysign(1.0 / stopRadius, cardinal.entranceRadius);
    point = {scale * ray.origin.x, scale * ray.origin.y};
    return SquaredHeight(ray) <= surface.squaredRim ? Passage::Passed : Passage::Stopped;
}

template <bool towardsScene>
inline Passage GlassLens::Cross(const Surface& surface, GlassRay& ray, StopPoint& point, bool rims) const
{
    if (surface.sphere && !surface.stop)
        return CrossSphere<towardsScene>(surface, ray, rims);
    // by a copy, so that the ray can stay in registers
    GlassRay crossed = ray;
    const Passage passage = surface.stop ? CrossStop(surface, crossed, point) : CrossOther<towardsScene>(surface, crossed, rims);
    ray = crossed;
    return passage;
}

Passage GlassLens::Trace(GlassRay& ray, StopPoint& stop, bool rims) const
{
    GlassRay traced = ray;
    for (const Surface& surface : surfaces)
    {
        const Passage passage = Cross<true>(surface, traced, stop, rims);
        if (passage != Passage::Passed)
            return passage;
    }
    ray = traced;
    return ray.direction.z > 0.0 ? Passage::Passed : Passage::Missed;
}

Passage GlassLens::TraceFromScene(GlassRay& ray, StopPoint& stop, bool rims) const
{
    for (auto surface = surfaces.rbegin(); surface != surfaces.rend(); ++surface)
    {
        const Passage passage = Cross<false>(*surface, ray, stop, rims);
        if (passage != Passage::Passed)
            return passage;
    }
    return ray.direction.z < 0.0 ? Passage::Passed : Passage::Missed;
}

double GlassLens::RearRadius() const { return std::sqrt(surfaces.front().squaredRim); }

GlassLens::Front GlassLens::FrontBox() const
{
    const Surface& front = surfaces.back();
    // where the surface bends away and back, its sag at the rim does not tell its extent; the ball around the vertex does
    const double radius = std::sqrt(front.squaredRim);
    return {radius, front.z - radius, front.z + radius};
}

} // namespace tilt_lens
