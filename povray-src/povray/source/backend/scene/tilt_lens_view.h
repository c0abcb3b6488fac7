// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file tilt_lens_view.h
/// Data shared by all render threads of a `tilt_lens` picture.

#ifndef POVRAY_BACKEND_TILT_LENS_VIEW_H
#define POVRAY_BACKEND_TILT_LENS_VIEW_H

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <boost/thread.hpp>

#include "backend/frame.h"
#include "backend/scene/camera.h"
#include "backend/scene/objects_around_lens.h"
#include "backend/scene/tilt_lens_aids.h"
#include "base/povmscpp.h"
#include "base/povmsgid.h"
#include "tilt_lens/budget/progress_estimator.h"
#include "tilt_lens/samples/sampled_camera.h"
#include "tilt_lens/stop_rule/block_cache.h"
#include "tilt_lens/stop_rule/sampling_statistics.h"

namespace tilt_lens
{
class BudgetPilot;
class LampSearch;
}  // namespace tilt_lens

namespace pov
{

class ViewData;

inline tilt_lens::Area AreaOf(const POVRect& rect)
{
    return {(unsigned int)rect.left, (unsigned int)rect.top, (unsigned int)rect.GetWidth(), (unsigned int)rect.GetHeight()};
}

class TiltLensView
{
  public:
    /// POV-Ray uses 0 to 2.
    static const unsigned int kTracingMethod = 3;

    /// Shift and angle of view enter the camera's `direction`.
    /// @param camera  with a solved lens
    /// @return        NULL for an ideal pinhole
    /// @throws std::invalid_argument  a bokeh picture without light
    static shared_ptr<TiltLensView> Create(Camera& camera, ViewData& view);

    /// @throws tilt_lens::OpticsError  optical_vignetting leaves at most 1 per cent of the light in the middle
    static void RequireLight(const Camera& camera, shared_ptr<SceneData> scene);

    /// @throws tilt_lens::OpticsError  `budget` does not suffice for the first round of samples
    static void RequireBudget(const Camera& camera, shared_ptr<SceneData> scene);

    /// The search completes its emitters.
    tilt_lens::SampledCamera camera;

    /// NULL where all lamps are known from the scene's objects.
    shared_ptr<tilt_lens::LampSearch> search;

    /// Chooses the variance for `budget`; else NULL. Call after the search.
    tilt_lens::BudgetPilot* Pilot();
    shared_ptr<tilt_lens::BudgetPilot> pilot;

    /// Call after the pilot.
    const tilt_lens::SamplingLimits& Limits() const;

    /// Call after the pilot.
    tilt_lens::BlockCache& Blocks();

    const std::vector<ObjectAroundLens> aroundLens;

    const std::size_t objectsWithInterior;

    tilt_lens::ProgressEstimator progress;

    /// Pixels of a continued render; set before the first tile.
    std::uint64_t pixelsBefore = 0;

    /// May be NULL.
    shared_ptr<const TiltLensAids> aids;

    /// @name Statistics of all tiles. Thread-safe.
    /// @{
    void Add(const tilt_lens::SamplingStatistics& tile);
    tilt_lens::SamplingStatistics Statistics() const;
    /// @}

    void AddProgress(POVMS_Object& message) const;

    /// Shows a line of progress before the first tile, if it is new. Thread-safe.
    void ShowProgress(ViewData& view, const std::function<std::string()>& text);

  private:
    TiltLensView(const Camera& camera, ViewData& view, const std::vector<tilt_lens::Emitter>& emitters);

    const unsigned int width, height;
    const tilt_lens::Area rendered;
    const double budget;  ///< rays of a pixel; 0: none
    boost::mutex pilotMutex;
    boost::mutex blocksMutex;
    shared_ptr<tilt_lens::BlockCache> blocks;

    boost::mutex shownMutex;
    std::string shown;

    mutable boost::mutex statisticsMutex;
    tilt_lens::SamplingStatistics statistics;
};

} // namespace pov

#endif
