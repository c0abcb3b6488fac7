// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lens_sampler.h
/// Draws plain samples: a film point and a lens point. Emitter sampling (emitter_sampling.h) replaces some.

#ifndef TILT_LENS_LENS_SAMPLER_H
#define TILT_LENS_LENS_SAMPLER_H

#include <cstdint>
#include <memory>

#include "tilt_lens/lens_camera/lens_camera.h"
#include "tilt_lens/samples/sample.h"
#include "tilt_lens/samples/sequence.h"

namespace tilt_lens
{

struct CameraSample
{
    double x, y;
    AperturePoint point;
    double weight;            ///< of the radiance; 0: no ray to trace
    double expectedEmission;  ///< as in SampleResult
    double overPlain = 1.0;   ///< weight over that of a plain sample: 1 on average, less towards emitters; 0: aimed beside lens or pixel
};

struct CameraSamples
{
    OfGroup x, y, a, b, weight, expectedEmission, overPlain;

    CameraSample operator[](std::uint32_t i) const { return {x[i], y[i], {a[i], b[i]}, weight[i], expectedEmission[i], overPlain[i]}; }
    void Put(std::uint32_t i, const CameraSample& sample)
    {
        x[i] = sample.x, y[i] = sample.y, a[i] = sample.point.a, b[i] = sample.point.b;
        weight[i] = sample.weight, expectedEmission[i] = sample.expectedEmission, overPlain[i] = sample.overPlain;
    }
};

/// Immutable, thread-safe.
class LensSampler
{
  public:
    /// @param width, height  whole picture, pixels
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

    CameraSample Draw(const SampleId& id, const SequencePoint& point) const
    {
        CameraSample sample = DrawFilmPoint(id, point);
        DrawLensPoint(id, point.lensU, point.lensV, sample);
        return sample;
    }

    /// @param samples  filled at the run's positions in the group
    void Draw(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

    /// @name Halves of Draw().
    /// @{
    CameraSample DrawFilmPoint(const SampleId& id, const SequencePoint& point) const
    {
        const FilmPoint film = FilmPointAt(id.x + point.pixelX, id.y + point.pixelY, width, height);
        return {film.x, film.y, {0.0, 0.0}, 1.0, 0.0};
    }
    void DrawFilmPoints(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

    /// Sets lens point and weight, within the vignetted opening.
    void DrawLensPoint(const SampleId& id, double u, double v, CameraSample& sample) const
    {
        if (vignetting.None())
            sample.point = aperture(u, v);
        else
            sample.weight = vignetting.DrawPoint(aperture, {sample.x, sample.y}, u, v, SeedOf(id), sample.point);
    }
    /// @}

  private:
    /// For redrawing a vignetted lens point; independent of the ray's random numbers.
    std::uint32_t SeedOf(const SampleId& id) const { return PixelHash(id.x, id.y, camera->SeedSalt(), id.index); }
};

} // namespace tilt_lens

#endif
