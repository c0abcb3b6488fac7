// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_view.h
/// What all render threads of a `tilt_lens` picture share: the solved lens, its aperture, the limits
/// of sampling, and the statistics of what was spent.

#ifndef POVRAY_BACKEND_TILT_LENS_VIEW_H
#define POVRAY_BACKEND_TILT_LENS_VIEW_H

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <boost/thread.hpp>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects_around_lens.h"
#include "backend/scene/tilt_lens_aids.h"
#include "base/povmscpp.h"
#include "base/povmsgid.h"
#include "tilt_lens/camera/aperture.h"
#include "tilt_lens/sampling/emitter_sampling.h"
#include "tilt_lens/sampling/tile_sampler.h"
#include "tilt_lens/camera/optics.h"
#include "tilt_lens/glass/glass_camera.h"
#include "tilt_lens/reconstruction/spread.h"
#include "tilt_lens/sampling/progress_estimator.h"

namespace pov
{

class ViewData;

/// Pixels of the whole picture, as the camera library has them.
inline tilt_lens::Area AreaOf(const POVRect& rect)
{
    return {(unsigned int)rect.left, (unsigned int)rect.top, (unsigned int)rect.GetWidth(),
            (unsigned int)rect.GetHeight()};
}

/// What a render cost, as POV-Ray's statistics have it.
struct TiltLensCost
{
    double seconds, cpuSeconds;  ///< of the render threads: the longest, and all together
    double threads;
    double rays;         ///< of all kinds but shadow rays
    double shadowTests;  ///< of an object against a shadow ray
};

class TiltLensView
{
  public:
    /// Beside POV-Ray's tracing methods 0 to 2, which are its kinds of anti-aliasing.
    static const unsigned int kTracingMethod = 3;

    /// Prepares a camera for its render: the shift and the angle of view go into its `direction`.
    /// Returns what the threads share, or NULL where the lens is an ideal pinhole: then POV-Ray's own camera
    /// does all that is left to do.
    /// @param camera  with a solved lens (TiltLensCamera::lens)
    /// @throws std::invalid_argument  a bokeh picture without any light
    static shared_ptr<TiltLensView> Create(Camera& camera, ViewData& view);

    /// What a lens's own vignetting leaves, for the parser, which knows file and line.
    /// @throws tilt_lens::OpticsError  the rim of optical_vignetting leaves (almost) no light in the middle of the picture
    static void RequireLight(const Camera& camera, shared_ptr<SceneData> scene);

    const tilt_lens::Lens lens;
    const tilt_lens::Aperture aperture;
    const tilt_lens::LensFootprint footprint;
    const std::unique_ptr<const tilt_lens::GlassCamera> glass;  ///< what makes the rays of a lens of glass, or NULL
    const tilt_lens::SamplingLimits limits;

    /// Whether samples serve the pixels of their circles of confusion, too, where the picture is denoised: these are those of the
    /// footprint only for a lens that images planes onto planes, to scale, and whose whole opening is seen from everywhere.
    const bool samplesSpread;

    /// Of the pattern of samples.
    const std::uint32_t seed;

    /// The pixels that are being sampled.
    const shared_ptr<tilt_lens::BlockCache> blocks;

    /// Rays from the lens ask no other objects whether they start inside.
    const std::vector<ObjectAroundLens> aroundLens;

    /// Of the scene: what would be asked for each ray if it were not known where the lens is.
    const std::size_t objectsWithInterior;

    /// Small bright objects that pixels send samples at.
    const tilt_lens::EmitterSampler emitters;

    /// How much of the work is done, for the progress display.
    tilt_lens::ProgressEstimator progress;

    /// Pixels that a continued render has already; set before the first tile.
    std::uint64_t pixelsBefore = 0;

    /// What is drawn in place of the lens's picture, or NULL.
    shared_ptr<const TiltLensAids> aids;

    /// Adds the statistics of a finished tile.
    void Add(const tilt_lens::SamplingStatistics& tile);

    /// Puts the share of the work into a message of progress, in per cent, where it is known.
    void AddProgress(POVMS_Object& message) const;

    /// Samples spent and error reached, for the statistics after the render.
    std::string Summary(const TiltLensCost& cost) const;

  private:
    TiltLensView(const Camera& camera, ViewData& view);

    std::string Skipped() const;

    mutable boost::mutex statisticsMutex;
    tilt_lens::SamplingStatistics statistics;
};

/// The numbers of a lens that a photographer checks, one a line, for a picture `width` pixels wide; what the
/// aids draw, if there are any.
/// @param camera  with a solved lens
std::string DescribeTiltLens(const Camera& camera, double width, const TiltLensAids* aids);

} // namespace pov

#endif
