// povray-tilt-lens: a tilt-shift camera for POV-Ray. Unofficial; not supported by the POV-Ray team.
// SPDX-License-Identifier: AGPL-3.0-or-later

/// @file double_gauss.h
/// A double Gauss of six elements for 50 mm and f/2: pbrt's dgauss.50mm.dat but for the stop's place; US patent 2,673,491 (Tronnier),
/// after Smith, Modern Lens Design. One wavelength, Snell's law, independent of the thin lens.
///
/// z along the axis toward the scene, origin in the front principal point H; H' is at -Separation(). For comparison with a thin lens the
/// film moves back by that much.

#ifndef PAPER_DOUBLE_GAUSS_H
#define PAPER_DOUBLE_GAUSS_H

#include <optional>
#include <vector>

#include "vector.h"

namespace paper
{

using witness::Vector;

struct Ray
{
    Vector origin, direction;  ///< lens frame, mm; direction is a unit vector
};

struct Passage
{
    Ray out;
    double stopX, stopY;  ///< where it passed the stop, in parts of its radius
};

class GlassLens
{
  public:
    /// Mm. `moved`: of the file, between first element and the others, in addition.
    GlassLens(double focalLength, double fStop, double moved = 0.0);

    double FocalLength() const { return mFocalLength; }
    double Separation() const { return mSeparation; }  ///< from H to H', mm, positive toward the film
    double PupilRadius() const { return mPupilRadius; }  ///< of the exit pupil, mm
    double ExitPupil() const { return mExitPupil; }  ///< its z, mm; H' where the stop could be put so
    double EntrancePupil() const { return mEntrancePupil; }  ///< its z, mm

    double PrintedFocalLength() const { return mPrintedFocal; }  ///< of the rows as they are, mm

    /// None where the stop or a rim (unless left out) ends it.
    std::optional<Passage> Trace(const Ray& fromFilm, bool rims = true) const;

  private:
    /// Spherical; scene to film.
    struct Surface
    {
        double z;  ///< of its vertex, mm
        double radius;  ///< mm, positive where its centre lies toward the film
        double before, after;  ///< refractive index on the side of the scene, of the film
        double rim;  ///< radius of its clear opening, mm
    };

    void PlaceStop();

    std::vector<Surface> mSurfaces;
    int mStopAfter = 0;  ///< the stop lies behind this surface
    double mFocalLength = 0.0, mPrintedFocal = 0.0, mSeparation = 0.0;
    double mStopZ = 0.0, mStopRadius = 0.0;
    double mPupilRadius = 0.0, mExitPupil = 0.0, mEntrancePupil = 0.0;
};

} // namespace paper

#endif
