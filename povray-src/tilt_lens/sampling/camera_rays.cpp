// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/camera_rays.h"

#include <cmath>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// The numbers of a lens that are the same for each axis of the world.
struct LensAxis
{
    double direction, right, up, lensX, lensY;
};

/// Squared lengths between these need no scaling (Length()), and are not that of a ray that is none.
constexpr double kLeastSquared = 1e-200, kGreatestSquared = 1e200;

/// RayFromIdeal() and the length of its direction, for samples side by side and a lens that maps planes onto planes: the same
/// operations in the same order.
/// @return  whether all lengths are usual ones; if not, the rays are not right
template<class Vector>
TILT_LENS_INLINED bool FindPlainRays(const Lens& lens, const Quads& quads, CameraRays& rays)
{
    constexpr std::uint32_t lanes = sizeof(Vector) / sizeof(double);
    const LensAxis axes[3] = {{lens.direction.x, lens.right.x, lens.up.x, lens.lensX.x, lens.lensY.x},
                              {lens.direction.y, lens.right.y, lens.up.y, lens.lensX.y, lens.lensY.y},
                              {lens.direction.z, lens.right.z, lens.up.z, lens.lensX.z, lens.lensY.z}};
    auto usual = Vector() == Vector();
    for (std::uint32_t i = quads.begin; i < quads.end; i += lanes)
    {
        const Vector x = Load<Vector>(rays.samples.x + i), y = Load<Vector>(rays.samples.y + i);
        const Vector a = Load<Vector>(rays.samples.a + i), b = Load<Vector>(rays.samples.b + i);
        const Vector w = lens.focusMiddle + x * lens.focusRight + y * lens.focusUp;
        Vector along[3];
        for (int k = 0; k < 3; k++)
        {
            const LensAxis& axis = axes[k];
            const Vector chief = axis.direction + x * axis.right + y * axis.up;
            const Vector point = a * axis.lensX + b * axis.lensY;
            along[k] = chief - w * point;
            Store(rays.origin[k] + i, point);
        }
        const Vector squared = along[0] * along[0] + along[1] * along[1] + along[2] * along[2];
        usual &= (squared > kLeastSquared) & (squared < kGreatestSquared);
        Vector length = squared;
        for (std::uint32_t lane = 0; lane < lanes; lane++)
            length[lane] = std::sqrt(length[lane]);
        for (int k = 0; k < 3; k++)
            Store(rays.direction[k] + i, along[k] / length);
        Store(rays.length + i, length);
        Store(rays.w + i, w);
    }
    bool all = true;
    for (std::uint32_t lane = 0; lane < lanes; lane++)
        all &= usual[lane] != 0;
    return all;
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

} // namespace

void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays)
{
    const bool plain = !lens.distorts && lens.fieldCurvature == 0.0;
    if (plain && findPlainRays(lens, Quads(run), rays))
        return;
    for (std::uint32_t i = run.Place(); i < run.Place() + run.count; i++)
        rays.Put(i, CameraRay(lens, rays.samples[i]));
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
