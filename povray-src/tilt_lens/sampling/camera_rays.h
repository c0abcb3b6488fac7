// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_rays.h
/// Camera rays: a sample's index gives a film point and a lens point, by the sequence or by emitter sampling, and these give the ray. The
/// rays of a group of samples are computed together in vector registers.

#ifndef TILT_LENS_CAMERA_RAYS_H
#define TILT_LENS_CAMERA_RAYS_H

#include <array>

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/lens_camera/lens_camera.h"
#include "tilt_lens/sampling/emitter_sampling.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

struct CameraRay
{
    CameraSample sample;  ///< film point, lens point and weight
    LensRay ray;          ///< origin relative to the lens centre, world axes, scene units
    std::uint32_t refused = 0;  ///< rays blocked by the glass lens before this one

    CameraRay() = default;
    CameraRay(const Lens& lens, const CameraSample& start) : sample(start), ray(MakeRay(lens, start.x, start.y, start.point.a, start.point.b)) {}

    /// Draws a plain sample and its ray; of glass with dispersion only the sample: FindColour() then computes its rays.
    void Draw(const LensCamera& camera, const SampleId& id, const SequencePoint& point, const FilmPoint& film)
    {
        lensU = point.lensU;
        lensV = point.lensV;
        seed = PixelHash(id.x, id.y, camera.SeedSalt(), id.index);
        const GlassCamera* const glass = camera.Glass();
        if (glass != nullptr && glass->HasColours())
            sample = {film.x, film.y, {0.0, 0.0}, glass->Brightness(film), 0.0};
        else
            Take(camera.Draw(film, lensU, lensV, seed), film);
    }

    /// Computes the ray for light of one colour.
    /// @param hue  place in the spectrum, -1 (blue end) to 1 (red end)
    void FindColour(const LensCamera& camera, double hue)
    {
        const FilmPoint film{sample.x, sample.y};
        if (const GlassCamera* const glass = camera.Glass())
            Take(glass->DrawColour(film, lensU, lensV, seed, hue), film);
        else
            ray = MakeColourRay(camera.Solved(), film.x, film.y, sample.point.a, sample.point.b, hue);
    }

  private:
    double lensU = 0.0, lensV = 0.0;  ///< lens coordinates of a sample from Draw()
    std::uint32_t seed = 0;

    void Take(const LensSample& drawn, const FilmPoint& film)
    {
        sample = {film.x, film.y, drawn.point, drawn.weight, 0.0};
        refused = drawn.refused;
        if (drawn.weight != 0.0)
            ray = drawn.ray;
    }
};

/// The rays of a group of samples, as CameraRay but one array per number.
struct CameraRays
{
    CameraSamples samples;
    OfGroup origin[3], direction[3];  ///< the direction is normalised
    OfGroup length, w;

    void Put(std::uint32_t i, const CameraRay& ray)
    {
        samples.Put(i, ray.sample);
        const Vec3& from = ray.ray.origin;
        origin[0][i] = from.x, origin[1][i] = from.y, origin[2][i] = from.z;
        PutDirection(i, ray.ray.direction);
        w[i] = ray.ray.w;
    }

    /// @param along  need not be normalised
    void PutDirection(std::uint32_t i, const Vec3& along)
    {
        length[i] = Length(along);
        direction[0][i] = along.x / length[i], direction[1][i] = along.y / length[i], direction[2][i] = along.z / length[i];
    }
};

/// Computes the rays of a run from their samples, bit for bit as CameraRay does.
void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays);

/// Makes the camera rays of samples, pixel by pixel.
class CameraRayBatch
{
  public:
    /// @param seed  of the sampling pattern (Statement::sampleSeed)
    CameraRayBatch(const LensCamera& camera, const EmitterSampler& emitters, std::uint32_t seed) :
        camera(camera), emitters(emitters), glass(camera.Glass()), seed(seed)
    {
    }

    void Make(const SampleRun& run);

    /// @name Of the last run.
    /// @{
    const PixelSampler& Sampler() const { return sampler; }
    const CameraRays& Rays() const { return rays; }          ///< indexed by the samples' positions in their group
    /// A single sample, to be traced for light of one colour.
    CameraRay One(std::uint32_t place) const;
    std::uint32_t Refused() const { return refused; }        ///< rays blocked by the glass lens
    /// @}

  private:
    const LensCamera& camera;
    const EmitterSampler& emitters;
    const GlassCamera* const glass;  ///< null for a thin lens
    const std::uint32_t seed;
    bool empty = true;  ///< no run yet
    SampleId pixel{};   ///< of the last run
    PixelSampler sampler{0, 0, 0}, glassSeeds{0, 0, 0};
    EmitterSampler::Targets targets;
    SequencePoints points{};
    CameraRays rays{};
    std::array<CameraRay, settings.cameraRaysOfBatch> ofGlass;
    std::uint32_t refused = 0;

    void MakeOfGlass(const SampleRun& run);
    void DrawFour(const SampleRun& run, std::uint32_t first);
};

} // namespace tilt_lens

#endif
