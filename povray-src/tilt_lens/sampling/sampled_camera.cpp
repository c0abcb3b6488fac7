// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/sampling/sampled_camera.h"

namespace tilt_lens
{

namespace
{

SamplingLimits WithMinimum(SamplingLimits limits, bool aims)
{
    if (limits.min == 0)
        limits.SetUsualMinimum(aims);
    return limits;
}

/// True if the footprint describes the circles of confusion.
bool FitsFootprint(const Lens& lens, const Character& character)
{
    return !lens.glass && !lens.distorts && lens.fieldCurvature == 0.0 && !HasColours(lens) && character.opticalVignetting == 0.0;
}

} // namespace

SampledCamera::SampledCamera(const Lens& lens, const Aperture& aperture, const Statement& statement, const SamplingLimits& given,
                             const Picture& picture) :
    glass(lens.glass ? std::make_unique<const GlassCamera>(lens, aperture, statement.character.naturalVignetting) : nullptr),
    aims(!picture.deflectsRays && !glass),
    limits(WithMinimum(given, aims)),
    spreads(limits.Denoises() && !picture.deflectsRays && FitsFootprint(lens, statement.character)),
    footprint(lens, aperture, picture.width, picture.height),
    lensSampler(lens, aperture, picture.width, picture.height, glass ? Vignetting() : Vignetting(lens, aperture, statement.character)),
    emitters(lensSampler, limits, aims ? picture.emitters : std::vector<Emitter>()),
    seed(statement.sampleSeed)
{
}

} // namespace tilt_lens
