// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file area_light_sampler.h
/// Hook of Trace, called before it walks the grid of an area light.

#ifndef POVRAY_BACKEND_AREA_LIGHT_SAMPLER_H
#define POVRAY_BACKEND_AREA_LIGHT_SAMPLER_H

namespace pov
{

class LightSource;

class AreaLightSampler
{
  public:
    virtual ~AreaLightSampler() = default;

    /// Chooses one point of an area light to represent its grid, for a caller that averages over many rays.
    /// @param radiosityDepth  recursion depth of radiosity; its samples are reused by other pixels and need the whole grid
    /// @param[out] u, v       column and row of the point
    /// @return                false if the whole grid must be walked
    virtual bool ChoosePoint(const LightSource& light, unsigned int radiosityDepth, int& u, int& v) = 0;
};

} // namespace pov

#endif
