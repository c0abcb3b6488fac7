// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file emitter_sampling.h
/// Importance sampling of small bright objects that first samples would miss: docs/sampling.md, section 4.
///
/// Every aligned block of four samples has equally many emitter samples, so even light stays free of noise.

#ifndef TILT_LENS_EMITTER_SAMPLING_H
#define TILT_LENS_EMITTER_SAMPLING_H

#include <cstdint>
#include <vector>

#include "tilt_lens/samples/lens_sampler.h"
#include "tilt_lens/samples/sampling_limits.h"

namespace tilt_lens
{

struct Emitter
{
    Vec3 centre;  ///< relative to the lens centre, world axes, scene units
    double radius;  ///< scene units
    double radiance;  ///< brightest channel, 1 is white
    double around = 0.0;  ///< possible radiance around it
};

/// Thread-safe, but for Add().
class EmitterSampling
{
  public:
    /// Keeps emitters too small on the film and too bright to be found by chance.
    /// @param plain  must outlive the result
    EmitterSampling(const LensSampler& plain, const SamplingLimits& limits, const std::vector<Emitter>& all);

    /// More emitters, as in the constructor; before the first sample.
    void Add(const SamplingLimits& limits, const std::vector<Emitter>& more);

    struct SharpImage
    {
        double x, y, radius;  ///< pixels
    };
    /// Through the lens centre.
    std::vector<SharpImage> SharpImages() const;
    /// Scene units, at a point relative to the lens centre.
    double SizeOfPixelAt(const Vec3& point) const;

    bool Empty() const { return kept.empty(); }
    std::size_t Count() const { return kept.size(); }
    /// Pixels of the picture that emitters cover with their circles of confusion; those under several count several times.
    double PixelsCovered() const;

    struct Targets
    {
        double share = 0.0;  ///< share of the pixel's samples
        double emission = 0.0;  ///< mean radiance that all add to the pixel unless hidden
        struct Target
        {
            std::uint32_t emitter;
            double share;
        };
        std::vector<Target> targets;
    };
    Targets TargetsOf(std::uint32_t x, std::uint32_t y) const;

    CameraSample Draw(const Targets& targets, const SampleId& id, const SequencePoint& point) const;

    /// @param samples  filled at the run's positions in the group
    void Draw(const Targets& targets, const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

  private:
    struct Box
    {
        double left, right, top, bottom;  ///< pixels
    };
    struct Kept
    {
        Vec3 centre;
        double radius;  ///< scene units
        double imageRadius;  ///< of its sharp image, pixels
        double emission;  ///< about its mean radiance within its circle of confusion
        bool chooseLensPoint;  ///< aims by the lens point; else by the film point
        Box covers;  ///< pixels that may see it
    };
    struct Disc
    {
        AperturePoint centre;
        double radius;
    };

    const LensSampler& plain;
    const Settings settings;
    std::uint32_t usable;  ///< later samples are plain: their block of four is incomplete
    std::vector<Kept> kept;
    std::uint32_t binSide, columns;  ///< a bin's side in pixels, bins in a row
    std::vector<std::vector<std::uint32_t>> bins;  ///< visible emitters, brightest first

    bool PixelPositionOf(const Vec3& through, const AperturePoint& point, double& x, double& y) const;
    bool Keep(const Emitter& emitter, double leastVariance);
    Box BlurBoxOf(const Vec3& centre, bool& whole) const;
    void Distribute();
    Disc PartOfLens(const Kept& emitter, double x, double y) const;
    bool Reaches(const Kept& emitter, std::uint32_t x, std::uint32_t y) const;
    bool Choose(const Targets& targets, const SampleId& id, const SequencePoint& point, CameraSample& sample) const;
    bool Aim(const Kept& emitter, double u, const SampleId& id, const SequencePoint& point, CameraSample& sample) const;
    void Weigh(const Targets& targets, CameraSample& sample) const;
    double Density(const Kept& emitter, const CameraSample& sample) const;
};

} // namespace tilt_lens

#endif
