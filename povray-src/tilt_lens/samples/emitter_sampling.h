// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file emitter_sampling.h
/// Importance sampling of small bright objects that first samples would miss: docs/sampling.md, section 4.
///
/// Every aligned block of four samples has equally many emitter samples, so even light stays free of noise.

#ifndef TILT_LENS_EMITTER_SAMPLING_H
#define TILT_LENS_EMITTER_SAMPLING_H

#include <cstdint>
#include <memory>
#include <vector>

#include "tilt_lens/lens_camera/glass_sight.h"
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
            std::vector<GlassSight::Cells> cells{};  ///< with a lens of glass, by thirds of the spectrum
        };
        std::vector<Target> targets;
    };
    Targets TargetsOf(std::uint32_t x, std::uint32_t y) const;

    CameraSample Draw(const Targets& targets, const SampleId& id, const SequencePoint& point) const;

    /// @name Through a lens of glass, whose rays the camera draws
    /// @{
    struct Choice
    {
        double u, v;                    ///< lens coordinates of a plain sample, or the point of the pupil
        bool aimed;
        double expectedEmission = 0.0;  ///< as in SampleResult
    };
    Choice Choose(const Targets& targets, const FilmPoint& film, double u, double v, double hue) const;

    /// Weight of a sample over that of a plain one.
    double OverPlain(const Targets& targets, const FilmPoint& film, const AperturePoint& pupil, double hue) const;

    /// Later samples are plain: their block of four is incomplete.
    bool MayAim(const Targets& targets, std::uint32_t index) const { return !targets.targets.empty() && index < usable; }
    /// @}

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
        std::shared_ptr<const GlassSight> sight;  ///< null: a thin lens
    };
    struct Disc
    {
        AperturePoint centre;
        double radius;
    };

    const LensSampler& plain;
    const Settings settings;
    std::uint32_t usable;  ///< for MayAim()
    std::vector<Kept> kept;
    std::uint32_t binSide, columns;  ///< a bin's side in pixels, bins in a row
    std::vector<std::vector<std::uint32_t>> bins;  ///< visible emitters, brightest first

    bool PixelPositionOf(const Vec3& through, const AperturePoint& point, double& x, double& y) const;
    bool Keep(const Emitter& emitter, double leastVariance);
    bool MeetsFrame(const Box& box, double margin) const;
    Box PixelsOf(const FilmBox& film) const;
    Box BlurBoxOf(const Vec3& centre, bool& whole) const;
    void Distribute();
    Disc PartOfLens(const Kept& emitter, double x, double y) const;
    bool Reaches(const Kept& emitter, std::uint32_t x, std::uint32_t y) const;
    const GlassSight::Cells& CellsAt(const Targets::Target& target, const FilmPoint& film, double hue, GlassSight::Cells& some) const;
    bool FindCells(std::uint32_t x, std::uint32_t y, Targets::Target& target) const;
    const Targets::Target* TargetOf(const Targets& targets, double& u) const;
    bool Choose(const Targets& targets, const SampleId& id, const SequencePoint& point, CameraSample& sample) const;
    bool Aim(const Kept& emitter, double u, const SampleId& id, const SequencePoint& point, CameraSample& sample) const;
    void Weigh(const Targets& targets, CameraSample& sample) const;
    double Density(const Kept& emitter, const CameraSample& sample) const;
};

} // namespace tilt_lens

#endif
