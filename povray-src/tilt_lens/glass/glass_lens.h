// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_lens.h
/// A lens of glass.
///
/// Frame: mm, z along the lens's axis towards the scene, origin in the front principal point H; the rear one, H', lies at z = -separation.
///
/// Source: W. J. Smith, Modern Optical Engineering, chapters 2 and 10.

#ifndef TILT_LENS_GLASS_LENS_H
#define TILT_LENS_GLASS_LENS_H

#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "tilt_lens/glass/glass_surface.h"
#include "tilt_lens/glass/prescription.h"
#include "tilt_lens/math/vec3.h"

namespace tilt_lens
{

/// mm.
struct CardinalPoints
{
    double focalLength = 0.0;
    double separation = 0.0;     ///< from H back to H'
    double frontVertex = 0.0;    ///< z
    double rearVertex = 0.0;     ///< z
    double backFocus = 0.0;      ///< last surface to film, focused at infinity
    double entrancePupil = 0.0;  ///< z
    double exitPupil = 0.0;      ///< z; infinite for a telecentric lens
    double exitMagnification = 0.0;  ///< exit pupil's radius over the stop's; infinite with exitPupil
    double fNumber = 0.0;        ///< wide open, by real rays
    double entranceRadius = 0.0; ///< entrance pupil's radius over the stop's; negative if the stop's image is inverted
};

/// All but the f-number.
/// @throws PrescriptionError  a lens that does not collect light
CardinalPoints CardinalPointsOf(const Prescription& prescription);

struct FourGlassRays
{
    double origin[3][4], direction[3][4];
};

enum class Passage
{
    Passed,
    Stopped,
    Rim,        ///< outside a surface's clear opening
    Reflected,
    Missed
};

/// Relative to the stop's radius: right and up as the camera sees it.
struct StopPoint
{
    double a, b;
};

struct FourStopPoints
{
    double a[4], b[4];
};

class GlassLens
{
  public:
    /// The lens wide open.
    /// @throws PrescriptionError  a lens that does not collect light
    explicit GlassLens(const Prescription& prescription);

    const CardinalPoints& Cardinal() const { return cardinal; }
    double StopRadius() const { return stopRadius; }
    double RearRadius() const;

    /// Opens no wider than built.
    void StopDown(double fNumber);

    /// @param opens  false: the stop blocks rays there
    void ShapeStop(std::function<bool(const StopPoint&)> opens) { opening = std::move(opens); }

    /// The prescription must have the same surfaces.
    void TakeIndices(const Prescription& prescription);

    /// @param[in,out] ray  starts behind the lens with direction.z > 0; ends as the ray that leaves the first surface, if it passes
    /// @param[out] stop    set if the ray reaches the stop
    /// @param rims         false: only the stop blocks rays
    Passage Trace(GlassRay& ray, StopPoint& stop, bool rims = true) const;

    /// Each ray has the same result as alone.
    /// @param[in,out] rays  those that do not pass may be NaN
    /// @return              one bit per passing ray, the lowest for the first
    unsigned int Trace(FourGlassRays& rays, FourStopPoints& stop, bool rims = true) const
    {
        return Trace({this, this, this, this}, rays, stop, rims);
    }

    /// One lens for each ray. They differ in indices alone.
    using Four = std::array<const GlassLens*, 4>;
    static unsigned int Trace(const Four& lenses, FourGlassRays& rays, FourStopPoints& stop, bool rims = true);

    /// direction.z < 0.
    Passage TraceFromScene(GlassRay& ray, StopPoint& stop, bool rims = true) const;

    /// Half the width of the first surface's clear opening, least and greatest z.
    struct Front
    {
        double radius, low, high;
    };
    Front FrontBox() const;

  private:
    std::vector<GlassSurface> surfaces;  ///< from film to scene
    std::function<bool(const StopPoint&)> opening;  ///< empty: the whole stop
    CardinalPoints cardinal;
    double stopRadius = 0.0, widestStop = 0.0;

    double WidestRay() const;
    double StopScale() const { return std::copysign(1.0 / stopRadius, cardinal.entranceRadius); }
    bool Opens(const StopPoint& stop) const { return !opening || opening(stop); }
    template<bool towardsScene>
    Passage Cross(const GlassSurface& surface, GlassRay& ray, StopPoint& point, bool rims) const;
    template<bool towardsScene, class Iterator>
    Passage TraceAlong(Iterator first, Iterator end, GlassRay& ray, StopPoint& stop, bool rims) const;
};

} // namespace tilt_lens

#endif
