// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/samples/sampled_camera.h"

namespace tilt_lens
{

namespace
{

SamplingLimits WithMinimum(SamplingLimits limits, bool few)
{
    if (limits.min == 0)
        limits.SetUsualMinimum(few);
    return limits;
}

} // namespace

SampledCamera::SampledCamera(std::shared_ptr<const LensCamera> itsLens, const SamplingLimits& given, const Picture& picture,
                             std::uint32_t itsSeed) :
    lens(std::move(itsLens)),
    limits(WithMinimum(given, lens->NeedsFewFirstSamples())),
    aims(lens->CanAimAtEmitters() && limits.AllowAims()),
    spreads(limits.Denoises() && lens->CanSpread()),
    footprint(lens->Solved(), lens->Opening(), picture.width, picture.height),
    lensSampler(lens, picture.width, picture.height),
    emitters(lensSampler, limits, aims ? picture.emitters : std::vector<Emitter>()),
    seed(itsSeed)
{
}

} // namespace tilt_lens
