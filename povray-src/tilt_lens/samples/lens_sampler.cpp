// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/lens_sampler.h"

#include "tilt_lens/math/kernels.h"

namespace tilt_lens
{

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
    kernels->findFilmPoints(run.first.x, run.first.y, width, height, Quads(run), points, samples);
}

} // namespace tilt_lens
