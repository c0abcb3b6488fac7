// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file sample_seeds.h
/// Seeds of random generators whose numbers belong to the sample that is being traced, so that a picture does not depend on
/// what was traced before. Most samples draw no number; a seed is computed when the first one is drawn.

#ifndef POVRAY_BACKEND_SAMPLE_SEEDS_H
#define POVRAY_BACKEND_SAMPLE_SEEDS_H

#include <cstddef>

namespace pov
{

/// Who traces the samples.
class SampleSeedSource
{
  public:
    virtual ~SampleSeedSource() = default;

    /// Of the sample that is being traced.
    virtual unsigned int Seed() const = 0;

    /// Number of the sample that is being traced, from 1; 0 while none is.
    std::size_t Sample() const { return sample; }

  protected:
    void BeginSample() { sample = ++begun; }
    void EndSample() { sample = 0; }

  private:
    std::size_t sample = 0, begun = 0;
};

/// A generator's part: asks for a seed once a sample.
class SampleSeeds
{
  public:
    /// @param itsSource  outlives the generator's last draw
    void Follow(const SampleSeedSource& itsSource) { source = &itsSource; }

    /// To be called before a number is drawn.
    /// @param state  of the generator; is set to the seed of a sample that has drawn none yet
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
    std::size_t seeded = 0;  ///< the last sample that has drawn
};

} // namespace pov

#endif
