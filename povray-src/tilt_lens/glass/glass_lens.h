// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file glass_lens.h
/// A lens of glass: its cardinal points by paraxial rays, and real rays through its surfaces by Snell's law.
///
/// Frame: mm, z along the lens's axis towards the scene, origin in the front principal point H. The rear principal point H' lies at
/// z = -separation. An ideal lens is this lens with the space between H and H' taken out, so that everything that holds for an
/// ideal lens at the origin holds for this one with the film moved by the separation along the axis.
///
/// Sources: the paraxial equations and the transfer to a surface without a case for planes are those of W. J. Smith, Modern
/// Optical Engineering, chapters 2 and 10.

#ifndef TILT_LENS_GLASS_LENS_H
#define TILT_LENS_GLASS_LENS_H

#include <cmath>
#include <vector>

#include "tilt_lens/glass/glass_surface.h"
#include "tilt_lens/glass/prescription.h"
#include "tilt_lens/math/vec3.h"

namespace tilt_lens
{

/// The cardinal points and pupils, mm, in the frame of GlassLens.
struct CardinalPoints
{
    double focalLength = 0.0;
    double separation = 0.0;     ///< from H to H', positive where H' is nearer to the film
    double frontVertex = 0.0;    ///< z of the first surface
    double rearVertex = 0.0;     ///< z of the last surface
    double backFocus = 0.0;      ///< from the last surface to the film, focused at infinity
    double entrancePupil = 0.0;  ///< z
    double exitPupil = 0.0;      ///< z; infinite for a telecentric lens
    double exitMagnification = 0.0;  ///< radius of the exit pupil over that of the stop; infinite with exitPupil
    double fNumber = 0.0;        ///< wide open: focal length over the diameter of the widest beam along the axis, by real rays
    double entranceRadius = 0.0; ///< of the entrance pupil over that of the stop; below 0 where the stop is seen upside down
};

/// By rays near the axis; the f-number, which takes real ones, is left out.
/// @throws PrescriptionError  a lens that does not collect light
CardinalPoints CardinalPointsOf(const Prescription& prescription);

/// Four rays side by side.
struct FourGlassRays
{
    double origin[3][4], direction[3][4];
};

/// How a ray ended.
enum class Passage
{
    Passed,
    Stopped,    ///< at the stop
    Rim,        ///< outside a surface's clear opening
    Reflected,  ///< totally, within the glass
    Missed      ///< a surface was not met
};

/// Where rays pass the stop, in parts of its radius: to the right and up as the camera sees it, which for an upside down image
/// of the stop means the other way round.
struct StopPoint
{
    double a, b;
};

/// The same of four rays.
struct FourStopPoints
{
    double a[4], b[4];
};

class GlassLens
{
  public:
    /// Wide open.
    /// @throws PrescriptionError  a lens that does not collect light
    explicit GlassLens(const Prescription& prescription);

    const CardinalPoints& Cardinal() const { return cardinal; }
    double StopRadius() const { return stopRadius; }
    /// Of the last surface's clear opening.
    double RearRadius() const;

    /// Sets the stop so that focal length over diameter of the beam along the axis is this, but never wider than it was made.
    void StopDown(double fNumber);

    /// Takes the indices of refraction of a prescription with the same surfaces; the frame and the cardinal points stay.
    void TakeIndices(const Prescription& prescription);

    /// Follows a ray from the film to the scene.
    /// @param[in,out] ray  begins behind the lens with direction.z > 0; where it passes, it is the ray that leaves the first surface
    /// @param[out] stop    where it passed the stop, if it came that far
    /// @param rims         false: only the stop ends rays
    Passage Trace(GlassRay& ray, StopPoint& stop, bool rims = true) const;

    /// The same for four rays side by side, to the last bit.
    /// @param[in,out] rays  those that do not pass end somewhere, and may be no numbers
    /// @return  a bit for each ray that passes, the lowest for the first
    unsigned int Trace(FourGlassRays& rays, FourStopPoints& stop, bool rims = true) const;

    /// The way back, from the scene to the film: through the same surfaces in the other order, direction.z < 0.
    Passage TraceFromScene(GlassRay& ray, StopPoint& stop, bool rims = true) const;

    /// A box around the first surface's clear opening: half its width, and its least and greatest z.
    struct Front
    {
        double radius, low, high;
    };
    Front FrontBox() const;

  private:
    std::vector<GlassSurface> surfaces;  ///< in order from the film to the scene
    CardinalPoints cardinal;
    double stopRadius = 0.0, widestStop = 0.0;

    double WidestRay() const;
    /// What a height at the stop is multiplied with for a StopPoint.
    double StopScale() const { return std::copysign(1.0 / stopRadius, cardinal.entranceRadius); }
    template<bool towardsScene>
    Passage Cross(const GlassSurface& surface, GlassRay& ray, StopPoint& point, bool rims) const;
};

} // namespace tilt_lens

#endif
