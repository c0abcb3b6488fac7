// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_sampler.h
/// Draws plain samples of the camera: a film point in the pixel's square, and a lens point of the aperture. Emitter sampling
/// (emitter_sampling.h) replaces some of them.

#ifndef TILT_LENS_LENS_SAMPLER_H
#define TILT_LENS_LENS_SAMPLER_H

#include <cstdint>
#include <memory>

#include "tilt_lens/lens_camera/lens_camera.h"
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sequence.h"

namespace tilt_lens
{

/// Start of a sample's ray.
struct CameraSample
{
    double x, y;              ///< film point as in MakeRay
    AperturePoint point;      ///< lens point
    double weight;            ///< weight of its radiance; 0: no ray to trace
    double expectedEmission;  ///< as in SampleResult
};

/// The same for a group of samples, one array per number.
struct CameraSamples
{
    OfGroup x, y, a, b, weight, expectedEmission;

    CameraSample operator[](std::uint32_t i) const { return {x[i], y[i], {a[i], b[i]}, weight[i], expectedEmission[i]}; }
    void Put(std::uint32_t i, const CameraSample& sample)
    {
        x[i] = sample.x, y[i] = sample.y, a[i] = sample.point.a, b[i] = sample.point.b;
        weight[i] = sample.weight, expectedEmission[i] = sample.expectedEmission;
    }
};

/// Immutable: threads share it.
class LensSampler
{
  public:
    /// @param width, height  of the whole picture in pixels
    LensSampler(std::shared_ptr<const LensCamera> itsCamera, std::uint32_t width, std::uint32_t height) :
        camera(std::move(itsCamera)),
        lens(camera->Solved()),
        aperture(camera->Opening()),
        vignetting(camera->ThinVignetting()),
        width(width),
        height(height)
    {
    }

    const std::shared_ptr<const LensCamera> camera;
    const Lens& lens;  ///< the camera's, as are the next two
    const Aperture& aperture;
    const Vignetting& vignetting;
    const double width, height;

    /// @param point  of the pixel's sequence
    CameraSample Draw(const SampleId& id, const SequencePoint& point) const
    {
        CameraSample sample = DrawFilmPoint(id, point);
        DrawLensPoint(id, point.lensU, point.lensV, sample);
        return sample;
    }

    /// Draws the samples of a run.
    /// @param points   of the group
    /// @param samples  receives them, at their positions in the group
    void Draw(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

    /// @name The two halves of Draw().
    /// @{
    CameraSample DrawFilmPoint(const SampleId& id, const SequencePoint& point) const
    {
        const FilmPoint film = FilmPointAt(id.x + point.pixelX, id.y + point.pixelY, width, height);
        return {film.x, film.y, {0.0, 0.0}, 1.0, 0.0};
    }
    void DrawFilmPoints(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

    /// Sets lens point and weight: among the lens points that the film point sees, if there is vignetting.
    void DrawLensPoint(const SampleId& id, double u, double v, CameraSample& sample) const
    {
        if (vignetting.None())
            sample.point = aperture(u, v);
        else
            sample.weight = vignetting.DrawPoint(aperture, {sample.x, sample.y}, u, v, SeedOf(id), sample.point);
    }
    /// @}

  private:
    /// Seed of the random numbers that redraw a vignetted lens point; independent of those that the sample's ray draws.
    std::uint32_t SeedOf(const SampleId& id) const { return PixelHash(id.x, id.y, camera->SeedSalt(), id.index); }
};

} // namespace tilt_lens

#endif
