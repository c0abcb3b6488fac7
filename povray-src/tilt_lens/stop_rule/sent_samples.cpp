// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

#include "tilt_lens/stop_rule/sent_samples.h"

#include <algorithm>

namespace tilt_lens
{

void SentSamples::Add(const SampleId& id, const SampleResult& result)
{
    if (id.index >= most || result.circle.weight == 0.0f)  // aimed beside the lens or the pixel
        return;
    const std::uint32_t pixel = std::uint32_t(block.IndexOf(id.x, id.y));
    if (!ServesOthers(result.circle))
    {
        sharp.resize(block.Size());
        sharp[pixel].Add(result.radiance, result.circle.weight);
        return;
    }
    const Radiance& radiance = result.radiance;
    Sample sample{result.circle, {float(radiance[0]), float(radiance[1]), float(radiance[2])}, pixel};
    sample.circle.x -= block.left;
    sample.circle.y -= block.top;
    kept.push_back(sample);
}

std::shared_ptr<const SpreadSums> SentSamples::Spread(const std::vector<std::uint32_t>& samples, std::uint32_t weight) const
{
    if (kept.empty())
        return nullptr;
    const auto spread = std::make_shared<SpreadSums>(block, width, height);
    std::vector<std::uint32_t> sent;
    for (const std::uint32_t count : samples)
        sent.push_back(std::min(count, most));
    for (const Sample& sample : kept)
    {
        const Radiance radiance{sample.radiance[0], sample.radiance[1], sample.radiance[2], 0.0, 0.0};
        spread->Add(sample.pixel % block.width, sample.pixel / block.width, sample.circle, radiance, float(weight) / sent[sample.pixel]);
    }
    for (std::uint32_t i = 0; i < sharp.size(); i++)
        spread->Add(i % block.width, i / block.width, sharp[i], float(weight) / sent[i]);
    return spread->IsSpread() ? spread : nullptr;
}

} // namespace tilt_lens
