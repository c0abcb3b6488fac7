// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "double_gauss.h"

#include <cmath>
#include <stdexcept>

namespace paper
{

namespace
{

/// Radius, thickness, index behind, clear diameter; mm.
struct Printed
{
    double radius, thickness, index, diameter;
};
const Printed kDoubleGauss[] = {
    {29.475, 3.76, 1.67, 25.2},   {84.83, 0.12, 1.0, 25.2},    {19.275, 4.025, 1.67, 23.0},
    {40.77, 3.275, 1.699, 23.0},  {12.75, 10.205, 1.0, 18.0},  // the stop's space: 5.705 + 4.5
    {-14.495, 1.18, 1.603, 17.0}, {40.77, 6.065, 1.658, 20.0}, {-20.385, 0.19, 1.0, 20.0},
    {437.065, 3.22, 1.717, 20.0}, {-39.73, 0.0, 1.0, 20.0},
};
const int kStopAfter = 4;
const std::size_t kFirstElement = 2;
const double kPrintedStop = 5.705;  // mm behind that surface

/// Height and slope against z, in the meaning of dy/dz.
struct Paraxial
{
    double y, slope;
};

/// Toward -z (scene to film).
Paraxial Refract(Paraxial ray, double radius, double before, double after)
{
    // n' u' = n u - y (n' - n)/R, depth = -z
    const double u = -ray.slope;
    return {ray.y, -((before * u - ray.y * (after - before) / radius) / after)};
}

std::optional<Vector> Snell(const Vector& direction, const Vector& normal, double ratio)
{
    const double cosine = -witness::Dot(direction, normal);  // normal against the ray
    const double square = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    if (square < 0.0)
        return std::nullopt;
    return ratio * direction + (ratio * cosine - std::sqrt(square)) * normal;
}

} // namespace

GlassLens::GlassLens(double focalLength, double fStop, double moved)
{
    double depth = 0.0, index = 1.0;
    for (const Printed& row : kDoubleGauss)
    {
        mSurfaces.push_back({-depth, row.radius, index, row.index, 0.5 * row.diameter});
        depth += row.thickness + (mSurfaces.size() == kFirstElement ? moved : 0.0);
        index = row.index;
    }
    mStopAfter = kStopAfter;
    // A parallel ray each way: focal length, H' and H.
    Paraxial ray{1.0, 0.0};
    for (std::size_t i = 0; i < mSurfaces.size(); ++i)
    {
        if (i > 0)
            ray.y += ray.slope * (mSurfaces[i].z - mSurfaces[i - 1].z);
        ray = Refract(ray, mSurfaces[i].radius, mSurfaces[i].before, mSurfaces[i].after);
    }
    const double printedFocal = 1.0 / ray.slope;
    const double rearPrincipal = mSurfaces.back().z + (1.0 - ray.y) / ray.slope;
    Paraxial back{1.0, 0.0};
    for (std::size_t i = mSurfaces.size(); i-- > 0;)
    {
        if (i + 1 < mSurfaces.size())
            back.y += back.slope * (mSurfaces[i].z - mSurfaces[i + 1].z);
        const Surface& s = mSurfaces[i];
        back.slope = (s.after * back.slope + back.y * (s.before - s.after) / s.radius) / s.before;
    }
    const double frontPrincipal = mSurfaces.front().z + (1.0 - back.y) / back.slope;
    const double scale = focalLength / printedFocal;
    for (Surface& s : mSurfaces)
    {
        s.z = scale * (s.z - frontPrincipal);
        s.radius *= scale;
        s.rim *= scale;
    }
    mFocalLength = focalLength;
    mPrintedFocal = printedFocal;
    mSeparation = scale * (frontPrincipal - rearPrincipal);
    mStopZ = mSurfaces[kStopAfter].z - scale * kPrintedStop;
    mPupilRadius = 0.5 * focalLength / fStop;
    PlaceStop();
}

void GlassLens::PlaceStop()
{
    const auto seen = [this](double stop, bool fromScene)
    {
        const int first = fromScene ? mStopAfter : mStopAfter + 1;
        const int last = fromScene ? -1 : static_cast<int>(mSurfaces.size());
        Paraxial axial{0.0, 1.0}, rim{1.0, 0.0};
        double z = stop;
        for (int i = first; i != last; i += fromScene ? -1 : 1)
        {
            const Surface& s = mSurfaces[i];
            for (Paraxial* ray : {&axial, &rim})
            {
                ray->y += ray->slope * (s.z - z);
                const double from = fromScene ? s.after : s.before, to = fromScene ? s.before : s.after;
                ray->slope = (from * ray->slope + ray->y * (to - from) / s.radius) / to;
            }
            z = s.z;
        }
        const double at = z - axial.y / axial.slope;
        return std::pair<double, double>{at, rim.y + rim.slope * (at - z)};
    };
    // The stop's image lies in H, or as near as the air space allows.
    double best = mStopZ, error = std::fabs(seen(mStopZ, true).first);
    const double from = mSurfaces[mStopAfter].z, to = mSurfaces[mStopAfter + 1].z;
    for (int i = 5; i < 200; ++i)
    {
        const double z = from + (to - from) * i / 200.0;
        if (std::fabs(seen(z, true).first) < error)
        {
            best = z;
            error = std::fabs(seen(z, true).first);
        }
    }
    mStopZ = best;
    mEntrancePupil = seen(best, true).first;
    mExitPupil = seen(best, false).first;
    // the entrance pupil's f-number
    mStopRadius = mPupilRadius / std::fabs(seen(best, true).second);
    mPupilRadius = mStopRadius * std::fabs(seen(best, false).second);
}

std::optional<Passage> GlassLens::Trace(const Ray& fromFilm, bool rims) const
{
    Ray ray = fromFilm;
    double stopX = 0.0, stopY = 0.0;
    for (int i = static_cast<int>(mSurfaces.size()) - 1; i >= 0; --i)
    {
        if (i == mStopAfter)
        {
            const double step = (mStopZ - ray.origin.z) / ray.direction.z;
            const Vector at = ray.origin + step * ray.direction;
            stopX = at.x / mStopRadius;
            stopY = at.y / mStopRadius;
            if (std::hypot(stopX, stopY) > 1.0)
                return std::nullopt;
        }
        const Surface& s = mSurfaces[i];
        const Vector centre{0.0, 0.0, s.z - s.radius};
        const Vector offset = ray.origin - centre;
        const double b = witness::Dot(offset, ray.direction);
        const double square = b * b - witness::Dot(offset, offset) + s.radius * s.radius;
        if (square < 0.0)
            return std::nullopt;
        // The intersection on the vertex's side.
        const double step = s.radius > 0.0 ? -b + std::sqrt(square) : -b - std::sqrt(square);
        ray.origin = ray.origin + step * ray.direction;
        if (rims && std::hypot(ray.origin.x, ray.origin.y) > s.rim)
            return std::nullopt;
        Vector normal = (1.0 / s.radius) * (ray.origin - centre);
        if (witness::Dot(normal, ray.direction) > 0.0)
            normal = -1.0 * normal;
        const std::optional<Vector> direction = Snell(ray.direction, normal, s.after / s.before);
        if (!direction)
            return std::nullopt;
        ray.direction = witness::Unit(*direction);
    }
    return Passage{ray, stopX, stopY};
}

} // namespace paper
