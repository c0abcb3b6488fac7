// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file area_light_sampler.h
/// One random point of an area light per camera ray, with the mean of the whole grid (R. L. Cook, T. Porter, L. Carpenter, "Distributed Ray
/// Tracing", 1984).

#ifndef POVRAY_BACKEND_AREA_LIGHT_SAMPLER_H
#define POVRAY_BACKEND_AREA_LIGHT_SAMPLER_H

#include <cstdint>

#include "tilt_lens/samples/sequence.h"

namespace pov
{

class LightSource;

class AreaLightSampler
{
  public:
    /// @param itsPixel  must outlive the ray
    void Begin(const tilt_lens::PixelSampler& itsPixel, unsigned int itsIndex)
    {
        pixel = &itsPixel;
        index = itsIndex;
        lightsMet = 0;
    }

    /// @param radiosityDepth  recursion depth; radiosity's samples need the whole grid
    /// @return                false: walk the whole grid
    bool ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v);

    std::uint64_t sampled = 0, skipped = 0;

  private:
    const tilt_lens::PixelSampler* pixel = nullptr;
    unsigned int index = 0, lightsMet = 0;
};

}  // namespace pov

#endif
