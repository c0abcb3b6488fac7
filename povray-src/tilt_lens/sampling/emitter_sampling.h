// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file emitters.h
/// Rays aimed at small bright objects. A lamp twenty times as bright as white that one ray in a
/// thousand meets is not seen by a pixel's first samples, nor by its neighbours', so that no rule for
/// stopping can miss it less; and where it is seen, nearly all rays of its disc of confusion are in vain.
/// So pixels that such an object may reach send a quarter or half of their rays at it:
///
/// - through the part of the lens that sees it from the film point, where its blur is wide;
/// - from the part of the pixel that it covers, seen from the lens point, where its blur is narrow.
///
/// A sample's light is weighted by the density of plain samples over that of all ways to get the same
/// sample (the balance heuristic), so the mean stays what it is without any emitter, whether the object
/// is hidden, larger, smaller or elsewhere than believed: unbiased.
///
/// Which ray is aimed is decided by the interval in which the sample's first lens coordinate lies; what is
/// left of that coordinate is as well distributed within the interval as it was. Every aligned block of
/// four samples has the same number of aimed ones, so that even light stays even.
///
/// Source: E. Veach, L. J. Guibas, "Optimally combining sampling techniques for Monte Carlo rendering",
/// SIGGRAPH 1995, section 3.2.

#ifndef TILT_LENS_EMITTERS_H
#define TILT_LENS_EMITTERS_H

#include <array>
#include <cstdint>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sampling_limits.h"
#include "tilt_lens/sampling/sequence.h"

namespace tilt_lens
{

/// A sphere around something bright.
struct Emitter
{
    Vec3 centre;    ///< relative to the lens centre, world axes, scene units
    double radius;  ///< scene units
    double light;   ///< of the brightest channel, 1 is white
};

/// Where the ray of a sample starts.
struct CameraSample
{
    double x, y;          ///< film point as in MakeRay
    AperturePoint point;  ///< of the lens
    double weight;        ///< of its light; 0: there is nothing to trace
    double expectedEmission;  ///< as SampleResult has it
};

/// The emitters of a picture. Immutable: threads share it.
class EmitterSampler
{
  public:
    /// How many a pixel aims at, at most: those that bring it most light.
    static constexpr std::size_t kMost = 16;

    /// Keeps those of `all` that are worth aiming at: too small on the film and too bright to be found by chance.
    /// @param width, height  of the whole picture in pixels
    EmitterSampler(const Lens& lens, const Aperture& aperture, const SamplingLimits& limits, std::uint32_t width,
             std::uint32_t height, const std::vector<Emitter>& all);

    bool Empty() const { return kept.empty(); }
    std::size_t Count() const { return kept.size(); }

    /// What one pixel may see.
    struct Targets
    {
        double share = 0.0;  ///< of the samples that are aimed
        double light = 0.0;  ///< that all of them bring to the pixel, if nothing hides them
        struct Target
        {
            std::uint32_t emitter;
            double share;  ///< of all samples
        };
        std::vector<Target> targets;
    };
    Targets TargetsOf(std::uint32_t x, std::uint32_t y) const;

    /// @param targets  of the sample's pixel
    CameraSample Generate(const Targets& targets, const SampleId& id, const Sample& sample) const
    {
        CameraSample start{(id.x + sample.pixelX) / width - 0.5, 0.5 - (id.y + sample.pixelY) / height, {0.0, 0.0}, 1.0, 0.0};
        if (targets.targets.empty() || id.index >= usable)
            start.point = aperture(sample.lensU, sample.lensV);
        else
            AimAtOneOf(targets, id, sample, start);
        return start;
    }

  private:
    struct Box
    {
        double left, right, top, bottom;  ///< pixels
    };
    struct Kept
    {
        Vec3 centre;
        double radius;      ///< scene units
        double reach;       ///< radius of its sharp image, pixels
        double light;       ///< that it brings to a pixel within its disc of confusion, about
        bool throughLens;   ///< the part of the lens is chosen, not that of the pixel
        Box covers;         ///< pixels that may see it
    };
    struct Disc
    {
        AperturePoint centre;
        double radius;
    };

    const Lens lens;
    const Aperture aperture;
    const double width, height;
    std::uint32_t usable;  ///< samples from here on are not aimed: the last block of four is not whole
    std::vector<Kept> kept;
    std::uint32_t block, columns;  ///< side of a block in pixels, blocks in a row
    std::vector<std::vector<std::uint32_t>> blocks;  ///< emitters that each may see, brightest first

    bool FilmPointOf(const Vec3& through, const AperturePoint& point, double& x, double& y) const;
    bool Keep(const Emitter& emitter, double variance);
    Box ReachOf(const Vec3& centre, bool& whole) const;
    void Distribute();
    Disc PartOfLens(const Kept& emitter, double x, double y) const;
    bool Reaches(const Kept& emitter, std::uint32_t x, std::uint32_t y) const;
    void AimAtOneOf(const Targets& targets, const SampleId& id, const Sample& sample, CameraSample& start) const;
    bool AimAt(const Kept& emitter, double u, double v, const SampleId& id, const Sample& sample, CameraSample& start) const;
    double Density(const Kept& emitter, const CameraSample& start) const;
};

} // namespace tilt_lens

#endif
