// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/lens_sampler.h"

#include "tilt_lens/math/simd.h"

namespace tilt_lens
{

namespace
{

/// Film points, by FilmPointAt(), and weights 1.
template<class Vector>
TILT_LENS_INLINED void FindFilmPoints(double column, double row, double width, double height, const Quads& quads,
                                      const SequencePoints& points, CameraSamples& samples)
{
    for (std::uint32_t i = quads.begin; i < quads.end; i += kVectorWidth<Vector>)
    {
        Store(samples.x + i, (column + Load<Vector>(points.pixelX + i)) / width - 0.5);
        Store(samples.y + i, 0.5 - (row + Load<Vector>(points.pixelY + i)) / height);
        Store(samples.weight + i, Vector() + 1.0);
        Store(samples.expectedEmission + i, Vector());
    }
}

void FindFilmPointsPlain(double column, double row, double width, double height, const Quads& quads, const SequencePoints& points,
                         CameraSamples& samples)
{
    FindFilmPoints<Double2>(column, row, width, height, quads, points, samples);
}

TILT_LENS_FOR_AVX2 void FindFilmPointsByAvx2(double column, double row, double width, double height, const Quads& quads,
                                             const SequencePoints& points, CameraSamples& samples)
{
    FindFilmPoints<Double4>(column, row, width, height, quads, points, samples);
}

const auto findFilmPoints = HasAvx2() ? FindFilmPointsByAvx2 : FindFilmPointsPlain;

} // namespace

void LensSampler::Draw(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const
{
    if (!vignetting.None())
    {
        for (std::uint32_t i = 0; i < run.count; i++)
            samples.Put(run.Place() + i, Draw(run[i], points[run.Place() + i]));
        return;
    }
    DrawFilmPoints(run, points, samples);
    const Quads quads(run);
    aperture.Map(points.lensU + quads.begin, points.lensV + quads.begin, samples.a + quads.begin, samples.b + quads.begin, quads.Count());
}

void LensSampler::DrawFilmPoints(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const
{
    findFilmPoints(run.first.x, run.first.y, width, height, Quads(run), points, samples);
}

} // namespace tilt_lens
