// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample_seeds.h
/// Seeds random generators at a sample's first draw, so that pictures do not depend on the order of tracing.

#ifndef POVRAY_BACKEND_SAMPLE_SEEDS_H
#define POVRAY_BACKEND_SAMPLE_SEEDS_H

#include <cstddef>

namespace pov
{

class SampleSeedSource
{
  public:
    virtual ~SampleSeedSource() = default;

    virtual unsigned int Seed() const = 0;

    /// From 1; 0 between samples.
    std::size_t Sample() const { return sample; }

  protected:
    void BeginSample() { sample = ++begun; }
    void EndSample() { sample = 0; }

  private:
    std::size_t sample = 0, begun = 0;
};

class SampleSeeds
{
  public:
    /// @param itsSource  must outlive the last draw
    void Follow(const SampleSeedSource& itsSource) { source = &itsSource; }

    /// Call before each draw; sets the state at the sample's first.
    template<class State>
    void Take(State& state)
    {
        if (source == NULL || source->Sample() == 0 || source->Sample() == seeded)
            return;
        seeded = source->Sample();
        state = source->Seed();
    }

  private:
    const SampleSeedSource* source = NULL;
    std::size_t seeded = 0;
};

} // namespace pov

#endif
