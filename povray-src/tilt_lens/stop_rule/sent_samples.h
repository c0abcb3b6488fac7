// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sent_samples.h
/// A block's samples for other pixels, kept until the block has converged: docs/sampling.md, section 5.

#ifndef TILT_LENS_SENT_SAMPLES_H
#define TILT_LENS_SENT_SAMPLES_H

#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/math/area.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/samples/sample.h"

namespace tilt_lens
{

class SentSamples
{
  public:
    /// @param width, height  whole picture, pixels
    /// @param most  number of a pixel's samples that serve others, its first
    SentSamples(const Area& block, std::uint32_t width, std::uint32_t height, std::uint32_t most) :
        block(block), width(width), height(height), most(most)
    {
    }

    /// Keeps a sample that is among its pixel's first settings.mostSentSamples and serves other pixels; adds up those that do not.
    void Add(const SampleId& id, const SampleResult& result);

    /// @param samples  of each pixel of the block, row by row
    /// @param weight  sum of each pixel's sample weights
    /// @return null if no sample serves another pixel
    std::shared_ptr<const SpreadSums> Spread(const std::vector<std::uint32_t>& samples, std::uint32_t weight) const;

    void Clear()
    {
        std::vector<Sample>().swap(kept);
        std::vector<SharpSamples>().swap(sharp);
    }
    void ReleaseReserve() { kept.shrink_to_fit(); }

  private:
    struct Sample
    {
        CircleOfConfusion circle;  ///< relative to the block
        float radiance[3];
        std::uint32_t pixel;  ///< row by row in the block
    };

    const Area block;
    const std::uint32_t width, height, most;
    std::vector<Sample> kept;
    std::vector<SharpSamples> sharp;  ///< of each pixel; empty if all serve others
};

} // namespace tilt_lens

#endif
