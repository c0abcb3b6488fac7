// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/camera_rays.h"

#include <cmath>
#include <numeric>

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Within these bounds a squared length neither overflows nor underflows (else Length() scales), and belongs to a ray with a direction.
constexpr double kLeastSquared = 1e-200, kGreatestSquared = 1e200;

/// Film points (x, y), lens points (a, b) and w of several samples, one vector each.
template<class Vector>
struct RayStarts
{
    Vector x, y, a, b, w;

    /// One world coordinate of RayFromIdeal().
    /// @param direction, right, up, lensX, lensY  this coordinate of the lens's vectors
    TILT_LENS_INLINED void FindAlong(double direction, double right, double up, double lensX, double lensY, double* origin,
                                     Vector& along) const
    {
        const Vector chief = direction + x * right + y * up;
        const Vector point = a * lensX + b * lensY;
        along = chief - w * point;
        Store(origin, point);
    }
};

/// RayFromIdeal() and the length of its direction, for several samples and a lens that maps planes onto planes: the same operations in the
/// same order.
/// @return  whether all lengths are within the bounds above; if not, the rays are invalid
template<class Vector>
TILT_LENS_INLINED bool FindPlainRays(const Lens& lens, const Quads& quads, CameraRays& rays)
{
    constexpr std::uint32_t lanes = kVectorWidth<Vector>;
    MaskOf<Vector> usual = Vector() == Vector();
    for (std::uint32_t i = quads.begin; i < quads.end; i += lanes)
    {
        RayStarts<Vector> starts{Load<Vector>(rays.samples.x + i), Load<Vector>(rays.samples.y + i),
                                 Load<Vector>(rays.samples.a + i), Load<Vector>(rays.samples.b + i), Vector()};
        starts.w = lens.focusMiddle + starts.x * lens.focusRight + starts.y * lens.focusUp;
        VecOf<Vector> along;
        starts.FindAlong(lens.direction.x, lens.right.x, lens.up.x, lens.lensX.x, lens.lensY.x, rays.origin[0] + i, along.x);
        starts.FindAlong(lens.direction.y, lens.right.y, lens.up.y, lens.lensX.y, lens.lensY.y, rays.origin[1] + i, along.y);
        starts.FindAlong(lens.direction.z, lens.right.z, lens.up.z, lens.lensX.z, lens.lensY.z, rays.origin[2] + i, along.z);
        const Vector squared = Dot(along, along), length = SquareRoot(squared);
        usual &= (squared > kLeastSquared) & (squared < kGreatestSquared);
        StoreVectors(rays.direction, i, along / length);
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
    const CameraSamples& samples = rays.samples;
    for (std::uint32_t i = run.Place(); i < run.Place() + run.count; i++)
        rays.Put(i, MakeRay(lens, samples.x[i], samples.y[i], samples.a[i], samples.b[i]));
}

void PutFour(const FourGlassSamples& four, std::uint32_t first, CameraRays& rays)
{
    for (std::uint32_t i = 0; i < 4; i++)
    {
        const std::uint32_t place = first + i;
        rays.samples.weight[place] = four.weight[i];
        if (four.weight[i] == 0.0)
            continue;
        for (int axis = 0; axis < 3; axis++)
            rays.origin[axis][place] = four.origin[axis][i];
        rays.w[place] = four.w[i];
        rays.PutDirection(place, {four.direction[0][i], four.direction[1][i], four.direction[2][i]});
    }
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
    const SampleId& pixel = run.first;
    if (empty || pixel.x != last.first.x || pixel.y != last.first.y)
    {
        empty = false;
        sampler = PixelSampler(pixel.x, pixel.y, camera.seed);
        if (aims)
            targets = camera.emitters.TargetsOf(pixel.x, pixel.y);
        if (camera.glass)
            glassSeeds = GlassSeeds(pixel.x, pixel.y);
    }
    last = run;
    sampler.FindGroup(run.first.index, points);
    if (camera.glass)
        return MakeOfGlass(run);
    camera.emitters.Draw(targets, run, points, rays.samples);
    FindRays(camera.GetLens(), run, rays);
}

void CameraRayBatch::MakeOfGlass(const SampleRun& run)
{
    refused = 0;
    camera.lensSampler.DrawFilmPoints(run, points, rays.samples);
    const std::uint32_t end = run.Place() + run.count;
    if (camera.glass->HasColours())  // their rays are made by MakeColour()
        for (std::uint32_t i = run.Place(); i < end; i++)
            rays.samples.weight[i] = camera.glass->Brightness({rays.samples.x[i], rays.samples.y[i]});
    else
        for (std::uint32_t first = Quads(run).begin; first < end; first += 4)
            DrawFour(run, first);
}

/// @param first  position in the group of the first of the four
void CameraRayBatch::DrawFour(const SampleRun& run, std::uint32_t first)
{
    FourGlassPoints four;
    four.wanted = 0;
    const std::uint32_t begin = run.first.index - run.Place();  // index of the group's first sample
    for (std::uint32_t i = 0; i < 4; i++)
    {
        const std::uint32_t place = first + i;
        four.x[i] = rays.samples.x[place], four.y[i] = rays.samples.y[place];
        four.u[i] = points.lensU[place], four.v[i] = points.lensV[place];
        four.seed[i] = glassSeeds.Hash(begin + place);
        four.wanted |= (place >= run.Place() && place < run.Place() + run.count ? 1u : 0u) << i;
    }
    FourGlassSamples samples;
    camera.glass->Draw(four, samples);
    PutFour(samples, first, rays);
    refused = std::accumulate(samples.refused, samples.refused + 4, refused);
}

void CameraRayBatch::MakeColour(std::uint32_t place, double hue, CameraRays& ray)
{
    const CameraSample sample = rays.samples[place];
    ray.samples.Put(0, sample);
    refused = 0;
    if (sample.weight == 0.0)
        return;
    if (!camera.glass)
        return ray.Put(0, MakeColourRay(camera.GetLens(), sample.x, sample.y, sample.point.a, sample.point.b, hue));
    const std::uint32_t index = last.first.index - last.Place() + place;
    const GlassSample drawn = camera.glass->DrawColour({sample.x, sample.y}, points.lensU[place], points.lensV[place], glassSeeds.Hash(index), hue);
    refused = drawn.refused;
    ray.samples.weight[0] = drawn.weight;
    if (drawn.weight != 0.0)
        ray.Put(0, drawn.ray);
}

} // namespace tilt_lens
