// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file emitter_sampling.h
/// Samples sent at small bright objects: docs/sampling.md, section 7. An emitter twenty times as bright as white that one
/// ray in a thousand hits is not seen by a pixel's first samples, nor by its neighbours', so that no stop rule can miss it
/// less; and where it is seen, nearly all rays of its disc of confusion are in vain. So pixels that such an object may reach
/// send half of their samples at it:
///
/// - through the part of the lens that sees it from the film point, where its blur is wide;
/// - from the part of the pixel that it covers, seen from the lens point, where its blur is narrow.
///
/// A sample is weighted by the density of plain samples over that of all ways to get the same sample (the balance heuristic),
/// so the mean stays what it is without any emitter, whether the object is hidden, larger, smaller or elsewhere than
/// believed: unbiased.
///
/// Which sample is sent at an emitter is decided by the interval in which its first lens coordinate lies; what is left of
/// that coordinate is as well distributed within the interval as it was. Every aligned block of four samples has the same
/// number of emitter samples, so that even light stays even.
///
/// Source: E. Veach, L. J. Guibas, "Optimally combining sampling techniques for Monte Carlo rendering",
/// SIGGRAPH 1995, section 3.2.

#ifndef TILT_LENS_EMITTER_SAMPLING_H
#define TILT_LENS_EMITTER_SAMPLING_H

#include <cstdint>
#include <vector>

#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/camera/ray.h"
#include "tilt_lens/camera/vignetting.h"
#include "tilt_lens/sampling/sample.h"
#include "tilt_lens/sampling/sampling_limits.h"
#include "tilt_lens/sampling/sequence.h"

namespace tilt_lens
{

/// A sphere around something bright.
struct Emitter
{
    Vec3 centre;      ///< relative to the lens centre, world axes, scene units
    double radius;    ///< scene units
    double radiance;  ///< of the brightest channel, 1 is white
    double around = 0.0;  ///< radiance that what lies around it may have
};

/// Where the ray of a sample begins.
struct CameraSample
{
    double x, y;              ///< film point as in MakeRay
    AperturePoint point;      ///< of the lens
    double weight;            ///< of its radiance; 0: there is nothing to trace
    double expectedEmission;  ///< as SampleResult has it
};

/// The same of a group of samples, side by side.
struct CameraSamples
{
    OfGroup x, y, a, b, weight, expectedEmission;

    CameraSample operator[](std::uint32_t i) const { return {x[i], y[i], {a[i], b[i]}, weight[i], expectedEmission[i]}; }
    void Put(std::uint32_t i, const CameraSample& sample)
    {
        x[i] = sample.x, y[i] = sample.y, a[i] = sample.point.a, b[i] = sample.point.b;
        weight[i] = sample.weight, expectedEmission[i] = sample.expectedEmission;
    }
};

/// The emitters of a picture. Immutable: threads share it.
class EmitterSampler
{
  public:
    /// Keeps those of `all` that are worth samples: too small on the film and too bright to be found by chance.
    /// @param width, height  of the whole picture in pixels
    EmitterSampler(const Lens& lens, const Aperture& aperture, const SamplingLimits& limits, std::uint32_t width,
                   std::uint32_t height, const std::vector<Emitter>& all, const Vignetting& vignetting = {});

    bool Empty() const { return kept.empty(); }
    std::size_t Count() const { return kept.size(); }

    /// The emitters that one pixel's samples are sent at.
    struct Targets
    {
        double share = 0.0;     ///< of the pixel's samples
        double emission = 0.0;  ///< that all of them bring to the pixel, if nothing hides them
        struct Target
        {
            std::uint32_t emitter;
            double share;  ///< of all samples
        };
        std::vector<Target> targets;
    };
    Targets TargetsOf(std::uint32_t x, std::uint32_t y) const;

    /// @param targets  of the sample's pixel
    /// @param point    of the pixel's sequence
    CameraSample Generate(const Targets& targets, const SampleId& id, const SequencePoint& point) const
    {
        const FilmPoint film = FilmPointAt(id.x + point.pixelX, id.y + point.pixelY, width, height);
        CameraSample sample{film.x, film.y, {0.0, 0.0}, 1.0, 0.0};
        if (!targets.targets.empty() && id.index < usable)
            SampleEmitters(targets, id, point, sample);
        else if (vignetting.None())
            sample.point = aperture(point.lensU, point.lensV);
        else
            sample.weight = vignetting.DrawPoint(aperture, film, point.lensU, point.lensV, SeedOf(id), sample.point);
        return sample;
    }

    /// Of plain samples of a group all but their lens points.
    /// @param points   of the group
    /// @param samples  takes them at their places in the group
    void BeginSamples(const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

    /// Generate() for some samples of a group.
    /// @param points   of the group
    /// @param samples  takes them at their places in the group
    void Generate(const Targets& targets, const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;

  private:
    struct Box
    {
        double left, right, top, bottom;  ///< pixels
    };
    struct Kept
    {
        Vec3 centre;
        double radius;         ///< scene units
        double imageRadius;    ///< of its sharp image, pixels
        double emission;       ///< that it brings to a pixel within its disc of confusion, about
        bool chooseLensPoint;  ///< the part of the lens is chosen, not that of the pixel
        Box covers;            ///< pixels that may see it
    };
    struct Disc
    {
        AperturePoint centre;
        double radius;
    };

    const Lens lens;
    const Aperture aperture;
    const Vignetting vignetting;
    const double width, height;
    std::uint32_t usable;  ///< samples from here on are not sent at emitters: the last block of four is not whole
    std::vector<Kept> kept;
    std::uint32_t binSide, columns;  ///< side of a bin in pixels, bins in a row
    std::vector<std::vector<std::uint32_t>> bins;  ///< emitters that each may see, brightest first

    /// Of the random numbers that a covered lens point is replaced with: others than those that the sample's ray draws.
    static std::uint32_t SeedOf(const SampleId& id) { return PixelHash(id.x, id.y, 0x52696d, id.index); }

    bool PixelPositionOf(const Vec3& through, const AperturePoint& point, double& x, double& y) const;
    bool Keep(const Emitter& emitter, double leastVariance);
    Box BlurBoxOf(const Vec3& centre, bool& whole) const;
    void Distribute();
    Disc PartOfLens(const Kept& emitter, double x, double y) const;
    bool Reaches(const Kept& emitter, std::uint32_t x, std::uint32_t y) const;
    void GenerateOneByOne(const Targets& targets, const SampleRun& run, const SequencePoints& points, CameraSamples& samples) const;
    void SampleEmitters(const Targets& targets, const SampleId& id, const SequencePoint& point, CameraSample& sample) const;
    bool SampleOne(const Kept& emitter, double u, double v, const SampleId& id, const SequencePoint& point,
                   CameraSample& sample) const;
    double Density(const Kept& emitter, const CameraSample& sample) const;
};

} // namespace tilt_lens

#endif
