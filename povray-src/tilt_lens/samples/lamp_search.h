// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file lamp_search.h
/// Finds small lamps that no list of objects tells, such as windows of an `image_map` or lamps behind a pane, in a sharp picture of the
/// scene: docs/sampling.md, section 4. Samples are then aimed at them as at other emitters.

#ifndef TILT_LENS_LAMP_SEARCH_H
#define TILT_LENS_LAMP_SEARCH_H

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "tilt_lens/samples/bright_cells.h"
#include "tilt_lens/samples/sample_tracer.h"
#include "tilt_lens/samples/shared_tasks.h"

namespace tilt_lens
{

/// Thread-safe. Lamps depend on scene, camera and picture size alone, never on threads or the rendered part.
class LampSearch
{
  public:
    /// @param camera         gets the lamps, before its first sample; must outlive the search
    /// @param width, height  whole picture, pixels
    /// @param mostRays       for each pixel of the picture
    LampSearch(SampledCamera& camera, std::uint32_t width, std::uint32_t height, double mostRays);

    /// Waits for other threads if necessary; none once the camera has the lamps.
    std::optional<std::size_t> NextRow() { return tasks.Next(); }
    /// If the ray tracer throws, another thread gets the row.
    void Take(std::size_t row, RayTracer& rayTracer);
    /// A round is a picture.
    TaskProgress Progress() const { return tasks.Progress(); }

    /// @name After the last row
    /// @{
    std::size_t Rays() const { return rays; }
    double RaysOfPixel() const { return rays / (width * height); }
    std::size_t Lamps() const { return lamps; }  ///< at which samples are aimed
    /// @}

  private:
    struct CellRay
    {
        FilmPoint film;
        LensRay ray;  ///< through the lens centre
    };
    using Places = BrightCells::Places;

    SampledCamera& camera;
    const double width, height;
    const double margin;  ///< pixels around the picture
    double side, fine;  ///< of the present cells, and of the last ones; pixels
    BrightCells cells;
    SharedTasks tasks;  ///< rows of cells, coarse ones first
    std::size_t rays = 0, lamps = 0;

    void Begin(double itsSide);
    void MarkKnown();
    PixelSampler SamplerOf(std::size_t place) const;
    CellRay RayOf(std::size_t place) const;
    Vec3 PointOf(std::size_t place) const;
    std::size_t BlurOf(std::size_t place) const;
    bool AllKnown(const Places& part) const;
    Emitter LampOf(const Places& part) const;
    std::vector<Emitter> Found() const;
    void End();
};

}  // namespace tilt_lens

#endif
