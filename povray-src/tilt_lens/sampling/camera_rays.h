// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file camera_rays.h
/// From the number of a sample to its ray: film point and lens point from the sequence or from emitter sampling,
/// then the ray from one through the other. Each step waits for divisions and roots of the step before; those of
/// several samples overlap, so rays are made in batches.

#ifndef TILT_LENS_CAMERA_RAYS_H
#define TILT_LENS_CAMERA_RAYS_H

#include <algorithm>
#include <array>

#include "tilt_lens/camera/ray.h"
#include "tilt_lens/glass/glass_camera.h"
#include "tilt_lens/sampling/emitter_sampling.h"
#include "tilt_lens/settings.h"

namespace tilt_lens
{

/// A sample and its ray.
struct CameraRay
{
    CameraSample sample;  ///< film point, lens point and weight
    LensRay ray;          ///< relative to the lens centre, world axes, scene units
    double length;        ///< of the ray's direction
    Vec3 direction;       ///< the ray's, normalised
    std::uint32_t refused = 0;  ///< rays before it that a lens of glass let not through

    /// Completes a ray from its start.
    void FindRay(const Lens& lens) { Take(MakeRay(lens, sample.x, sample.y, sample.point.a, sample.point.b)); }

    /// A sample of a lens of glass and its ray; of one with dispersion only the sample, whose rays DrawColour() finds.
    void Draw(const GlassCamera& glass, const SampleId& id, const SequencePoint& point, const FilmPoint& film)
    {
        lensU = point.lensU;
        lensV = point.lensV;
        glassSeed = PixelHash(id.x, id.y, kGlassSeed, id.index);
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
    void FindRay(const Lens& lens, double hue) { Take(MakeColourRay(lens, sample.x, sample.y, sample.point.a, sample.point.b, hue)); }

  private:
    static constexpr std::uint32_t kGlassSeed = 0x476c61;  ///< sets its random numbers apart from a sample's others

    double lensU = 0.0, lensV = 0.0;  ///< what a sample of a lens of glass is drawn with
    std::uint32_t glassSeed = 0;

    void Take(const GlassSample& drawn, const FilmPoint& film)
    {
        sample = {film.x, film.y, {0.0, 0.0}, drawn.weight, 0.0};
        refused = drawn.refused;
        if (drawn.weight != 0.0)
            Take(drawn.ray);
    }

    void Take(const LensRay& found)
    {
        ray = found;
        length = Length(ray.direction);
        direction = {ray.direction.x / length, ray.direction.y / length, ray.direction.z / length};
    }
};

/// The camera rays of samples that are asked for pixel by pixel, those of a pixel in order.
class CameraRayBatch
{
  public:
    /// @param glass  null for an ideal lens
    /// @param first  samples that each pixel gets in its first round
    /// @param seed   of the pattern of samples (Statement::sampleSeed)
    CameraRayBatch(const Lens& lens, const EmitterSampler& emitters, const GlassCamera* glass, std::uint32_t first, std::uint32_t seed) :
        lens(lens), emitters(emitters), glass(glass), ahead(std::min(settings.cameraRaysOfBatch, first)), seed(seed)
    {
    }

    const CameraRay& Of(const SampleId& id)
    {
        if (count == 0 || id.x != first.x || id.y != first.y)
        {
            sampler = PixelSampler(id.x, id.y, seed);
            targets = emitters.TargetsOf(id.x, id.y);
            count = 0;
        }
        if (id.index - first.index >= count)
            Make(id);
        return rays[id.index - first.index];
    }

    /// The sequence of the pixel that was asked for last.
    const PixelSampler& Sampler() const { return sampler; }

  private:
    const Lens& lens;
    const EmitterSampler& emitters;
    const GlassCamera* const glass;
    const std::uint32_t ahead;  ///< rays made at a time; rounds of samples are no shorter, so that none is made in vain
    const std::uint32_t seed;
    PixelSampler sampler{0, 0, 0};
    EmitterSampler::Targets targets;
    SampleId first{};
    std::uint32_t count = 0;
    std::array<CameraRay, settings.cameraRaysOfBatch> rays;

    void Make(const SampleId& from)
    {
        first = from;
        count = ahead;
        std::array<SequencePoint, settings.cameraRaysOfBatch> points;
        for (std::uint32_t i = 0; i < count; i++)
            points[i] = sampler(from.index + i);
        if (glass != nullptr)
        {
            for (std::uint32_t i = 0; i < count; i++)
                rays[i].Draw(*glass, {from.x, from.y, from.index + i}, points[i],
                             emitters.FilmPointOf(from.x + points[i].pixelX, from.y + points[i].pixelY));
            return;
        }
        for (std::uint32_t i = 0; i < count; i++)
            rays[i].sample = emitters.Generate(targets, {from.x, from.y, from.index + i}, points[i]);
        for (std::uint32_t i = 0; i < count; i++)
            rays[i].FindRay(lens);
    }
};

} // namespace tilt_lens

#endif
