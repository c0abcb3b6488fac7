// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/camera_rays.h"

#include <cmath>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Squared lengths between these need no scaling (Length()), and are not that of a ray that is none.
constexpr double kLeastSquared = 1e-200, kGreatestSquared = 1e200;

/// Points of film and lens, and w, of samples side by side.
template<class Vector>
struct RayStarts
{
    Vector x, y, a, b, w;

    /// RayFromIdeal() along one axis of the world.
    /// @param direction, right, up, lensX, lensY  of the lens
    TILT_LENS_INLINED void FindAlong(double direction, double right, double up, double lensX, double lensY, double* origin,
                                     Vector& along) const
    {
        const Vector chief = direction + x * right + y * up;
        const Vector point = a * lensX + b * lensY;
        along = chief - w * point;
        Store(origin, point);
    }
};

/// RayFromIdeal() and the length of its direction, for samples side by side and a lens that maps planes onto planes: the same
/// operations in the same order.
/// @return  whether all lengths are usual ones; if not, the rays are not right
template<class Vector>
TILT_LENS_INLINED bool FindPlainRays(const Lens& lens, const Quads& quads, CameraRays& rays)
{
    constexpr std::uint32_t lanes = sizeof(Vector) / sizeof(double);
    auto usual = Vector() == Vector();
    for (std::uint32_t i = quads.begin; i < quads.end; i += lanes)
    {
        RayStarts<Vector> starts{Load<Vector>(rays.samples.x + i), Load<Vector>(rays.samples.y + i),
                                 Load<Vector>(rays.samples.a + i), Load<Vector>(rays.samples.b + i), Vector()};
        starts.w = lens.focusMiddle + starts.x * lens.focusRight + starts.y * lens.focusUp;
        Vector x, y, z;
        starts.FindAlong(lens.direction.x, lens.right.x, lens.up.x, lens.lensX.x, lens.lensY.x, rays.origin[0] + i, x);
        starts.FindAlong(lens.direction.y, lens.right.y, lens.up.y, lens.lensX.y, lens.lensY.y, rays.origin[1] + i, y);
        starts.FindAlong(lens.direction.z, lens.right.z, lens.up.z, lens.lensX.z, lens.lensY.z, rays.origin[2] + i, z);
        const Vector squared = x * x + y * y + z * z, length = SquareRoot(squared);
        usual &= (squared > kLeastSquared) & (squared < kGreatestSquared);
        Store(rays.direction[0] + i, x / length);
        Store(rays.direction[1] + i, y / length);
        Store(rays.direction[2] + i, z / length);
        Store(rays.length + i, length);
        Store(rays.w + i, starts.w);
    }
    return All(usual);
}

bool FindRaysPlain(const Lens& lens, const Quads& quads, CameraRays& rays)
{
    return FindPlainRays<Double2>(lens, quads, rays);
}

TILT_LENS_FOR_AVX2 bool FindRaysByAvx2(const Lens& lens, const Quads& quads, CameraRays& rays)
{
    return FindPlainRays<Double4>(lens, quads, rays);
}

const auto findPlainRays = HasAvx2() ? FindRaysByAvx2 : FindRaysPlain;

void FindRaysOneByOne(const Lens& lens, const SampleRun& run, CameraRays& rays)
{
    for (std::uint32_t i = run.Place(); i < run.Place() + run.count; i++)
        rays.Put(i, CameraRay(lens, rays.samples[i]));
}

} // namespace

void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays)
{
    const bool plain = !lens.distorts && lens.fieldCurvature == 0.0;
    if (!plain || !findPlainRays(lens, Quads(run), rays))
        FindRaysOneByOne(lens, run, rays);
}

void CameraRayBatch::Make(const SampleRun& run)
{
    if (empty || run.first.x != pixel.x || run.first.y != pixel.y)
    {
        empty = false;
        pixel = run.first;
        sampler = PixelSampler(pixel.x, pixel.y, seed);
        targets = emitters.TargetsOf(pixel.x, pixel.y);
    }
    sampler.FindGroup(run.first.index, points);
    if (glass != nullptr)
        return MakeOfGlass(run);
    emitters.Generate(targets, run, points, rays.samples);
    FindRays(lens, run, rays);
}

void CameraRayBatch::MakeOfGlass(const SampleRun& run)
{
    refused = 0;
    for (std::uint32_t i = 0; i < run.count; i++)
    {
        const std::uint32_t place = run.Place() + i;
        const SequencePoint point = points[place];
        CameraRay& ray = ofGlass[place];
        ray.Draw(*glass, run[i], point, emitters.FilmPointOf(run.first.x + point.pixelX, run.first.y + point.pixelY));
        refused += ray.refused;
        rays.Put(place, ray);
    }
}

CameraRay CameraRayBatch::One(std::uint32_t place) const
{
    if (glass != nullptr)
        return ofGlass[place];
    CameraRay one;
    one.sample = rays.samples[place];
    return one;
}

} // namespace tilt_lens
