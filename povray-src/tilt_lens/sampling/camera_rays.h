// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_rays.h
/// From the number of a sample to its ray: film point and lens point from the sequence or from emitter sampling,
/// then the ray from one through the other. Rays of a group of samples are made together, side by side in vector registers.

#ifndef TILT_LENS_CAMERA_RAYS_H
#define TILT_LENS_CAMERA_RAYS_H

#include <array>

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/glass/glass_camera.h"
#include "tilt_lens/sampling/emitter_sampling.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// Seeds of the random numbers that a pixel's samples of a lens of glass are drawn again with (Hash()): others than those of their rays.
inline PixelSampler GlassSeeds(std::uint32_t x, std::uint32_t y) { return PixelSampler(x, y, 0x476c61); }

/// A sample and its ray.
struct CameraRay
{
    CameraSample sample;  ///< film point, lens point and weight
    LensRay ray;          ///< relative to the lens centre, world axes, scene units
    std::uint32_t refused = 0;  ///< rays before it that a lens of glass let not through

    CameraRay() = default;
    /// Completes a ray from its start.
    CameraRay(const Lens& lens, const CameraSample& start) : sample(start), ray(MakeRay(lens, start.x, start.y, start.point.a, start.point.b)) {}

    /// A sample of a lens of glass and its ray; of one with dispersion only the sample, whose rays DrawColour() finds.
    void Draw(const GlassCamera& glass, const SampleId& id, const SequencePoint& point, const FilmPoint& film)
    {
        lensU = point.lensU;
        lensV = point.lensV;
        glassSeed = GlassSeeds(id.x, id.y).Hash(id.index);
        if (glass.HasColours())
            sample = {film.x, film.y, {0.0, 0.0}, glass.Brightness(film), 0.0};
        else
            Take(glass.Draw(film, lensU, lensV, glassSeed), film);
    }

    /// The ray of such a sample for light of one colour.
    void DrawColour(const GlassCamera& glass, double hue)
    {
        const FilmPoint film{sample.x, sample.y};
        Take(glass.DrawColour(film, lensU, lensV, glassSeed, hue), film);
    }

    /// The same for light of one colour; see MakeColourRay().
    void FindRay(const Lens& lens, double hue) { ray = MakeColourRay(lens, sample.x, sample.y, sample.point.a, sample.point.b, hue); }

  private:
    double lensU = 0.0, lensV = 0.0;  ///< what a sample of a lens of glass is drawn with
    std::uint32_t glassSeed = 0;

    void Take(const GlassSample& drawn, const FilmPoint& film)
    {
        sample = {film.x, film.y, {0.0, 0.0}, drawn.weight, 0.0};
        refused = drawn.refused;
        if (drawn.weight != 0.0)
            ray = drawn.ray;
    }
};

/// The rays of a group of samples, side by side; as CameraRay has them.
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

    /// @param along  of any length
    void PutDirection(std::uint32_t i, const Vec3& along)
    {
        length[i] = Length(along);
        direction[0][i] = along.x / length[i], direction[1][i] = along.y / length[i], direction[2][i] = along.z / length[i];
    }
};

/// Completes the rays of a run from their samples, as CameraRay does, to the last bit.
void FindRays(const Lens& lens, const SampleRun& run, CameraRays& rays);

/// The camera rays of samples that are asked for pixel by pixel.
class CameraRayBatch
{
  public:
    /// @param glass  null for an ideal lens
    /// @param seed   of the pattern of samples (Statement::sampleSeed)
    CameraRayBatch(const Lens& lens, const EmitterSampler& emitters, const GlassCamera* glass, std::uint32_t seed) :
        lens(lens), emitters(emitters), glass(glass), seed(seed)
    {
    }

    void Make(const SampleRun& run);

    /// @name Of the last run.
    /// @{
    const PixelSampler& Sampler() const { return sampler; }  ///< the sequence of the pixel
    const CameraRays& Rays() const { return rays; }          ///< at the samples' places in their group
    /// One of them, to be traced for light of one colour.
    CameraRay One(std::uint32_t place) const;
    std::uint32_t Refused() const { return refused; }        ///< rays that a lens of glass let not through
    /// @}

  private:
    const Lens& lens;
    const EmitterSampler& emitters;
    const GlassCamera* const glass;
    const std::uint32_t seed;
    bool empty = true;  ///< nothing has been made
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
